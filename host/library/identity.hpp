#pragma once

#include "film/film_file.hpp"
#include "library/scene_state.hpp"
#include "render/settings.hpp"

namespace lavaray {

// All that decides a picture's pixels: checksums of the scene, its meshes and the shader, and every option
// that matters. Throws Error(kInput) if a file can no longer be read.
Identity describeIdentity(const v0::Scene::State& scene, const RenderSettings& settings);

// Throws Error(kInput) naming what differs between a film and the render that is to resume from it: scene,
// options, crop, samples.
void checkSame(const FilmReader& film, const Identity& identity, const RenderSettings& settings);

}  // namespace lavaray
