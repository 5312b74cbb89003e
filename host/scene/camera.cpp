#include "scene/camera.hpp"

#include <cmath>
#include <numbers>

#include "base/limits.hpp"

namespace lavaray {

std::optional<ImageSize> imageSize(const Camera& camera) {
  // Without the guard, tan(45 degrees) = 0.99999999999999989 would cost the image of a round f its last row.
  constexpr double kGuard = 1e-6;
  const double halfFov = camera.fovDegrees * std::numbers::pi / 360.0;
  const double height = std::trunc(2.0 * camera.focalLength * std::tan(halfFov) + kGuard);
  const double width = std::trunc(camera.aspect * height + kGuard);
  const auto isSide = [](double pixels) { return pixels >= 1.0 && pixels <= kMaxImageSide; };
  if (!isSide(width) || !isSide(height)) return std::nullopt;
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

ImagePlane imagePlane(const Camera& camera) {
  const ImageSize size = imageSize(camera).value();
  return {glm::dvec2(size.width, size.height), camera.focalLength};
}

}  // namespace lavaray
