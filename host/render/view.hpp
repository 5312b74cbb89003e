#pragma once

#include <optional>
#include <string>

#include <lavaray/types.h>
#include <glm/vec3.hpp>

#include "interface.h"

namespace lavaray {

using v0::kViewNames;
using v0::View;

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
