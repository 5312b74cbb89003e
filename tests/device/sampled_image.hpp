#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// What the tests of sampled images share.

// A scene of the folder `scenes`.
Scene readNamed(const std::string& name);

// The whole image with so many samples a pixel.
RenderSettings settingsFor(const ImageSize& size, std::uint32_t samples);

// A new object's material and number.
std::uint32_t addObject(Scene& scene, const Material& material);

// The parallelogram with the corners a, b, c and a + c - b, of two triangles.
void addParallelogram(Scene& scene, const Material& material, const glm::dvec3& a, const glm::dvec3& b,
                      const glm::dvec3& c);

// Shows the colour, whatever the lights.
Material glow(const glm::dvec3& color);

bool sameBits(const Image& a, const Image& b);

// `truth` has a value for each channel of each pixel.
double rmse(const Image& image, const std::vector<double>& truth);

// Slope of log error against log samples, least squares.
double fittedSlope(const std::vector<double>& samples, const std::vector<double>& errors);

}  // namespace lavaray
