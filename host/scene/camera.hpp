#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "base/rectangle.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The size in pixels that the camera asks for: H = trunc(2 f tan(fov / 2)), W = trunc(aspect H). Empty if a
// side has no pixel or more than kMaxImageSide.
std::optional<ImageSize> imageSize(const Camera& camera);

// The rectangle in front of the camera through which the image is seen: centred on the optical axis,
// perpendicular to it. Its unit is the camera's own pixel, whatever the size of the image that is rendered.
struct ImagePlane {
  glm::dvec2 size;  // imageSize(camera)
  double distance;  // the focal length
  bool operator==(const ImagePlane&) const = default;
};

// The camera must have an imageSize.
ImagePlane imagePlane(const Camera& camera);

}  // namespace lavaray
