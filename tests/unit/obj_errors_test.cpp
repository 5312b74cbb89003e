// What the OBJ reader refuses, and where it says so.
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "scene/obj_reader.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

std::string faceOfOneVertex(int corners) {
  std::string face = "f";
  for (int i = 0; i < corners; ++i) face += " 1";
  return face + '\n';
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct BadObj {
  std::string name;
  std::string content;
  std::size_t line;
  std::string words;
};

// For the names of the tests.
void PrintTo(const BadObj& value, std::ostream* out) {
  *out << value.name;
}

class ReadObjFails : public testing::TestWithParam<BadObj> {};

TEST_P(ReadObjFails, AtTheLine) {
  const BadObj& bad = GetParam();
  const auto file = writeFile("bad.obj", bad.content);
  expectMessage(inputError([&] { readObj(file); }), file, bad.line, bad.words);
}

const BadObj kBadObjs[] = {
    {"Empty", "", 1, "no face"},
    {"NoFaces", kTriangle, 3, "no face"},
    {"NoFacesBlankEnd", kTriangle + "\n\n", 5, "no face"},
    {"OnlyDegenerate", kTriangle + "f 1 1 2", 4, "no face"},
    {"NulByte", kTriangle + "f 1 2 3\n#" + std::string(1, '\0') + "\nf x", 5, "NUL"},
    {"NulByteAtLineStart", "v 0 0 0\n" + std::string(1, '\0'), 2, "NUL"},
    {"TwoNumbers", "v 0 0 0\nv 1 0\n", 2, "allowed are 3, 4, 6 or 7"},
    {"FiveNumbers", "v 0 0 0 1 1\n", 1, "5 numbers"},
    {"EightNumbers", "v 0 0 0 1 1 1 1 1\n", 1, "8 numbers"},
    {"BareV", "v\n", 1, "0 numbers"},
    {"BareVn", "\nvn\r\n", 2, "0 numbers"},
    {"BareF", "f\n", 1, "0 corners"},
    {"FourNormalNumbers", "vn 0 0 1 1\n", 1, "allowed are 3"},
    {"TextInVertex", "v 0 zero 0\n", 1, "\"zero\" is not a number"},
    {"HalfANumber", "v 0 1.5x 0\n", 1, "\"1.5x\" is not a number"},
    {"CommaInNumber", "v 0,5 0 0\n", 1, "\"0,5\" is not a number"},
    {"Hexadecimal", "v 0x10 0 0\n", 1, "not a number"},
    {"TooLarge", "v 0 0 1.1e15\n", 1, "from -1e+15 to 1e+15"},
    {"VerticalTab", "v 0 0\v0\n", 1, "not a number"},
    {"OnlyTwoCorners", kTriangle + "f 1 2\n", 4, "no face"},
    {"BareFAndComment", kTriangle + "f # 1 2 3\n", 4, "0 corners, allowed are 3 to 16384"},
    {"TooManyCorners", kTriangle + faceOfOneVertex(16385), 4, "16385 corners, allowed are 3 to 16384"},
    {"VertexZero", kTriangle + "f 0 1 2\n", 4, "index 0"},
    {"VertexTooLarge", kTriangle + "\nf 1 2 4\nf 1 2 3\n", 5, "vertex 4 is out of range, there are 3"},
    {"VertexTooNegative", kTriangle + "f -1 -2 -4\n" + kTriangle, 4,
     "vertex -4 is out of range, there are 3"},
    {"MostNegative", kTriangle + "f 1 2 -2147483648\n", 4, "out of range"},
    {"LargestIndex", kTriangle + "f 1 2 2147483647\n", 4, "vertex 2147483647 is out of range"},
    {"HugeIndex", kTriangle + "f 1 2 99999999999\n", 4, "out of range"},
    {"HugeNegativeIndex", kTriangle + "f 1 2 -99999999999999999999\n", 4, "out of range"},
    {"ZerosInFrontOfZero", kTriangle + "f 1 2 00000000000000000000\n", 4, "index 0"},
    {"VertexZeroInADroppedFace", kTriangle + "f 0 1\n", 4, "index 0"},
    {"VertexTooLargeInADroppedFace", kTriangle + "f 1 2 3\nf 1 4\n", 5, "vertex 4 is out of range"},
    {"NanUsed", "v nan 0 0\n" + kTriangle + "f 2 3 4\n\nf 2 3 1\n", 7, "vertex 1 is not finite"},
    {"InfinityUsed", kTriangle + "v 0 0 -inf\nf 1 2 -1\n", 5, "vertex 4 is not finite"},
    {"OverflowUsed", kTriangle + "v 0 0 1e999\nf 1 2 4 4\n", 5, "vertex 4 is not finite"},
    {"TooLargeNormal", "vn 0 0 1.1e15\n", 1, "from -1e+15 to 1e+15"},
    {"TextInFace", kTriangle + "f 1 2 three\n", 4, "\"three\" is not a corner"},
    {"NumberInFace", kTriangle + "f 1 2 3.0\n", 4, "not a corner"},
    {"TextBehindIndex", kTriangle + "f 1 2 3x\n", 4, "not a corner"},
    {"LeadingSlash", kTriangle + "f /1 2 3\n", 4, "not a corner"},
    {"FourIndices", kTriangle + "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", 6, "not a corner"},
    {"SpacedSlash", kTriangle + "f 1 /1 2 3\n", 4, "not a corner"},
    {"TextForATexcoord", kTriangle + "f 1/x 2 3\n", 4, "\"1/x\" is not a corner"},
    {"TextForANormal", kTriangle + "f 1//x 2 3\n", 4, "\"1//x\" is not a corner"},
    {"ThreeSlashes", kTriangle + "f 1/// 2 3\n", 4, "not a corner"},
    {"OnlyAMinus", kTriangle + "f - 2 3\n", 4, "not a corner"},
    {"AfterCrLf", "v 0 0 0\r\n\r\nv 0 0\r\n", 3, "2 numbers"},
    {"AfterContinuedLines", "v 0 \\\n0 \\\r\n0\nv 0 \\\r0 0\nv 0 x 0\n", 6, "\"x\" is not a number"},
    {"WordInAContinuedLine", "v 0 0 0\nv 0 \\\n\\\n0 x\n", 4, "\"x\" is not a number"},
    {"CountInAContinuedLine", "v 0 0 0\nv 0 \\\n\\\n0\nv x", 2, "2 numbers"},
    {"CornersInAContinuedLine", "\nf \\\n\\\n\n", 2, "0 corners"},
    {"CornerInAContinuedLine", kTriangle + "f 1 2 \\\n3 \\\n 1x\n", 6, "\"1x\" is not a corner"},
    {"VertexInAContinuedLine", kTriangle + "f 1 \\\n2 \\\n 4\\\n 5\n", 6, "vertex 4 is out of range"},
    {"BackReferenceInAContinuedLine", kTriangle + "f 1 \\\n2 \\\n -4\n", 6, "vertex -4 is out of range"},
    {"VertexAfterContinuedLines", kTriangle + "f 1 \\\n2 \\\n3\nf 1 2 4\n", 7, "vertex 4 is out of range"},
    {"StatementInAContinuedLine", kTriangle + "f 1 2 \\\nf 1 2 3\n", 5, "\"f\" is not a corner"},
    {"BackslashInAVertex", "v 0 \\ 0 0\n", 1, "`\\` in the middle of a line"},
    {"BackslashInAWord", "v 0\\1 0 0\n", 1, "`\\` in the middle"},
    {"BackslashAndBlank", "v 0 0 \\ \n0\n", 1, "`\\` in the middle"},
    {"BackslashAndComment", "vn 0 0 \\#\n1\n", 1, "`\\` in the middle"},
    {"BackslashInATexcoord", "vt 0 \\\n\\0\n", 2, "`\\` in the middle"},
    {"BackslashInAFace", kTriangle + "f 1/\\/1 2 3\n", 4, "`\\` in the middle"},
    {"BackslashTwice", "v 0 0 \\\\\n0\n", 1, "`\\` in the middle"},
    {"NulByteAfterContinuedLines", "v 0 \\\n0 0\n\nv " + std::string(1, '\0'), 4, "NUL"},
    {"WindowsNanTooLong", "v 1.#INDX 0\n", 1, "1 numbers"},
};

INSTANTIATE_TEST_SUITE_P(All, ReadObjFails, testing::ValuesIn(kBadObjs),
                         [](const auto& test) { return test.param.name; });

TEST(ReadObj, UnreadableFiles) {
  const auto folder = testFolder();
  EXPECT_THROW(readObj(folder), UnreadableFile);
  EXPECT_THROW(readObj(folder / "missing.obj"), UnreadableFile);
  EXPECT_THROW(readObj(folder / "missing" / "mesh.obj"), UnreadableFile);
  EXPECT_THROW(readObj(std::string(5000, 'x')), UnreadableFile);
  const std::string message = inputError([&] { readObj(folder / "missing.obj"); });
  EXPECT_EQ(message, (folder / "missing.obj").string() + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace lavaray
