#pragma once

#include <glm/vec3.hpp>

namespace lavaray {

// Colour spaces in which distances mean something to the eye. Linear colours are RGB in the sRGB primaries
// with D65 white, 0 to 1.

// One channel of sRGB, 0 to 1, decoded (IEC 61966-2-1).
float linearFromSrgb(float encoded);
// Likewise, and back; values beyond 0 and 1 go on along the same curves.
double linearFromSrgb(double encoded);
double srgbFromLinear(double linear);

// Luminance, red against green and blue against yellow, each a difference of tristimulus values relative to
// white: the YCxCz space without its factors and offset, which no linear filter needs.
glm::vec3 opponentFromLinear(const glm::vec3& linear);
glm::vec3 linearFromOpponent(const glm::vec3& opponent);

// CIE L*a*b*; L* is 0 to 100.
glm::vec3 labFromLinear(const glm::vec3& linear);

}  // namespace lavaray
