#pragma once

#include <span>

#include "film/film.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/options.hpp"
#include "render/settings.hpp"

namespace lavaray {

// What decides the pixels of this picture: checksums of the scene, its meshes and the shader, and every
// option that matters. Throws Error(kInput) where a file cannot be read any more.
Identity describeIdentity(const Options& options, const Inputs& inputs, const RenderSettings& settings);

}  // namespace lavaray
