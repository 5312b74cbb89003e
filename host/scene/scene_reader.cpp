#include "scene/scene_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/byte_reader.hpp"
#include "base/limits.hpp"
#include "base/text_lines.hpp"
#include "base/text_location.hpp"
#include "scene/camera.hpp"
#include "scene/scene_block.hpp"
#include "scene/triangulate.hpp"

namespace lavaray {
namespace {

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, const MeshReader& readMesh)
      : file_(file), readMesh_(readMesh) {
    scene_.file = file;
  }

  Scene read(std::string_view text);

 private:
  void readCount(std::string_view line);
  void readLine(std::string_view line, const TextLocation& location);
  [[nodiscard]] bool isBareFileName(std::string_view line) const;
  void startBlock(std::string_view line, const TextLocation& location);
  void finishBlock();
  void warnOfCount();

  void addCamera(const Block& block);
  void addTriangle(const Block& block);
  void addMesh(const Block& block);
  void addLight(const Block& block);
  std::uint32_t addMaterial(const Block& block);
  std::size_t meshIndex(const std::filesystem::path& meshFile, const TextLocation& location);

  const std::filesystem::path& file_;
  const MeshReader& readMesh_;
  Scene scene_;
  std::string count_;  // as written in line 1
  std::size_t blockCount_ = 0;
  bool hasCamera_ = false;
  std::optional<Block> block_;  // the one being read
  std::map<std::filesystem::path, std::size_t> meshes_;
};

Scene SceneReader::read(std::string_view text) {
  Lines lines(text);
  if (!lines.next()) failAt({file_, 1}, "the file is empty, allowed in line 1 is the number of objects");
  readCount(trim(lines.line()));
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (!line.empty()) readLine(line, {file_, lines.lineNumber()});
  }
  finishBlock();
  if (!hasCamera_) failAt({file_, lines.lineNumber()}, "no camera in the file, allowed is exactly one");
  warnOfCount();
  return std::move(scene_);
}

void SceneReader::readCount(std::string_view line) {
  std::string_view digits = line;
  if (digits.starts_with('+') || digits.starts_with('-')) digits.remove_prefix(1);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    failAt({file_, 1}, quoted(line) + " is not a number of objects, allowed in line 1 is an integer");
  }
  count_ = line;
}

void SceneReader::readLine(std::string_view line, const TextLocation& location) {
  if (isBareFileName(line)) return block_->add("file", line, location);
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return startBlock(line, location);
  const std::string_view key = trim(line.substr(0, colon));
  if (!block_) {
    failAt(location, "key " + quoted(key) + " before the first object, allowed is one of " + allowedKinds());
  }
  block_->add(key, trim(line.substr(colon + 1)), location);
}

// Some files name the mesh on the line after `mesh`, without `file:`.
bool SceneReader::isBareFileName(std::string_view line) const {
  if (!block_ || block_->kind() != ObjectKind::kMesh || !block_->isEmpty()) return false;
  return line.starts_with('"') || (line.find(':') == std::string_view::npos && !objectKind(line));
}

void SceneReader::startBlock(std::string_view line, const TextLocation& location) {
  // Must come before the previous object is finished, which would report a key without its colon as missing.
  const auto kind = objectKind(line);
  if (!kind) failAt(location, "unknown kind of object " + quoted(line) + ", allowed are " + allowedKinds());
  finishBlock();
  if (*kind == ObjectKind::kCamera && hasCamera_) failAt(location, "a second camera, allowed is exactly one");
  block_.emplace(*kind, location);
  ++blockCount_;
}

void SceneReader::finishBlock() {
  if (!block_) return;
  const Block& block = *block_;
  block.checkComplete();
  switch (block.kind()) {
    case ObjectKind::kCamera:
      addCamera(block);
      break;
    case ObjectKind::kPlane:
      scene_.planes.push_back({block.vector("nor"), block.vector("pos"), addMaterial(block)});
      break;
    case ObjectKind::kSphere:
      scene_.spheres.push_back({block.vector("pos"), block.number("rad"), addMaterial(block)});
      break;
    case ObjectKind::kTriangle:
      addTriangle(block);
      break;
    case ObjectKind::kMesh:
      addMesh(block);
      break;
    case ObjectKind::kLight:
      addLight(block);
      break;
  }
  block_.reset();
}

