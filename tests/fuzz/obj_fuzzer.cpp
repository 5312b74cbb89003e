// Any text as an OBJ file: it is refused with a message, or it is a mesh that can be rendered, the same as
// tinyobjloader's where that reads the text rightly.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "fuzz/checks.hpp"
#include "scene/obj_reader.hpp"
#include "support/obj_peer.hpp"

namespace {

// The mesh, or what is said of the text.
std::pair<lavaray::Mesh, std::string> read(const std::string& text, std::size_t partBytes) {
  static const std::filesystem::path file = "mesh.obj";
  try {
    lavaray::Mesh mesh = lavaray::parseObj(text, file, partBytes);
    for (const std::string& warning : mesh.warnings) lavaray::fuzz::checkMessage(warning);
    return {std::move(mesh), {}};
  } catch (const lavaray::Error& error) {
    lavaray::fuzz::checkComplaint(error);
    return {{}, error.what()};
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lavaray;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto [mesh, complaint] = read(text, kObjPartBytes);
  const auto [joined, sameComplaint] = read(text, 24);
  fuzz::require(mesh == joined && complaint == sameComplaint, "parts change nothing");
  if (!complaint.empty()) return 0;
  if (isPlainObj(text))
    fuzz::require(differenceFromTinyobjloader(text, mesh).empty(), "tinyobjloader reads the same");
  Scene scene;
  scene.camera.focalLength = 10.0;
  scene.materials.resize(1);
  scene.meshObjects = {{0, 0}};
  scene.meshes.push_back(mesh);
  fuzz::checkScene(scene);
  fuzz::checkFlattened(scene);
  return 0;
}
