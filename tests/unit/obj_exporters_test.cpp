// What exporters write although the format's description has it otherwise: it loads, and where that changes
// what is seen, a warning says so.
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/obj_reader.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

// A square, then a line that names its corners.
const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kNormals = "vn 0 0 1\nvn 0 0 0\nvn nan 0 1\nvn 0 -inf 0\n";
const std::string kOwnNormal = "1 face has its own normal: ";

struct Odd {
  std::string name;
  std::string content;                // makes two triangles of the square
  std::vector<std::string> warnings;  // without the file's name
  bool hasNormals = false;
};

// In the names of the tests.
void PrintTo(const Odd& value, std::ostream* out) {
  *out << value.name;
}

const std::vector<Odd> kOdds{
    {"FaceGoesOn", kCorners + "f 1 2 \\\n3 4\n", {}},
    {"FaceGoesOnTwice", kCorners + "f \\\n1 2\\\n\t3\\\n 4\n", {}},
    {"VertexGoesOn", "v 0 0 \\\n0\n\nv \\\n1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", {}},
    {"KeywordGoesOn", "v\\\n0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf\\\n1 2 3 4\n", {}},
    {"NormalGoesOn", kCorners + "vn 0 \\\n0 1\nf 1//1 2//1 3//1 4//1\n", {}, true},
    {"TexcoordGoesOn", kCorners + "vt 0 \\\n0\nvt \\\nnan\nf 1/1 2/1 3/1 4/1\n", {}},
    {"GoesOnInABlankLine", kCorners + "f 1 2 3 4\\\n\n", {}},
    {"GoesOnInAComment", kCorners + "f 1 2 3 4\\\n# f 1 2 3\n", {}},
    {"CommentInAContinuedLine", kCorners + "f 1 2 \\\n3 4 # f \\\n", {}},
    {"GoesOnBehindTheEnd", kCorners + "f 1 2 3 4 \\", {}},
    {"GoesOnAtTheEnd", kCorners + "f 1 2 3 4 \\\n", {}},
    {"CommentEndsInBackslash", "v 0 0 0 # c:\\\n# d:\\\nv 1 0 0\n#\\\nv 1 1 0\nv 0 1 0#\\\nf 1 2 3 4\n", {}},
    {"NamesEndInBackslash",
     "mtllib d:\\paint\\\nv 0 0 0\no \\\nv 1 0 0\nusemtl a\\\nv 1 1 0\ng \\ \\\nv 0 1 0\ns \\\nf 1 2 3 4\n",
     {}},
    {"BackslashInANameOrComment", kCorners + "usemtl c:\\a b\\c\nf 1 2 3 4 # \\ \\\n", {}},
    {"CommentWithoutBlank", "v 0 0 0#left\nv 1 0 0#\nv 1 1 0 1#\nv 0 1 0\nf 1 2 3 4#quad 5\n", {}},
    {"CommentBehindASlash", kCorners + "f 1 2 3 4/#5\n", {}},
    {"SlashAndNothing", kCorners + "f 1/ 2/ 3/ 4/\n", {}},
    {"SlashesAndNothing", kCorners + "f 1// 2// 3// 4//\n", {}},
    {"TexcoordAndNothing", kCorners + "vt 0 0\nf 1/1/ 2/1/ 3/1/ 4/1/\n", {}},
    {"NormalsAndSlashes", kCorners + kNormals + "f 1// 2// 3// 4//\n", {}},
    {"TexcoordNotFinite", kCorners + "vt nan inf\nvt -nan(ind) 1.#IND\nf 1/1 2/2 3/1 4/2\n", {}},
    {"TexcoordWithoutNumbers", kCorners + "vt\nvt 0 0 0 0\nvt a\nf 1/1 2/1 3/1 4/1\n", {}},
    {"TexcoordOutOfRange", kCorners + "vt 0 0\nf 1/0 2/2 3/-2 4/99999999999\n", {}},
    {"TexcoordsOutOfRangeAndNormals", kCorners + "vn 0 0 1\nf 1/0/1 2/1/1 3/-9/-1 4//1\n", {}, true},
    {"NormalIndexZero",
     kCorners + kNormals + "f 1//0 2//1 3//1 4//1\n",
     {":9: " + kOwnNormal + "an index of a normal is 0 or out of range"}},
    {"NormalIndexTooLarge",
     kCorners + kNormals + "f 1//1 2//1 3//5 4//1\n",
     {":9: " + kOwnNormal + "an index of a normal is 0 or out of range"}},
    {"NormalIndexTooNegative",
     kCorners + kNormals + "f 1//-4 2//-5 3//1 4//1\n",
     {":9: " + kOwnNormal + "an index of a normal is 0 or out of range"}},
    {"NormalIndexHuge",
     kCorners + "f 1//-2147483648 2//2147483648 3//99999999999999999999 4//1\n",
     {":5: " + kOwnNormal + "an index of a normal is 0 or out of range"}},
    {"NormalZero",
     kCorners + kNormals + "f 1//1 2//1 3//2 4//1\n",
     {":9: " + kOwnNormal + "a normal is zero or not finite"}},
    {"NormalNotANumber",
     kCorners + kNormals + "f 1//3 2//1 3//1 4//1\n",
     {":9: " + kOwnNormal + "a normal is zero or not finite"}},
    {"NormalInfinite",
     kCorners + kNormals + "f 1//-1 2//1 3//1 4//1\n",
     {":9: " + kOwnNormal + "a normal is zero or not finite"}},
    {"NormalNotANumberOnWindows",
     kCorners + "vn -nan(ind) -nan(ind) -nan(ind)\nf 1//1 2//1 3//1 4//1\n",
     {":6: " + kOwnNormal + "a normal is zero or not finite"}},
    {"NormalNotANumberOnOldWindows",
     kCorners + "vn -1.#IND 1.#QNAN 1.#INF000\nf 1//1 2//1 3//1 4//1\n",
     {":6: " + kOwnNormal + "a normal is zero or not finite"}},
    {"NormalsOnSome",
     kCorners + kNormals + "f 1//1 2 3//1 4//1\n",
     {":9: " + kOwnNormal + "only some corners have a normal"}},
    {"BadNormalsNotUsed", kCorners + kNormals + "f 1//1 2//1 3//1 4//1\n", {}, true},
    {"VertexNotFiniteNotUsed",
     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0\nv 0 0 -1.#INF\nf 1 2 3 4\nf 5 6\n",
     {":8: 1 face of one or two corners is dropped"}},
    {"ColourNotFinite", "v 0 0 0 nan 0 0\nv 1 0 0\nv 1 1 0 inf\nv 0 1 0\nf 1 2 3 4\n", {}},
    {"FacesOfOneAndTwoCorners",
     kCorners + "f 1 2\n\nf 1 2 3 4\nf 1 \\\n\nf 2/1/7 3//\n",
     {":5: 3 faces of one or two corners are dropped, the first in this line"}},
    {"DegenerateFacesAreNoWarning", kCorners + "vn 0 0 0\nf 1//1 1//1 2//1\nf 1 2 3 4\n", {}},
    {"ManyKinds",
     kCorners + kNormals + "f 1 2\nf 1//1 2//1 3//1 4//\nf 2\nf 1//9 1//9 2//9\n",
     {":9: 2 faces of one or two corners are dropped, the first in this line",
      ":10: " + kOwnNormal + "only some corners have a normal"}},
};

