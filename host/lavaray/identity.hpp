#pragma once

#include <span>

#include "film/film.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/options.hpp"
#include "render/settings.hpp"

namespace lavaray {

// All that decides this picture's pixels: checksums of the scene, its meshes and the shader, and every option
// that matters. Throws Error(kInput) if a file can no longer be read.
Identity describeIdentity(const Options& options, const Inputs& inputs, const RenderSettings& settings);

}  // namespace lavaray
