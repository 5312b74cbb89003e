#pragma once

#include <optional>

#include "base/rectangle.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The size in pixels that the camera asks for: H = trunc(2 f tan(fov / 2)), W = trunc(aspect H). Nothing
// where a side has no pixel or more than kMaxImageSide.
std::optional<ImageSize> imageSize(const Camera& camera);

}  // namespace lavaray
