#include "image/false_color.hpp"

#include <algorithm>
#include <array>

namespace lavaray {
namespace {

// As sRGB. Their lightness L* is 0, 23, 42, 63, 82 and 100.
constexpr std::size_t kIntervals = 5;
const std::array<glm::vec3, kIntervals + 1> kColors = {glm::vec3(0.0F),       {0.20F, 0.12F, 0.58F},
                                                       {0.74F, 0.12F, 0.40F}, {0.95F, 0.45F, 0.10F},
                                                       {0.98F, 0.77F, 0.22F}, glm::vec3(1.0F)};

}  // namespace

glm::vec3 falseColor(float value) {
  const float position = std::clamp(value, 0.0F, 1.0F) * kIntervals;
  const std::size_t interval = std::min(static_cast<std::size_t>(position), kIntervals - 1);
  const float share = position - static_cast<float>(interval);
  return kColors[interval] * (1.0F - share) + kColors[interval + 1] * share;
}

void applyFalseColors(std::span<float> rgb) {
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const glm::vec3 color = falseColor(rgb[i]);
    std::copy_n(&color.x, 3, &rgb[i]);
  }
}

}  // namespace lavaray