void SceneReader::addCamera(const Block& block) {
  scene_.camera = {.position = block.vector("pos"),
                   .fovDegrees = block.number("fov"),
                   .focalLength = block.number("f"),
                   .aspect = block.number("a")};
  if (!imageSize(scene_.camera)) {
    failAt(block.location(), "the camera's fov, f and a give no image, allowed are 1 to " +
                                 std::to_string(kMaxImageSide) + " pixels on each side");
  }
  hasCamera_ = true;
}

void SceneReader::addTriangle(const Block& block) {
  const std::array vertices{block.vector("v1"), block.vector("v2"), block.vector("v3")};
  if (!hasArea(vertices[0], vertices[1], vertices[2])) {
    failAt(block.location(), "a triangle without area, allowed are three corners that are not on a line");
  }
  scene_.triangles.push_back({vertices, addMaterial(block)});
}

void SceneReader::addMesh(const Block& block) {
  const std::size_t mesh = meshIndex(file_.parent_path() / block.text("file"), block.locationOf("file"));
  scene_.meshObjects.push_back({mesh, addMaterial(block)});
}

void SceneReader::addLight(const Block& block) {
  const std::string_view diffuse = block.has("col") ? "col" : "dif";
  const std::string_view specular = block.has("col") ? "col" : "spe";
  scene_.lights.push_back({.position = block.vector("pos"),
                           .ambient = block.vector("amb"),
                           .diffuse = block.vector(diffuse),
                           .specular = block.vector(specular),
                           .radius = block.number("rad"),
                           .statesRadius = block.has("rad")});
}

// Returns the object's number.
std::uint32_t SceneReader::addMaterial(const Block& block) {
  scene_.materials.push_back({.ambient = block.vector("amb"),
                              .diffuse = block.vector("dif"),
                              .specular = block.vector("spe"),
                              .shininess = block.number("shi"),
                              .reflectance = block.vector("ref"),
                              .statesReflectance = block.has("ref")});
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::size_t SceneReader::meshIndex(const std::filesystem::path& meshFile, const TextLocation& location) {
  std::error_code unknown;
  std::filesystem::path key = std::filesystem::weakly_canonical(meshFile, unknown);
  if (unknown) key = meshFile;  // reading it will report why
  const auto [entry, isNew] = meshes_.try_emplace(std::move(key), scene_.meshes.size());
  if (!isNew) return entry->second;
  try {
    scene_.meshes.push_back(readMesh_(meshFile));
    const auto& warnings = scene_.meshes.back().warnings;
    scene_.warnings.insert(scene_.warnings.end(), warnings.begin(), warnings.end());
  } catch (const UnreadableFile& error) {
    failAt(location, error.what());
  }
  return entry->second;
}

void SceneReader::warnOfCount() {
  std::string_view digits = count_;
  const bool isNegative = digits.starts_with('-');
  if (isNegative || digits.starts_with('+')) digits.remove_prefix(1);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  if (digits == std::to_string(blockCount_) && (!isNegative || digits == "0")) return;
  scene_.warnings.push_back(messageAt(
      {file_, 1}, "the file says " + count_ + " objects, there are " + std::to_string(blockCount_)));
}

std::string readText(const std::filesystem::path& file) {
  try {
    return readFile(file);
  } catch (const std::system_error& error) {
    failUnreadable(file, error);
  }
}

}  // namespace

Scene readScene(const std::filesystem::path& file, const MeshReader& readMesh) {
  return parseScene(readText(file), file, readMesh);
}

Scene parseScene(std::string_view text, const std::filesystem::path& file, const MeshReader& readMesh) {
  rejectNulBytes(text, file);
  return SceneReader(file, readMesh).read(text);
}

}  // namespace lavaray
