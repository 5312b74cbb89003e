#include "scene/scene_reader.hpp"

#include <locale>
#include <string>

#include <gtest/gtest.h>

#include "support/input_files.hpp"
#include "unit/scene_blocks.hpp"

namespace lavaray {
namespace {

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

TEST(ReadScene, WarningsOfAMeshAreTheScenesOnce) {
  const auto mesh = writeFile("odd.obj", kObj + "f 1 2\n");
  const std::string block = "mesh\nfile: odd.obj\n" + kMaterial;
  const Scene scene = readScene(writeFile("scene.txt", "3\n" + kCamera + block + block));
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_EQ(scene.warnings[0], mesh.string() + ":5: 1 face of one or two corners is dropped");
}

}  // namespace
}  // namespace lavaray
