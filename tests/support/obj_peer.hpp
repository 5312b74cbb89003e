#pragma once

#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace lavaray {

// tinyobjloader as a second reader of OBJ texts.

// Whether it can be held against ours: the text has nothing but plain statements, since it reads some others
// wrongly without a word (`1//`, a coordinate in a continued line).
bool isPlainObj(std::string_view text);

// What is otherwise in the mesh that ours has read of a plain text; empty where nothing is. Numbers may be
// off by some units in the last place, as tinyobjloader adds up decimal digits one by one.
std::string differenceFromTinyobjloader(const std::string& text, const Mesh& mesh);

}  // namespace lavaray
