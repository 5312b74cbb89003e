#pragma once

#include <lavaray/renderer.h>

#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The size that the options ask for: the camera's, or where only one side is given, that with the other by
// the camera's aspect. Throws Error(kUsage) if a side is out of range.
ImageSize outputSize(const v0::RenderOptions& options, const ImageSize& cameraSize);

// What a job renders, and the part of it that its picture shows: where stretching needs all values, not all
// is shown.
struct RenderPlan {
  RenderSettings settings;
  Rectangle part;
};

// Throws Error(kUsage) if an option is out of range.
RenderPlan planFor(const v0::RenderOptions& options, const Scene& scene);

// A crop shows what the whole picture would show there, so stretching needs the largest value of the whole.
bool needsWhole(const v0::RenderOptions& options);

}  // namespace lavaray
