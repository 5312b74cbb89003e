#pragma once

#include <optional>

#include "core/scene.hpp"

namespace lavaray {

struct ImageSize {
  int width = 0;
  int height = 0;
  bool operator==(const ImageSize&) const = default;
};

// The size in pixels that the camera asks for: H = trunc(2 f tan(fov / 2)), W = trunc(aspect H). Nothing
// where a side has no pixel or more than kMaxImageSide.
std::optional<ImageSize> imageSize(const Camera& camera);

}  // namespace lavaray
