#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>

// The forms of a mesh's faces that exporters write, of 2 million triangles each.
inline constexpr std::array<std::string_view, 4> kForms{"v/vt/vn", "negative", "v", "quads"};

// Writes a torus with bumps in one of these forms. All have vertices; all but `v` have texture coordinates
// and normals, too, and name them at each corner.
void writeMesh(std::string_view form, std::ostream& out);
