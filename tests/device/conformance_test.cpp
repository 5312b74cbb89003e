// The course's scenes against its expected images and against the oracle, and real meshes against the oracle.
// They are no part of the project: where their folder is absent, these tests skip themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "device/render_scene.hpp"
#include "image/image_reader.hpp"
#include "oracle/oracle.hpp"
#include "scene/scene_reader.hpp"
#include "support/image_compare.hpp"

namespace lavaray {
namespace {

namespace fs = std::filesystem;

fs::path sharedFile(const std::string& name) {
  return fs::path(LAVARAY_SHARED_DIR) / name;
}

std::vector<std::uint8_t> toBytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  for (const float value : image.rgb) bytes.push_back(toByte(value));
  return bytes;
}

std::vector<std::uint8_t> bytesOfFile(const fs::path& file) {
  std::vector<std::uint8_t> bytes;
  for (const float value : readImage(file).rgb)
    bytes.push_back(static_cast<std::uint8_t>(255.0F * value + 0.5F));
  return bytes;
}

struct Expected {
  const char* scene;
  ImageSize size;
  int allowedDifferences;  // from the course's image; -1 where there is none
  bool stretched;          // as the course's image of scene3 is
};

std::ostream& operator<<(std::ostream& out, const Expected& expected) {
  return out << expected.scene;
}

class CourseScene : public testing::TestWithParam<Expected> {};

INSTANTIATE_TEST_SUITE_P(
    , CourseScene,
    testing::Values(Expected{"scene1", {1534, 1154}, -1, false}, Expected{"scene2", {2051, 1154}, -1, false},
                    Expected{"scene3", {767, 577}, 120, true}, Expected{"scene4", {1212, 808}, 30, false},
                    Expected{"scene5", {1212, 808}, 40, false}, Expected{"scene6", {1212, 808}, 110, false},
                    Expected{"scene7", {2051, 1154}, -1, false},
                    Expected{"sceneCube", {1534, 1154}, -1, false},
                    Expected{"sceneMap", {1534, 1154}, -1, false},
                    Expected{"scenefish", {1534, 1154}, -1, false}),
    [](const auto& test) { return std::string(test.param.scene); });

TEST_P(CourseScene, EqualsTheExpectedImageOffTheSilhouettes) {
  const Expected& expected = GetParam();
  const fs::path file = sharedFile(std::string("course/") + expected.scene + ".txt");
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const Scene scene = readScene(file);
  ASSERT_EQ(imageSize(scene.camera), expected.size);

  Image image = renderScene(scene).image;
  const oracle::Result reference = oracle::render(scene);
  const Comparison comparison = compare(image.rgb, reference);
  EXPECT_EQ(comparison.wrong, 0) << describe(comparison);
  std::cout << "against the oracle: " << describe(comparison) << '\n';

  if (expected.allowedDifferences < 0) return;
  if (expected.stretched) normalize(image);
  const fs::path expectedFile = fs::path(file).replace_extension(".bmp");
  // The course's single-precision tracer decides otherwise wherever an edge, the horizon among them, passes
  // through the pixel, not only close to its centre.
  const ByteComparison bytes =
      compareBytes(toBytes(image), bytesOfFile(expectedFile), oracle::render(scene, {.probeOffset = 0.5}));
  EXPECT_LE(bytes.differing, expected.allowedDifferences) << describe(bytes);
  EXPECT_EQ(bytes.wrong, 0) << describe(bytes);
  std::cout << "against the course's image: " << describe(bytes) << '\n';
}

struct MeshView {
  const char* file;
  double fovDegrees;
  glm::dvec3 camera;
  glm::dvec3 light;
};

std::ostream& operator<<(std::ostream& out, const MeshView& view) {
  return out << view.file;
}

class RealMesh : public testing::TestWithParam<MeshView> {};

INSTANTIATE_TEST_SUITE_P(, RealMesh,
                         testing::Values(MeshView{"stanford-bunny", 35.0, {-0.02, 0.11, 0.35}, {1, 2, 2}},
                                         MeshView{"suzanne", 45.0, {-2.4, 1.3, 9.0}, {1, 6, 12}},
                                         MeshView{"teapot", 45.0, {0, 2, 9}, {5, 8, 6}},
                                         MeshView{"beetle", 45.0, {0, 0.5, 1.7}, {3, 5, 4}},
                                         MeshView{"spot", 45.0, {0, 0.1, 4}, {3, 5, 4}},
                                         MeshView{"fandisk", 45.0, {2.4, 15.2, 8}, {8, 20, 9}}),
                         [](const auto& test) {
                           std::string name = test.param.file;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(RealMesh, EqualsTheOracleOffTheSilhouettes) {
  const MeshView& view = GetParam();
  const fs::path file = sharedFile(std::string("meshes/") + view.file + ".obj");
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const fs::path sceneFile = fs::path(testing::TempDir()) / (std::string(view.file) + "-view.txt");
  std::ofstream(sceneFile) << "3\ncamera\npos: " << view.camera.x << ' ' << view.camera.y << ' '
                           << view.camera.z << "\nfov: " << view.fovDegrees
                           << "\nf: 100\na: 1.3\nlight\npos: " << view.light.x << ' ' << view.light.y << ' '
                           << view.light.z
                           << "\namb: 0.1 0.1 0.1\ndif: 0.8 0.8 0.8\nspe: 0.4 0.4 0.4\nmesh\nfile: "
                           << file.string()
                           << "\namb: 0.1 0.1 0.1\ndif: 0.7 0.6 0.5\nspe: 0.3 0.3 0.3\nshi: 30\n";
  const Scene scene = readScene(sceneFile);
  fs::remove(sceneFile);
  const ImageSize size = reducedSize(scene.camera, 100);
  const Comparison comparison =
      compare(renderScene(scene, size).image.rgb, oracle::render(scene, {.size = size}));
  EXPECT_EQ(comparison.wrong, 0) << describe(comparison);
  EXPECT_GT(comparison.uncertain, 0) << "the mesh is not in the picture";
  std::cout << describe(comparison) << '\n';
}

}  // namespace
}  // namespace lavaray
