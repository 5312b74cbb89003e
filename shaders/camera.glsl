// The pinhole camera: it sits in the origin (see GpuScene) and looks down -z with +y up.
#ifndef CAMERA_GLSL
#define CAMERA_GLSL

// Direction, of any length, to a position on the image plane: (0, 0) is its top left corner and
// (2 halfImage.x, 2 halfImage.y) its bottom right one, in units of the scene's own pixels. It is not
// normalised because it is exact as it is.
vec3 cameraDirection(vec2 position, vec2 halfImage, float focalLength) {
  return vec3(position.x - halfImage.x, halfImage.y - position.y, -focalLength);
}

#endif
