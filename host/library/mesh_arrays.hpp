#pragma once

#include <lavaray/scene.h>

#include "scene/scene.hpp"

namespace lavaray {

// The mesh of the arrays, its degenerate triangles dropped. Throws Error(kInput) saying which number is out
// of range.
Mesh meshOf(const v0::Mesh& arrays);

}  // namespace lavaray
