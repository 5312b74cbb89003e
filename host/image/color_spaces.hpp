#pragma once

#include <glm/vec3.hpp>

namespace lavaray {

// Colour spaces in which distances correspond to perception. Linear colours are RGB with sRGB primaries and
// D65 white, from 0 to 1.

// Decodes one channel of sRGB, from 0 to 1 (IEC 61966-2-1).
float linearFromSrgb(float encoded);
// The same in double precision, and its inverse; values beyond 0 and 1 continue along the same curves.
double linearFromSrgb(double encoded);
double srgbFromLinear(double linear);

// Luminance, red against green and blue against yellow, each a difference of tristimulus values relative to
// white: the YCxCz space without its factors and offset, which no linear filter needs.
glm::vec3 opponentFromLinear(const glm::vec3& linear);
glm::vec3 linearFromOpponent(const glm::vec3& opponent);

// CIE L*a*b*, with L* from 0 to 100.
glm::vec3 labFromLinear(const glm::vec3& linear);

}  // namespace lavaray
