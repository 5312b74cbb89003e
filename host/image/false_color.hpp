#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace lavaray {

// A colour for a value from 0 to 1: black, blue, crimson, orange, yellow, white. Each fifth of the scale is
// about as much lighter as any other, so the order of values can be seen, in grey print and by the
// colour-blind, too.
glm::vec3 falseColor(float value);

// Of pixels whose three channels are equal.
void applyFalseColors(std::span<float> rgb);

}  // namespace lavaray
