#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace lavaray {

// The colour for a value from 0 to 1: black, blue, crimson, orange, yellow, white. Every fifth of the scale
// adds about the same lightness, so the order of values stays visible in greyscale print and to the
// colour-blind.
glm::vec3 falseColor(float value);

// Replaces pixels whose three channels are equal with the colours for their values.
void applyFalseColors(std::span<float> rgb);

}  // namespace lavaray
