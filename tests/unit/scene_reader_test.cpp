#include "scene/scene_reader.hpp"

#include <locale>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "support/input_files.hpp"

namespace lavaray {
namespace {

// Blocks of a scene; those with a material take kMaterial behind them.
const std::string kCamera = "camera\npos: 0 0 0\nfov: 60\nf: 100\na: 1.5\n";  // 5 lines
const std::string kMaterial = "amb: 0.1 0.2 0.3\ndif: 0.4 0.5 0.6\nspe: 0.7 0.8 0.9\nshi: 10\n";
const std::string kSphere = "sphere\npos: 1 2 3\nrad: 4\n" + kMaterial;  // 7 lines
const std::string kLight = "light\npos: 1 2 3\namb: 0.1 0.1 0.1\ndif: 0.2 0.2 0.2\nspe: 0.3 0.3 0.3\n";
const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Scene read(std::string_view content) {
  return readScene(writeFile("scene.txt", content));
}

TEST(ReadScene, EveryKindAndKey) {
  writeFile("mesh.obj", kObj);
  const Scene scene = read(
      "6\n"
      "plane\nnor: 0 2 0\npos: 0 -5 0\n" +
      kMaterial + kSphere + kCamera + kLight + "rad: 0.5\ntriangle\nv1: 0 0 0\nv2: 1 0 0\nv3: 0 1 0\n" +
      kMaterial + "ref: 0.25 0.5 1.5\nmesh\nfile: mesh.obj\n" + kMaterial);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.file.filename(), "scene.txt");

  EXPECT_EQ(scene.camera.position, glm::dvec3(0.0));
  EXPECT_EQ(scene.camera.fovDegrees, 60.0);
  EXPECT_EQ(scene.camera.focalLength, 100.0);
  EXPECT_EQ(scene.camera.aspect, 1.5);

  ASSERT_EQ(scene.planes.size(), 1U);
  EXPECT_EQ(scene.planes[0].normal, glm::dvec3(0, 2, 0));
  EXPECT_EQ(scene.planes[0].point, glm::dvec3(0, -5, 0));
  EXPECT_EQ(scene.planes[0].object, 0U);
  ASSERT_EQ(scene.spheres.size(), 1U);
  EXPECT_EQ(scene.spheres[0].center, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.spheres[0].radius, 4.0);
  EXPECT_EQ(scene.spheres[0].object, 1U);
  ASSERT_EQ(scene.triangles.size(), 1U);
  EXPECT_EQ(scene.triangles[0].vertices[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(scene.triangles[0].object, 2U);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1U);
  ASSERT_EQ(scene.meshObjects.size(), 1U);
  EXPECT_EQ(scene.meshObjects[0].mesh, 0U);
  EXPECT_EQ(scene.meshObjects[0].object, 3U);

  ASSERT_EQ(scene.materials.size(), 4U);
  EXPECT_EQ(scene.materials[0].ambient, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(scene.materials[0].diffuse, glm::dvec3(0.4, 0.5, 0.6));
  EXPECT_EQ(scene.materials[0].specular, glm::dvec3(0.7, 0.8, 0.9));
  EXPECT_EQ(scene.materials[0].shininess, 10.0);
  EXPECT_EQ(scene.materials[0].reflectance, glm::dvec3(0.0));
  EXPECT_EQ(scene.materials[2].reflectance, glm::dvec3(0.25, 0.5, 1.5));

  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.lights[0].ambient, glm::dvec3(0.1));
  EXPECT_EQ(scene.lights[0].diffuse, glm::dvec3(0.2));
  EXPECT_EQ(scene.lights[0].specular, glm::dvec3(0.3));
  EXPECT_EQ(scene.lights[0].radius, 0.5);
}

TEST(ReadScene, LightDefaultsAndOlderForm) {
  const Scene scene = read("3\n" + kCamera + "light\npos: 0 0 0\ndif: 1 2 3\nspe: 4 5 6\n" +
                           "light\ncol: 0.5 0.6 0.7\npos: 0 0 0\nrad: 2\n");
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].ambient, glm::dvec3(0.0));
  EXPECT_EQ(scene.lights[0].radius, 0.0);
  EXPECT_EQ(scene.lights[1].ambient, glm::dvec3(0.0));
  EXPECT_EQ(scene.lights[1].diffuse, glm::dvec3(0.5, 0.6, 0.7));
  EXPECT_EQ(scene.lights[1].specular, glm::dvec3(0.5, 0.6, 0.7));
  EXPECT_EQ(scene.lights[1].radius, 2.0);
}

TEST(ReadScene, CameraAloneIsAScene) {
  const Scene scene = read("1\n" + kCamera);
  EXPECT_TRUE(scene.materials.empty());
  EXPECT_TRUE(scene.lights.empty());
}

