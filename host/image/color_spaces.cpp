#include "image/color_spaces.hpp"

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace lavaray {
namespace {

glm::dvec3 tristimulus(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

// Maps a linear colour to its tristimulus values relative to those of white. Derived from the chromaticities
// of the primaries (ITU-R BT.709) and of D65 (CIE 15), so that (1, 1, 1) maps to (1, 1, 1).
glm::dmat3 relativeTristimulusFromLinear() {
  const glm::dvec3 white = tristimulus(0.31271, 0.32902);
  const glm::dmat3 primaries(tristimulus(0.64, 0.33), tristimulus(0.30, 0.60), tristimulus(0.15, 0.06));
  const glm::dvec3 strengths = glm::inverse(primaries) * white;
  glm::dmat3 result;
  for (int i = 0; i < 3; ++i) result[i] = strengths[i] * primaries[i] / white;
  return result;
}

const glm::mat3 kTristimulusFromLinear(relativeTristimulusFromLinear());
const glm::mat3 kLinearFromTristimulus(glm::inverse(relativeTristimulusFromLinear()));

// The encoded value where the straight line near 0 ends.
constexpr double kLineEnd = 0.04045;

template <typename Number>
Number decoded(Number encoded) {
  if (encoded <= static_cast<Number>(kLineEnd)) return encoded / static_cast<Number>(12.92);
  return std::pow((encoded + static_cast<Number>(0.055)) / static_cast<Number>(1.055),
                  static_cast<Number>(2.4));
}

// The cube root, but a straight line near 0, where the root has no finite derivative.
float labRoot(float t) {
  constexpr float kDelta = 6.0F / 29.0F;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
}

}  // namespace

float linearFromSrgb(float encoded) {
  return decoded(encoded);
}

double linearFromSrgb(double encoded) {
  return decoded(encoded);
}

double srgbFromLinear(double linear) {
  return linear <= kLineEnd / 12.92 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

glm::vec3 opponentFromLinear(const glm::vec3& linear) {
  const glm::vec3 relative = kTristimulusFromLinear * linear;
  return {relative.y, relative.x - relative.y, relative.y - relative.z};
}

glm::vec3 linearFromOpponent(const glm::vec3& opponent) {
  return kLinearFromTristimulus * glm::vec3(opponent.x + opponent.y, opponent.x, opponent.x - opponent.z);
}

glm::vec3 labFromLinear(const glm::vec3& linear) {
  const glm::vec3 relative = kTristimulusFromLinear * linear;
  const glm::vec3 root(labRoot(relative.x), labRoot(relative.y), labRoot(relative.z));
  return {116.0F * root.y - 16.0F, 500.0F * (root.x - root.y), 200.0F * (root.y - root.z)};
}

}  // namespace lavaray
