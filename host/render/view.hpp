#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "interface.h"

namespace lavaray {

// What a picture shows.
enum class View {
  kColor,
  kNormal,   // n / 2 + 1/2 for the unit normal n used for shading
  kDepth,    // distance from the camera, relative to the largest
  kObject,   // a colour for each object
  kShadow,   // share of the lights that are not blocked
  kCost,     // nodes and primitives that rays are tested against, relative to the largest number
  kSamples,  // samples of each pixel, relative to the largest number
  kError,    // estimated error of each pixel, in units of a colour; needs a target error
};

inline constexpr const char* kViewNames = "color, normal, depth, object, shadow, cost, samples, error";

std::optional<View> viewNamed(const std::string& name);
std::string viewName(View view);

// What the shader sums up for the view, a value of gpu::kSpecView.
gpu::uint tracedView(View view);
bool tracesLights(View view);
bool tracesMirrors(View view);

// Whether the view shows a measure that has no upper bound, so that the largest value of the whole picture is
// needed to bring it into [0, 1]; and a pixel's measure, from the sum of what the shader returned for its
// samples.
bool isMeasure(View view);
double measure(View view, const glm::dvec3& sum, std::uint32_t samples);

}  // namespace lavaray
