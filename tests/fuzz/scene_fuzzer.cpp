// Any text as a scene file: it is refused with a message or it is a scene that can be rendered.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "fuzz/checks.hpp"
#include "scene/scene_reader.hpp"

namespace lavaray {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
constexpr const char* kPentagon =
    "v 0 0 -1\nv 2 0 -1\nv 2 2 -1\nv 1 0.5 -1\nv 0 2 -1\nv 1 3 -4\nf 1 2 3 4 5\nf -1 -2 -3\n";
constexpr const char* kBroken = "v 1 2 3\nf 1 2 3\n";

// The names that the dictionary knows; no other file of the machine is read, since that would prove nothing
// here.
Mesh readMesh(const std::filesystem::path& file) {
  if (file == "triangle.obj") return parseObj(kTriangle, file);
  if (file == "pentagon.obj") return parseObj(kPentagon, file);
  if (file == "broken.obj") return parseObj(kBroken, file);
  return readObj("no such folder" / file.filename());
}

}  // namespace
}  // namespace lavaray

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lavaray;
  static const std::filesystem::path file = "scene.txt";
  try {
    const Scene scene = parseScene({reinterpret_cast<const char*>(data), size}, file, readMesh);
    fuzz::checkScene(scene);
    fuzz::checkFlattened(scene);
  } catch (const Error& error) {
    fuzz::checkComplaint(error);
  }
  return 0;
}
