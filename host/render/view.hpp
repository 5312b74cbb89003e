#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "interface.h"

namespace lavaray {

// What an image shows.
enum class View {
  kColor,
  kNormal,   // n / 2 + 1/2 for the unit normal n that is shaded with
  kDepth,    // distance from the camera, in proportion to the largest
  kObject,   // a colour for each object
  kShadow,   // share of the lights that are not blocked
  kCost,     // nodes and primitives that rays are tested against, in proportion to the most
  kSamples,  // samples of each pixel, in proportion to the most
  kError,    // estimated error of each pixel, in units of a colour; needs a target error
};

inline constexpr const char* kViewNames = "color, normal, depth, object, shadow, cost, samples, error";

std::optional<View> viewNamed(const std::string& name);
std::string viewName(View view);

// What the shader sums up for the view, a value of gpu::kSpecView.
gpu::uint tracedView(View view);
bool tracesLights(View view);
bool tracesMirrors(View view);

// Whether the view shows a measure without an upper bound, which only the whole image's largest value brings
// into [0, 1], and that of a pixel by the sum of what the shader returned for so many samples.
bool isMeasure(View view);
double measure(View view, const glm::dvec3& sum, std::uint32_t samples);

}  // namespace lavaray
