// Our reader of OBJ files against tinyobjloader.
#include "support/obj_peer.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/byte_reader.hpp"
#include "scene/obj_reader.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

// Meshes of all forms of corners: polygons, some of them degenerate or concave, with negative indices, and
// with vertices, normals and names in between.
class RandomObj {
 public:
  explicit RandomObj(unsigned seed) : random_(seed) {}

  std::string text() {
    for (int i = 0; i < 3; ++i) addLine("v", 3, counts_[0]);
    for (int i = 0; i < 40; ++i) addStatement();
    return text_ + "f 1 2 3\n";
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  void addStatement() {
    switch (below(8)) {
      case 0:
        return addLine("vn", 3, counts_[2]);
      case 1:
        return addLine("vt", 2, counts_[1]);
      case 2:
        text_ += below(2) == 0 ? "o name\n" : "g\n";
        return;
      case 3:
      case 4:
        return addLine("v", 3, counts_[0]);
      default:
        return addFace();
    }
  }

  void addLine(const std::string& keyword, int numbers, int& count) {
    text_ += keyword;
    for (int i = 0; i < numbers; ++i) {
      // Often on a grid, so that corners coincide and are on lines.
      const double number = below(2) == 0 ? below(3) : uniform(random_, -1000.0, 1000.0);
      std::array<char, 64> word{};
      text_ += " " + std::string(word.data(), static_cast<std::size_t>(std::snprintf(
                                                  word.data(), word.size(), "%.*f", below(10), number)));
    }
    text_ += '\n';
    ++count;
  }

  std::string index(int count) {
    return std::to_string(below(2) == 0 ? below(count) + 1 : -below(count) - 1);
  }

  void addFace() {
    const bool hasTexcoords = below(2) == 0 && counts_[1] > 0;
    const bool hasNormals = below(2) == 0 && counts_[2] > 0;
    const int corners = below(4) == 0 ? 3 + below(9) : 3 + below(2);
    text_ += 'f';
    for (int i = 0; i < corners; ++i) {
      text_ += " " + index(counts_[0]);
      if (hasTexcoords || hasNormals) text_ += '/';
      if (hasTexcoords) text_ += index(counts_[1]);
      if (hasNormals) text_ += "/" + index(counts_[2]);
    }
    text_ += '\n';
  }

  Random random_;
  std::array<int, 3> counts_{};  // vertices, texture coordinates, normals
  std::string text_;
};

TEST(ObjPeer, ReadsRandomMeshesAlike) {
  std::size_t triangles = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const std::string text = RandomObj(seed).text();
    ASSERT_TRUE(isPlainObj(text)) << text;
    Mesh mesh;
    try {
      mesh = parseObj(text, "random.obj", 1 + seed % 200);
    } catch (const Error& error) {
      ASSERT_NE(std::string(error.what()).find("no face"), std::string::npos) << error.what() << '\n' << text;
      continue;
    }
    ASSERT_EQ(differenceFromTinyobjloader(text, mesh), "") << text;
    triangles += mesh.triangles.size();
  }
  EXPECT_GT(triangles, 30'000U);
}

TEST(ObjPeer, ReadsTheScenesMeshesAlike) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LAVARAY_SCENES_DIR)) {
    if (entry.path().extension() != ".obj") continue;
    const std::string text = readFile(entry.path());
    ASSERT_TRUE(isPlainObj(text)) << entry.path();
    EXPECT_EQ(differenceFromTinyobjloader(text, readObj(entry.path())), "") << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(ObjPeer, SeesDifferences) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
  const Mesh mesh = parseObj(text, "mesh.obj");
  EXPECT_EQ(differenceFromTinyobjloader(text, mesh), "");
  Mesh other = mesh;
  other.positions[1].x = 1.0000001;
  EXPECT_EQ(differenceFromTinyobjloader(text, other), "other vertices");
  other = mesh;
  other.normals[0].z = 2.0;
  EXPECT_EQ(differenceFromTinyobjloader(text, other), "other normals");
  other = mesh;
  std::swap(other.triangles[0].positions[0], other.triangles[0].positions[1]);
  EXPECT_EQ(differenceFromTinyobjloader(text, other), "other triangles");
}

}  // namespace
}  // namespace lavaray
