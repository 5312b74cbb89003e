#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>

// The forms in which exporters write a mesh's faces; each mesh has 2 million triangles.
inline constexpr std::array<std::string_view, 4> kForms{"v/vt/vn", "negative", "v", "quads"};

// Writes a bumpy torus in one of these forms. All but `v` have texture coordinates and normals, and name them
// at each corner.
void writeMesh(std::string_view form, std::ostream& out);
