// What tools/bench-obj measures, one process per load: `obj-bench READER FILE` loads the file and prints its
// number of triangles; `obj-bench write FORM FILE` makes it.
#include <algorithm>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <tiny_obj_loader.h>

#include "forms.hpp"
#include "scene/obj_reader.hpp"

namespace {

std::size_t loadWithTinyobjloader(const std::string& file) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, file.c_str()))
    throw std::runtime_error(error);
  std::size_t triangles = 0;
  for (const tinyobj::shape_t& shape : shapes) triangles += shape.mesh.num_face_vertices.size();
  return triangles;
}

void run(std::span<const std::string> arguments) {
  if (arguments.size() == 3 && arguments[0] == "write" &&
      std::ranges::find(kForms, arguments[1]) != kForms.end()) {
    std::ofstream out(arguments[2], std::ios::binary);
    writeMesh(arguments[1], out);
    if (!out.flush()) throw std::runtime_error(arguments[2] + ": cannot be written");
  } else if (arguments.size() == 2 && arguments[0] == "lavaray") {
    std::cout << lavaray::readObj(arguments[1]).triangles.size() << '\n';
  } else if (arguments.size() == 2 && arguments[0] == "tinyobjloader") {
    std::cout << loadWithTinyobjloader(arguments[1]) << '\n';
  } else {
    throw std::runtime_error("usage: obj-bench lavaray|tinyobjloader FILE, obj-bench write FORM FILE");
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(std::vector<std::string>(argv + 1, argv + argc));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
