// Any text as an OBJ file: it is refused with a message or it is a mesh that can be rendered.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "core/obj_reader.hpp"
#include "fuzz/checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lavaray;
  static const std::filesystem::path file = "mesh.obj";
  Scene scene;
  scene.camera.focalLength = 10.0;
  scene.materials.resize(1);
  scene.meshObjects = {{0, 0}};
  try {
    scene.meshes.push_back(parseObj(std::string(reinterpret_cast<const char*>(data), size), file));
    fuzz::checkScene(scene);
    fuzz::checkFlattened(scene);
  } catch (const Error& error) {
    fuzz::checkComplaint(error);
  }
  return 0;
}
