// What the scene reader refuses, and where it says so.
#include "scene/scene_reader.hpp"

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "support/input_files.hpp"
#include "unit/scene_blocks.hpp"

namespace lavaray {
namespace {

struct BadScene {
  std::string name;
  std::string content;
  std::size_t line;
  std::string words;
};

// For the names of the tests.
void PrintTo(const BadScene& value, std::ostream* out) {
  *out << value.name;
}

class ReadSceneFails : public testing::TestWithParam<BadScene> {};

TEST_P(ReadSceneFails, AtTheLine) {
  const BadScene& bad = GetParam();
  const auto file = writeFile("bad.txt", bad.content);
  expectMessage(inputError([&] { readScene(file); }), file, bad.line, bad.words);
}

const std::string kStart = "9\n" + kCamera;  // lines 1 to 6
const std::string kKinds = "camera, plane, sphere, triangle, mesh, light, model";

// One key of a sphere, on line 8.
std::string sphereWith(const std::string& line) {
  return kStart + "sphere\n" + line + "\n";
}

const BadScene kBadScenes[] = {
    {"Empty", "", 1, "number of objects"},
    {"OnlyByteOrderMark", "\xEF\xBB\xBF", 1, "number of objects"},
    {"BlankCount", "\n1\n" + kCamera, 1, "integer"},
    {"NoCount", kCamera, 1, "\"camera\""},
    {"FractionalCount", "1.0\n" + kCamera, 1, "integer"},
    {"CountAndText", "1 object\n" + kCamera, 1, "integer"},
    {"SignAlone", "-\n" + kCamera, 1, "integer"},
    {"TwoSigns", "+-1\n" + kCamera, 1, "integer"},
    {"NulByte", kStart + "light\npos: 0 0 " + std::string(1, '\0') + "\n", 8, "NUL"},
    {"NulByteBehindCr", "1\r" + kCamera + "\r\n" + std::string(2, '\0'), 8, "NUL"},

    {"UnknownKind", kStart + "cube\n", 7, "\"cube\", allowed are " + kKinds},
    {"UpperCaseKind", kStart + "Sphere\n", 7, kKinds},
    {"KindAndText", kStart + "sphere 1\n", 7, kKinds},
    {"Comment", kStart + "# comment\n", 7, kKinds},
    {"MissingColon", sphereWith("pos 0 0 0"), 8, "unknown kind of object \"pos 0 0 0\""},
    {"KeyBeforeKind", "1\npos: 0 0 0\n", 2, "allowed is one of " + kKinds},
    {"UnknownKey", sphereWith("color: 1 1 1"), 8,
     "\"color\", allowed in a sphere are pos, rad, amb, dif, spe, shi, ref"},
    {"UpperCaseKey", sphereWith("Pos: 1 1 1"), 8, "unknown key \"Pos\""},
    {"NoKey", sphereWith(": 1 1 1"), 8, "unknown key \"\""},
    {"KeyOfAnotherKind", "1\n" + kCamera + "rad: 1\n", 7, "allowed in a camera are pos, fov, f, a"},
    {"MaterialInLight", kStart + "light\nshi: 1\n", 8, "allowed in a light are pos, amb, dif, spe, rad, col"},
    {"MirrorInLight", kStart + "light\nref: 1 1 1\n", 8, "allowed in a light"},
    {"KindWithColon", kStart + "light:\n", 7, "unknown key \"light\""},
    {"RepeatedKey", sphereWith("pos: 0 0 0\nrad: 1\npos: 0 0 0"), 10, "`pos` is repeated"},
    {"RepeatedFile", kStart + "mesh\na.obj\nfile: a.obj\n", 9, "`file` is repeated"},

    {"TextForNumber", sphereWith("rad: big"), 8, "\"big\" is not a number"},
    {"TextBehindNumber", sphereWith("rad: 1m"), 8, "not a number"},
    {"Comma", sphereWith("pos: 1,2,3"), 8, "not a number"},
    {"DecimalComma", sphereWith("rad: 0,5"), 8, "not a number"},
    {"Hexadecimal", sphereWith("rad: 0x10"), 8, "not a number"},
    {"TwoSignsInNumber", sphereWith("rad: +-1"), 8, "not a number"},
    {"TooFewNumbers", sphereWith("pos: 1 2"), 8, "2 numbers, allowed are exactly 3"},
    {"TooManyNumbers", sphereWith("pos: 1 2 3 4"), 8, "4 numbers"},
    {"NoNumbers", sphereWith("pos:"), 8, "0 numbers"},
    {"TwoForOne", sphereWith("rad: 1 2"), 8, "2 numbers, allowed are exactly 1"},
    {"Nan", sphereWith("pos: 0 nan 0"), 8, "out of range"},
    {"Infinity", sphereWith("pos: 0 inf 0"), 8, "out of range"},
    {"NegativeInfinity", sphereWith("pos: 0 -infinity 0"), 8, "out of range"},
    {"Overflow", sphereWith("pos: 0 1e400 0"), 8, "out of range"},
    {"LongOverflow", sphereWith("pos: 0 -1" + std::string(400, '0') + " 0"), 8, "out of range"},
    {"TooLarge", sphereWith("pos: 0 1.0001e15 0"), 8, "from -1e+15 to 1e+15"},

    {"NegativeAmbient", sphereWith("amb: 0 -0.1 0"), 8, "`amb` is -0.1, allowed is 0 or more"},
    {"NegativeDiffuse", sphereWith("dif: 0 0 -1"), 8, "0 or more"},
    {"NegativeSpecular", sphereWith("spe: -1 0 0"), 8, "0 or more"},
    {"NegativeMirror", sphereWith("ref: -1 0 0"), 8, "0 or more"},
    {"NegativeShininess", sphereWith("shi: -1"), 8, "0 or more"},
    {"NegativeLight", kStart + "light\ncol: 1 1 -1\n", 8, "0 or more"},
    {"NegativeLightRadius", kStart + "light\nrad: -1\n", 8, "0 or more"},
    {"RadiusZero", sphereWith("rad: 0"), 8, "more than 0"},
    {"RadiusUnderflows", sphereWith("rad: 1e-400"), 8, "more than 0"},
    {"RadiusNegative", sphereWith("rad: -1"), 8, "more than 0"},
    {"FovZero", "1\ncamera\nfov: 0\n", 3, "more than 0 and less than 180"},
    {"FovStraight", "1\ncamera\nfov: 180\n", 3, "more than 0 and less than 180"},
    {"FocalLengthZero", "1\ncamera\nf: 0\n", 3, "more than 0"},
    {"AspectNegative", "1\ncamera\na: -1.33\n", 3, "more than 0"},
    {"NormalZero", kStart + "plane\nnor: 0 -0 0\n", 8, "any other vector"},
    {"NormalUnderflows", kStart + "plane\nnor: 0 1e-400 0\n", 8, "any other vector"},
    {"TriangleOnALine", kStart + "triangle\nv1: 0 0 0\nv2: 1 1 1\nv3: 2 2 2\n" + kMaterial, 7,
     "without area"},
    {"TriangleOfTwoPoints", kStart + "triangle\nv1: 0 0 0\nv2: 1 1 1\nv3: 0 0 0\n" + kMaterial, 7,
     "without area"},
    {"ColBehindAmb", kStart + "light\namb: 1 1 1\ncol: 1 1 1\n", 9, "`col` together with `amb`"},
    {"DifBehindCol", kStart + "light\ncol: 1 1 1\ndif: 1 1 1\n", 9, "`col` together with `dif`"},
    {"SpeBehindCol", kStart + "light\ncol: 1 1 1\npos: 1 1 1\nspe: 1 1 1\n", 10, "`col` together with `spe`"},

    {"MissingInSphere", kStart + "sphere\npos: 0 0 0\n" + kMaterial + "\n" + kLight, 7, "missing key rad"},
    {"MissingSeveral", kStart + "\nsphere\n\npos: 0 0 0\n", 8, "missing key rad, amb, dif, spe, shi"},
    {"MissingInCamera", "1\n\ncamera\npos: 0 0 0\nfov: 60\na: 1\n", 3, "missing key f"},
    {"MissingInPlane", kStart + "plane\npos: 0 0 0\n" + kMaterial, 7, "missing key nor"},
    {"MissingInTriangle", kStart + "triangle\nv1: 0 0 0\nv2: 1 1 1\n" + kMaterial, 7, "missing key v3"},
    {"MissingInMesh", kStart + "mesh\n" + kMaterial, 7, "missing key file"},
    {"MissingInLight", kStart + "light\npos: 0 0 0\namb: 1 1 1\n", 7, "missing key dif, spe"},
    {"MissingPosBesideCol", kStart + "light\ncol: 1 1 1\n", 7, "missing key pos"},
    {"MeshWithoutKeys", kStart + "mesh\nsphere\n", 7, "missing key file"},
    {"NoCamera", "1\n" + kSphere, 8, "no camera"},
    {"NoCameraBlankEnd", "1\n" + kSphere + "\n\n", 10, "no camera"},
    {"NoObjects", "0", 1, "no camera"},
    {"TwoCameras", kStart + kSphere + kCamera, 14, "a second camera"},
    {"NoPixels", "1\n\ncamera\npos: 0 0 0\nfov: 1e-300\nf: 1\na: 1\n", 3, "1 to 65535 pixels"},
    {"TooManyPixels", "1\ncamera\npos: 0 0 0\nfov: 90\nf: 40000\na: 1\n", 2, "1 to 65535 pixels"},

    {"MeshMissing", kStart + "mesh\n\nfile: absent.obj\n" + kMaterial, 9,
     "absent.obj: cannot be read: No such file"},
    {"BareMeshMissing", kStart + "model\nabsent.obj\n" + kMaterial, 8,
     "absent.obj: cannot be read: No such file"},
    {"MeshIsAFolder", kStart + "mesh\n" + kMaterial + "file: .\n", 12, "cannot be read: Is a directory"},
    {"NoFileName", kStart + "mesh\nfile:\n", 8, "file name is empty"},
    {"NoQuotedFileName", kStart + "mesh\nfile: \"\"\n", 8, "file name is empty"},
    {"OpenQuotes", kStart + "mesh\nfile: \"a.obj\n", 8, "quotes"},
    {"OnlyAQuote", kStart + "mesh\n\"\n", 8, "quotes"},
    {"TextBehindQuotes", kStart + "mesh\n\"a.obj\" b\n", 8, "quotes"},
    {"BareNameLater", kStart + "mesh\n" + kMaterial + "a.obj\n", 12, "unknown kind of object \"a.obj\""},
    {"FirstErrorFirst", sphereWith("rad: 0\nrad: x\nfoo: 1"), 8, "more than 0"},
    {"LinesOfCrLf", "1\r\n\r\ncamera\r\nfov: x\r\n", 4, "not a number"},
};

INSTANTIATE_TEST_SUITE_P(All, ReadSceneFails, testing::ValuesIn(kBadScenes),
                         [](const auto& test) { return test.param.name; });

TEST(ReadScene, ErrorInsideAMeshIsAtItsLine) {
  const auto mesh = writeFile("bad.obj", kObj + "f 1 x\n");
  const auto scene = writeFile("scene.txt", kStart + "mesh\nfile: bad.obj\n" + kMaterial);
  expectMessage(inputError([&] { readScene(scene); }), mesh, 5, "\"x\" is not a corner");
}

TEST(ReadScene, UnreadableFiles) {
  const auto folder = testFolder();
  EXPECT_EQ(inputError([&] { readScene(folder); }), folder.string() + ": cannot be read: Is a directory");
  const auto missing = folder / "missing.txt";
  EXPECT_EQ(inputError([&] { readScene(missing); }),
            missing.string() + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace lavaray
