#include <lavaray/renderer.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "library/scenes.hpp"

namespace lavaray {
namespace {

const Renderer& renderer() {
  static const auto* renderer = new Renderer;
  return *renderer;
}

std::vector<float> rendered(const Scene& scene, std::uint32_t samples = 4) {
  RenderOptions options;
  options.samples = samples;
  return renderer().render(scene, options).image.rgb;
}

// What `work` throws; a test fails where it throws nothing.
Error errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {ErrorKind::kInternal, ""};
}

std::filesystem::path scratch() {
  const auto folder =
      std::filesystem::path(testing::TempDir()) /
      ("lavaray-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(LibraryScene, SummaryTellsSphericalLights) {
  Scene scene = objectScene();
  Light point{{1, 2, 3}, {}, {1, 1, 1}, {}, {}};
  scene.add(point);
  EXPECT_EQ(scene.summary().lights, 2U);
  EXPECT_EQ(scene.summary().sphericalLights, 1U);
  scene.setDefaults({0.0, 0.25});
  EXPECT_EQ(scene.summary().sphericalLights, 2U);
}

TEST(LibraryScene, ObjectsGiveThePictureOfTheirText) {
  EXPECT_EQ(rendered(objectScene()), rendered(Scene::parse(kText)));
}

TEST(LibraryScene, MeshOfArraysGivesThePictureOfItsFile) {
  const std::filesystem::path folder = scratch();
  std::ofstream obj(folder / "octahedron.obj");
  const Mesh mesh = octahedron({1.5, 1, 1});
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3)
    obj << "v " << mesh.vertices[i] << ' ' << mesh.vertices[i + 1] << ' ' << mesh.vertices[i + 2] << '\n';
  for (std::size_t i = 0; i < mesh.faces.size(); i += 3)
    obj << "f " << mesh.faces[i] + 1 << ' ' << mesh.faces[i + 1] + 1 << ' ' << mesh.faces[i + 2] + 1 << '\n';
  obj.close();
  std::ofstream(folder / "scene.txt") << kText
                                      << "mesh\nfile: octahedron.obj\namb: 0.2 0.4 0.9\n"
                                         "dif: 0.2 0.4 0.9\nspe: 0 0 0\nshi: 0\n";
  Scene objects = objectScene();
  objects.add(mesh);
  const Scene read = Scene::read(folder / "scene.txt");
  EXPECT_EQ(rendered(objects), rendered(read));
  EXPECT_NE(rendered(objects), rendered(objectScene()));
  EXPECT_EQ(read.files(), (Scene::Files{folder / "scene.txt", folder / "octahedron.obj"}));
  ASSERT_EQ(read.warnings().size(), 1U);  // of the number in line 1
  EXPECT_EQ(objects.summary().meshTriangles, 8U);
}

TEST(LibraryScene, NormalsOfVerticesAreNumberedAsThese) {
  Scene numbered = objectScene();
  Mesh mesh = octahedron({1.5, 1, 1});
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.normals.push_back(mesh.vertices[i] - (i % 3 == 0 ? 1.5 : 1.0));
  numbered.add(mesh);
  mesh.corners = mesh.faces;
  Scene stated = objectScene();
  stated.add(mesh);
  EXPECT_EQ(rendered(numbered), rendered(stated));
  Scene flat = objectScene();
  flat.add(octahedron({1.5, 1, 1}));
  EXPECT_NE(rendered(numbered), rendered(flat));
}

TEST(LibraryScene, ChangesOfACopyStayThere) {
  const Scene scene = objectScene();
  const std::vector<float> before = rendered(scene);
  Scene copy = scene;
  copy.add(Sphere{{2, 1, 2}, 0.5, {}});
  EXPECT_NE(rendered(copy), before);
  EXPECT_EQ(rendered(scene), before);
}

TEST(LibraryScene, RereadSeesWhatHasChanged) {
  const std::filesystem::path file = scratch() / "scene.txt";
  std::ofstream(file) << kText;
  Scene scene = Scene::read(file);
  const std::vector<float> before = rendered(scene);
  std::string text = kText;
  text.replace(text.find("dif: 0.8"), 8, "dif: 0.1");  // the geometry stays
  std::ofstream(file) << text;
  EXPECT_FALSE(scene.reread({"another.txt"}));
  EXPECT_TRUE(scene.reread({file}));
  EXPECT_EQ(rendered(scene), rendered(Scene::parse(text)));
  EXPECT_NE(rendered(scene), before);
  std::ofstream(file) << "1\ncube\n";
  EXPECT_EQ(errorOf([&] { scene.reread({file}); }).line(), 2U);
  EXPECT_EQ(rendered(scene), rendered(Scene::parse(text)));
}

TEST(LibraryScene, ErrorsNameFileAndLine) {
  const Error error = errorOf([] { Scene::parse("1\ncamera\npos: 0 0\n", "my.txt"); });
  EXPECT_EQ(error.kind(), ErrorKind::kInput);
  EXPECT_EQ(error.file(), "my.txt");
  EXPECT_EQ(error.line(), 3U);
  EXPECT_STREQ(error.what(), "my.txt:3: `pos` has 2 numbers, allowed are exactly 3");
  const Error missing = errorOf([] { Scene::read("/nowhere/scene.txt"); });
  EXPECT_EQ(missing.kind(), ErrorKind::kInput);
  EXPECT_EQ(missing.file(), "/nowhere/scene.txt");
}

TEST(LibraryScene, ObjectsOutOfRangeAreRefusedAndChangeNothing) {
  Scene scene = objectScene();
  const std::vector<float> before = rendered(scene);
  const auto expect = [&](const auto& object, const std::string& message) {
    const Error error = errorOf([&] { scene.add(object); });
    EXPECT_EQ(error.what(), message);
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
  };
  expect(Sphere{{0, 0, 0}, 0.0, {}}, "a sphere's radius is 0, allowed is more than 0");
  expect(Sphere{{NAN, 0, 0}, 1.0, {}},
         "a number of a sphere's centre is nan, allowed is a number within +-1e+15");
  expect(Plane{{0, 0, 0}, {}, {}}, "a plane's normal is 0 0 0, allowed is any other vector");
  expect(Triangle{}, "a triangle without area, allowed are three corners that are not on a line");
  expect(Light{{}, {}, {-1, 0, 0}, {}, {}},
         "a number of a light's diffuse colour is -1, allowed is 0 or more");
  Mesh mesh = octahedron({0, 0, 0});
  mesh.faces[4] = 6;
  expect(mesh, "a mesh's faces have 6 in triangle 1, allowed are numbers below 6");
  mesh.faces.pop_back();
  expect(mesh, "a mesh's faces are 23 numbers, allowed are three for each triangle");
  EXPECT_THROW(scene.setCamera({{}, 180.0, 1.0, 1.0}), Error);
  EXPECT_EQ(rendered(scene), before);
}

}  // namespace
}  // namespace lavaray
