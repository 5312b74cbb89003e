#pragma once

#include <string>

#include "support/scene_building.hpp"

namespace lavaray {

// A scene file that tries to break its reader or the renderer, and the mesh that it names.
struct SceneText {
  std::string scene;
  std::string mesh;  // to be written as mesh.obj next to it
};

// How many kinds of scenes there are: what they hold, not where and how. Few, since each is a pipeline of its
// own.
inline constexpr int kSceneKinds = 12;

// A scene of the kind whose numbers are all fine, or one in which any number may be zero, negative, huge,
// denormal, not a number or none at all, and things stand in, on and inside one another.
SceneText makeSceneText(int kind, bool hostile, Random& random);

}  // namespace lavaray