TEST(ReadScene, LineEndsAndBlanks) {
  const std::string plain = "2\ncamera\npos: 0 0 0\nfov: 60\nf: 100\na: 1.5\nlight\npos: 1 2 3\ncol: 1 1 1";
  const std::string variants[] = {
      plain,
      "\xEF\xBB\xBF" + plain + "\n",
      plain + "\n\n\r\n \t\n",
      "2\r\ncamera\r\npos: 0 0 0\nfov: 60\r\nf: 100\na: 1.5\r\nlight\npos: 1 2 3\r\ncol: 1 1 1\r\n",
      "2\rcamera\rpos: 0 0 0\rfov: 60\rf: 100\ra: 1.5\rlight\rpos: 1 2 3\rcol: 1 1 1\r",
      " +2 \t\n\n camera \n\npos:0 0 0\n\tfov : 60 \n\n\nf :100\na:1.5\n\nlight\t\npos:\t1\t2\t3\t\ncol: 1 1 "
      " 1\n",
      "02\ncamera\npos: +0 -0 0e99\nfov: 6e1\nf: +1E2\na: 1.5000\nlight\npos: 1. 2.0 +3\ncol: 1 1 1",
  };
  for (const std::string& variant : variants) {
    const Scene scene = read(variant);
    EXPECT_TRUE(scene.warnings.empty()) << variant;
    EXPECT_EQ(scene.camera.focalLength, 100.0) << variant;
    ASSERT_EQ(scene.lights.size(), 1U) << variant;
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3)) << variant;
  }
}

TEST(ReadScene, WrongCountWarns) {
  const std::string counts[] = {"0", "2", "-1", "+7", "1" + std::string(200, '0'), "-00"};
  for (const std::string& count : counts) {
    const auto file = writeFile("scene.txt", count + "\n" + kCamera);
    const Scene scene = readScene(file);
    ASSERT_EQ(scene.warnings.size(), 1U) << count;
    EXPECT_EQ(scene.warnings[0], file.string() + ":1: the file says " + count + " objects, there are 1");
  }
  EXPECT_TRUE(read("0001\n" + kCamera).warnings.empty());
}

TEST(ReadScene, NamesOfMeshes) {
  writeFile("mesh.obj", kObj);
  writeFile("my mesh: 2.obj", kObj);
  const std::string starts[] = {"mesh\nfile: mesh.obj\n",
                                "model\nfile:mesh.obj\n",
                                "mesh\nfile: \"mesh.obj\"\n",
                                "model\nmesh.obj\n",
                                "mesh\n\n  mesh.obj \r\n",
                                "mesh\n\"mesh.obj\"\n",
                                "mesh\nfile: my mesh: 2.obj\n",
                                "mesh\n\"my mesh: 2.obj\"\n",
                                "mesh\nfile: " + (testFolder() / "mesh.obj").string() + "\n"};
  for (const std::string& start : starts) {
    const Scene scene = read("2\n" + start + kMaterial + kCamera);
    ASSERT_EQ(scene.meshes.size(), 1U) << start;
    EXPECT_EQ(scene.meshes[0].triangles.size(), 1U) << start;
  }
  EXPECT_EQ(read("2\nmesh\n" + kMaterial + "file: mesh.obj\n" + kCamera).meshes.size(), 1U);
}

TEST(ReadScene, AMeshNamedTwiceIsReadOnce) {
  writeFile("a.obj", kObj);
  writeFile("b.obj", kObj);
  const Scene scene = read("5\n" + kCamera + "mesh\nfile: a.obj\n" + kMaterial + "mesh\nfile: b.obj\n" +
                           kMaterial + "mesh\nfile: ./x/../a.obj\n" + kMaterial + kSphere);
  EXPECT_EQ(scene.meshes.size(), 2U);
  ASSERT_EQ(scene.meshObjects.size(), 3U);
  EXPECT_EQ(scene.meshObjects[2].mesh, 0U);
  EXPECT_EQ(scene.meshObjects[2].object, 2U);
  EXPECT_EQ(scene.spheres[0].object, 3U);
}

TEST(ReadScene, TinyNormalIsANormal) {
  const Scene scene = read("2\n" + kCamera + "plane\nnor: 0 1e-310 0\npos: 0 0 0\n" + kMaterial);
  EXPECT_EQ(scene.planes[0].normal.y, 1e-310);
}

TEST(ReadScene, LocaleDoesNotMatter) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const Scene scene = read("1\n" + kCamera);
  std::locale::global(before);
  EXPECT_EQ(scene.camera.aspect, 1.5);
}

struct BadScene {
  std::string name;
  std::string content;
  std::size_t line;
  std::string words;
};

// In the names of the tests.
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

// One key of a sphere, in line 8.
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

TEST(ReadScene, WarningsOfAMeshAreTheScenesOnce) {
  const auto mesh = writeFile("odd.obj", kObj + "f 1 2\n");
  const std::string block = "mesh\nfile: odd.obj\n" + kMaterial;
  const Scene scene = readScene(writeFile("scene.txt", "3\n" + kCamera + block + block));
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_EQ(scene.warnings[0], mesh.string() + ":5: 1 face of one or two corners is dropped");
}

TEST(ReadScene, UnreadableFiles) {
  const auto folder = testFolder();
  EXPECT_EQ(inputError([&] { readScene(folder); }), folder.string() + ": cannot be read: Is a directory");
  const auto missing = folder / "missing.txt";
  EXPECT_EQ(inputError([&] { readScene(missing); }),
            missing.string() + ": cannot be read: No such file or directory");
}

struct SharedScene {
  std::string file;
  std::size_t planes, spheres, triangles, meshes, lights;
};

// In the names of the tests.
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

// The mesh of the assignment's own sample is public nowhere.
TEST(ReadScene, AssignmentSampleLacksItsMesh) {
  const auto file = std::filesystem::path(LAVARAY_SHARED_DIR) / "course" / "handout_sample.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  expectMessage(inputError([&] { readScene(file); }), file, 27, "statue.obj: cannot be read");
}

}  // namespace
}  // namespace lavaray
