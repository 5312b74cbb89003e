#include "scene/obj_reader.hpp"

#include <array>
#include <locale>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "support/input_files.hpp"

namespace lavaray {
namespace {

using Indices = std::array<std::uint32_t, 3>;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh read(std::string_view content) {
  return readObj(writeFile("mesh.obj", content));
}

std::vector<Indices> positions(const Mesh& mesh) {
  std::vector<Indices> result;
  for (const MeshTriangle& triangle : mesh.triangles) result.push_back(triangle.positions);
  return result;
}

TEST(ReadObj, PositionsNormalsAndTheirIndices) {
  const Mesh mesh = read(kTriangle + "vn 0 0 2\nvn 1e-9 0 0\nf 1//1 2//2 3//1\n");
  EXPECT_EQ(mesh.file.filename(), "mesh.obj");
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.normals, (std::vector<glm::dvec3>{{0, 0, 2}, {1e-9, 0, 0}}));
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.triangles[0].positions, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.triangles[0].normals, (Indices{0, 1, 0}));
  EXPECT_EQ(mesh.degenerateTriangles, 0U);
}

TEST(ReadObj, EveryFormOfCorner) {
  const Mesh mesh = read(kTriangle +
                         "vt 0\nvt 0 1\nvt 0 1 0\nvn 0 0 1\n"
                         "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\nf +1 +2 +3\n");
  ASSERT_EQ(mesh.triangles.size(), 5U);
  const std::array expected{kNoNormal, kNoNormal, 0U, 0U, kNoNormal};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(mesh.triangles[i].positions, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[i].normals, (Indices{expected[i], expected[i], expected[i]}));
  }
}