class ObjOfExporters : public testing::TestWithParam<Odd> {};

std::string withCrLf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

TEST_P(ObjOfExporters, IsTheSquare) {
  using Indices = std::array<std::uint32_t, 3>;
  std::vector<std::string> warnings;
  for (const std::string& text : GetParam().warnings) warnings.push_back("odd.obj" + text);
  for (const std::string& text : {GetParam().content, withCrLf(GetParam().content)}) {
    for (std::size_t partBytes = 1; partBytes <= text.size(); ++partBytes) {
      const Mesh mesh = parseObj(text, "odd.obj", partBytes);
      ASSERT_EQ(mesh.triangles.size(), 2U);
      for (int i = 0; i < 4; ++i)
        EXPECT_EQ(mesh.positions[i], glm::dvec3(i == 1 || i == 2 ? 1.0 : 0.0, i / 2, 0.0));
      EXPECT_EQ(mesh.triangles[0].positions, (Indices{0, 1, 2}));
      EXPECT_EQ(mesh.triangles[1].positions, (Indices{0, 2, 3}));
      for (const MeshTriangle& triangle : mesh.triangles) {
        const std::uint32_t normal = GetParam().hasNormals ? 0 : kNoNormal;
        EXPECT_EQ(triangle.normals, (Indices{normal, normal, normal}));
      }
      EXPECT_EQ(mesh.warnings, warnings);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ObjOfExporters, testing::ValuesIn(kOdds),
                         [](const auto& test) { return test.param.name; });

TEST(ReadObj, ChangesAreCountedOverAllParts) {
  std::string text = kCorners + kNormals;
  for (int i = 0; i < 100; ++i) text += "f 1 2\nf 1//1 2//1 3//2\nf 1//1 2//1 3//7\nf 1//1 2//1 3\n";
  const std::vector<std::string> expected{
      "odd.obj:9: 100 faces of one or two corners are dropped, the first in this line",
      "odd.obj:11: 100 faces have their own normal, the first in this line: an index of a normal is 0 or out "
      "of "
      "range",
      "odd.obj:10: 100 faces have their own normal, the first in this line: a normal is zero or not finite",
      "odd.obj:12: 100 faces have their own normal, the first in this line: only some corners have a normal"};
  for (const std::size_t partBytes : {1, 100, 1000, 100000})
    EXPECT_EQ(parseObj(text, "odd.obj", partBytes).warnings, expected);
}

}  // namespace
}  // namespace lavaray
