// A point of a surface as a path sees it.
#ifndef SHADING_POINT_GLSL
#define SHADING_POINT_GLSL

#include "shade.glsl"

struct ShadingPoint {
  SurfacePoint at;
  uint surface;  // that the point is on, which its shadow rays skip; kNoSurface where there is no point
  Material material;
  vec3 toViewer;  // unit length
  vec3 weight;    // of what the point shows in the path's colour
};

bool isThere(ShadingPoint point) {
  return point.surface != kNoSurface;
}

#endif