TEST(ReadObj, NormalsOnSomeCornersAreNone) {
  const Mesh mesh = read(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1 4\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  for (const MeshTriangle& triangle : mesh.triangles) {
    EXPECT_EQ(triangle.normals, (Indices{kNoNormal, kNoNormal, kNoNormal}));
  }
}

TEST(ReadObj, NegativeIndicesCountFromTheirLine) {
  const Mesh mesh = read(kTriangle + "vt 0 0\nvn 0 0 1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\n" + kTriangle +
                         "vn 0 1 0\nf -3//-1 -2//-1 -1//-1\n");
  EXPECT_EQ(positions(mesh), (std::vector<Indices>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(mesh.triangles[0].normals, (Indices{0, 0, 0}));
  EXPECT_EQ(mesh.triangles[1].normals, (Indices{1, 1, 1}));
}

TEST(ReadObj, FacesBeforeTheirVertices) {
  const Mesh mesh = read("f 1/1/1 2/2/1 3/1/1\n" + kTriangle + "vt 0 0\nvt 1 0\nvn 0 0 1\n");
  EXPECT_EQ(positions(mesh), (std::vector<Indices>{{0, 1, 2}}));
}

TEST(ReadObj, PolygonsKeepTheirWinding) {
  EXPECT_EQ(positions(read(kSquare + "f 1 2 3 4\n")), (std::vector<Indices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(positions(read(kSquare + "f 4 3 2 1\n")), (std::vector<Indices>{{3, 2, 1}, {3, 1, 0}}));
}

TEST(ReadObj, ConcaveQuadWithNormals) {
  const Mesh mesh = read(
      "v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\nvn 0 0 1\nvn 0 0 2\nvn 0 0 3\nvn 0 0 4\n"
      "f 2//2 3//3 4//4 1//1\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  for (const MeshTriangle& t : mesh.triangles) {
    EXPECT_EQ(t.positions, t.normals);
    const auto& p = mesh.positions;
    const glm::dvec3 a = p[t.positions[0]];
    EXPECT_EQ(glm::cross(p[t.positions[1]] - a, p[t.positions[2]] - a).z, 2.0);
  }
}

TEST(ReadObj, DegenerateTrianglesAreDroppedAndCounted) {
  const Mesh mesh = read(kSquare + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 2 5 1\nf 1 2 3 3\nf 1 2 3\n");
  EXPECT_EQ(mesh.triangles.size(), 3U);  // coincident faces are kept
  EXPECT_EQ(mesh.degenerateTriangles, 1U + 1U + 2U + 1U);
}

TEST(ReadObj, EverythingElseIsIgnored) {
  const Mesh mesh = read(
      "# comment \xFF\n#\nmtllib no such.mtl\no\no name\ng\ng a b\ns off\nusemtl\nusemtl m\nl 1 2\np 1\n"
      "vp 0.5\nvx broken\nfo 1\ncstype bezier\ncall x\n\n   \n\t\n" +
      kTriangle + "f 1 2 3\nusemtl other\nend");
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

TEST(ReadObj, CommentsAtLineEnds) {
  const Mesh mesh = read("v 0 0 0 # origin\nv 1 0 0\t#x\nv 0 1 0 # y # y\nf 1 2 3 # f 9 9 9\n");
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

TEST(ReadObj, LineEndsAndWhiteSpace) {
  for (const std::string content :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\nv 1 0 0\r\nv 0 1 0\nf 1 2 3",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "\xEF\xBB\xBFv 0 0 0\n\n \tv\t1 0  0 \t\n  v 0 1 0\n\tf  1\t2 3 \r\n",
        "v 0 0 0\r\r\nv 1 0 0\r\r\nv 0 1 0\r\r\nf 1 2 3\r\r"}) {
    EXPECT_EQ(positions(read(content)), (std::vector<Indices>{{0, 1, 2}})) << content;
  }
}

TEST(ReadObj, NumbersAreExact) {
  const Mesh mesh = read(
      "v 0.1 -12345.678901234567 +1e-3\nv .5 5. 1E2 1\nv 1e-400 0 0 0.1 0.2 0.3\n"
      "v 1e15 -1e15 0 1 0.1 0.2 0.3\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions,
            (std::vector<glm::dvec3>{
                {0.1, -12345.678901234567, 1e-3}, {0.5, 5.0, 100.0}, {0, 0, 0}, {1e15, -1e15, 0}}));
}

TEST(ReadObj, LargePolygon) {
  std::string content;
  std::string face = "f";
  for (int i = 0; i < 10000; ++i) {
    content += "v " + std::to_string(i) + " " + std::to_string(i % 2 + (i < 5000 ? 0 : 10)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  EXPECT_EQ(read(content + "v 9999 100 0\nv 0 100 0\n" + face + " 10001 10002\n").triangles.size(), 10000U);
}

TEST(ReadObj, LocaleDoesNotMatter) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const Mesh mesh = read("v 0.25 0 0\nv 1000.5 0 0\nv 0 1 0\nf 1 2 3\n");
  std::locale::global(before);
  EXPECT_EQ(mesh.positions[0].x, 0.25);
  EXPECT_EQ(mesh.positions[1].x, 1000.5);
}

// Back references across parts, every kind of line ending, a byte-order mark in mid-file, errors in several
// parts (the first in the file wins), and an error in a face ahead of one on a later line.
TEST(ReadObj, PartsOfAnySizeMakeTheSameMeshAndTheSameMessage) {
  const auto outcome = [](const std::string& text, std::size_t partBytes) {
    Mesh mesh;
    const std::string error = inputError([&] { mesh = parseObj(text, "mesh.obj", partBytes); });
    return std::pair(mesh, error);
  };
  const std::string texts[] = {
      "",
      "\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\rv 0 1 0\n\xEF\xBB\xBFv 9 9 9\nf -3 -2 -1 # near\n\r\n\rvn 0 0 1\nf "
      "1//1 2//-1 3//1",
      kSquare + "f 4 3 2 1\nv 2 2 2\nf -2 -3 -4 -5\nf 5 1 2\nf 1 1 2\nvt 0 0\nf 1/-1 2/1 3/1\n",
      kTriangle + "f 1 2 3\n\nf -4 -2 -1\nv 1 2\n",
      kTriangle + "f 1 2 9\nf 1 2 3\nf 1/2 2/3 3\nv 1 2 3\n",
      kTriangle + "f 1 2 9\nf 1 2 3\n\nf 1 x 3\n",
      "v 0 \\\n0 0#c\nv 1 0 0\r\n#c\\\nv 0 \\\r\n\\\r1 \\\n0\nf 1 2\nf -1 \\\n-2 -3\nvn 0 0 0\nf 1//1 2//1 "
      "3//1\nf 1//0 2// 3//-1\nv nan 0 0\nf 1 2 3\\",
  };
  for (const std::string& text : texts) {
    const auto whole = outcome(text, kObjPartBytes);
    for (std::size_t bytes = 1; bytes <= text.size(); ++bytes)
      EXPECT_EQ(outcome(text, bytes), whole) << bytes;
  }
  EXPECT_EQ(outcome(texts[6], 8).first.warnings.size(), 3U);
  EXPECT_EQ(outcome(texts[3], 8).second, "mesh.obj:6: vertex -4 is out of range, there are 3");
  EXPECT_EQ(outcome(texts[5], 8).second.substr(0, 13), "mesh.obj:7: \"");
}

// Each amounts to one long line: a search for its end, or for the CRs before it, that started afresh on every
// line would take hours.
TEST(ReadObj, MillionsOfLoneCrsAndContinuedLines) {
  constexpr std::size_t kLines = 4'000'000;
  const std::string crs(kLines, '\r');
  EXPECT_EQ(positions(parseObj(kTriangle + crs + "x\r" + "f 1 2 3" + crs, "crs.obj")),
            (std::vector<Indices>{{0, 1, 2}}));
  std::string continued = "v 0 0 ";
  for (std::size_t i = 0; i < kLines; ++i) continued += "\\\n";
  const std::string text = continued + "0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 x\n";
  EXPECT_EQ(inputError([&] { parseObj(text, "continued.obj"); }).substr(0, 22), "continued.obj:4000005:");
}

}  // namespace
}  // namespace lavaray
