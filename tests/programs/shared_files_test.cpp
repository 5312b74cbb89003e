// The readers against the course's scenes and well-known meshes, which lie outside the tree.
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "scene/obj_reader.hpp"
#include "scene/scene_reader.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

struct SharedMesh {
  std::string name;
  std::string path;
  std::size_t triangles;
};

// For the names of the tests.
void PrintTo(const SharedMesh& value, std::ostream* out) {
  *out << value.name;
}

class SharedMeshes : public testing::TestWithParam<SharedMesh> {};

TEST_P(SharedMeshes, Load) {
  const auto file = std::filesystem::path(LAVARAY_SHARED_DIR) / GetParam().path;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const Mesh mesh = readObj(file);
  EXPECT_EQ(mesh.triangles.size(), GetParam().triangles);
  EXPECT_EQ(mesh.degenerateTriangles, 0U);
}

const SharedMesh kSharedMeshes[] = {
    {"Bunny", "meshes/stanford-bunny.obj", 69451},
    {"Nefertiti", "meshes/nefertiti.obj", 99938},
    {"Beast", "meshes/beast.obj", 64618},
    {"Spot", "meshes/spot.obj", 5856},
    {"Fandisk", "meshes/fandisk.obj", 12946},
    {"Teapot", "meshes/teapot.obj", 6320},
    {"Beetle", "meshes/beetle.obj", 2053},
    {"Suzanne", "meshes/suzanne.obj", 968},
    {"Cube", "course/cube.obj", 12},
    {"Fish", "course/fish.obj", 135},
    {"Map", "course/map.obj", 18},
};

INSTANTIATE_TEST_SUITE_P(All, SharedMeshes, testing::ValuesIn(kSharedMeshes),
                         [](const auto& test) { return test.param.name; });

TEST(SharedCases, AreTheSameMesh) {
  const auto folder = std::filesystem::path(LAVARAY_SHARED_DIR) / "cases" / "obj";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const Mesh plain = readObj(folder / "plain.obj");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Mesh mesh = readObj(entry.path());
    EXPECT_EQ(mesh.triangles, plain.triangles) << entry.path();
    EXPECT_TRUE(std::equal(plain.positions.begin(), plain.positions.end(), mesh.positions.begin()))
        << entry.path();
  }
}

struct SharedScene {
  std::string file;
  std::size_t planes, spheres, triangles, meshes, lights;
};

// For the names of the tests.
void PrintTo(const SharedScene& value, std::ostream* out) {
  *out << value.file;
}

class SharedScenes : public testing::TestWithParam<SharedScene> {};

TEST_P(SharedScenes, Load) {
  const SharedScene& expected = GetParam();
  const auto file = std::filesystem::path(LAVARAY_SHARED_DIR) / "course" / expected.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const Scene scene = readScene(file);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.planes.size(), expected.planes);
  EXPECT_EQ(scene.spheres.size(), expected.spheres);
  EXPECT_EQ(scene.triangles.size(), expected.triangles);
  EXPECT_EQ(scene.meshObjects.size(), expected.meshes);
  EXPECT_EQ(scene.lights.size(), expected.lights);
}

const SharedScene kSharedScenes[] = {{"scene1.txt", 1, 3, 1, 0, 1},   {"scene2.txt", 1, 3, 1, 0, 2},
                                     {"scene3.txt", 1, 1, 2, 0, 1},   {"scene4.txt", 1, 0, 2, 0, 1},
                                     {"scene5.txt", 1, 3, 1, 0, 1},   {"scene6.txt", 1, 1, 2, 0, 1},
                                     {"scene7.txt", 1, 4, 0, 0, 2},   {"sceneCube.txt", 1, 3, 0, 1, 1},
                                     {"sceneMap.txt", 1, 2, 0, 1, 1}, {"scenefish.txt", 1, 3, 0, 1, 1}};

INSTANTIATE_TEST_SUITE_P(All, SharedScenes, testing::ValuesIn(kSharedScenes), [](const auto& test) {
  return test.param.file.substr(0, test.param.file.find('.'));
});

// The mesh of the assignment's own sample was never published.
TEST(ReadScene, AssignmentSampleLacksItsMesh) {
  const auto file = std::filesystem::path(LAVARAY_SHARED_DIR) / "course" / "handout_sample.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  expectMessage(inputError([&] { readScene(file); }), file, 27, "statue.obj: cannot be read");
}

}  // namespace
}  // namespace lavaray
