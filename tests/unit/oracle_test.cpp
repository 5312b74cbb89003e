// What the oracle sees, against answers worked out by hand.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "unit/oracle_scenes.hpp"

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Pixel;

TEST(Oracle, MarksSilhouettesAndShadowEdges) {
  Scene scene = emptyScene();
  addSphere(scene, dvec3(0.0, 0.0, -10.0), 4.0);
  addPlane(scene, dvec3(0.0, 1.0, 0.0), dvec3(0.0, -5.0, 0.0));
  scene.lights = {lightAt(dvec3(0.0, 20.0, -10.0))};
  oracle::Options options;
  options.probeOffset = 0.5;
  const oracle::Result result = oracle::render(scene, options);
  int changes = 0;
  for (int y = 0; y < 101; ++y) {
    for (int x = 1; x < 101; ++x) {
      const Pixel& left = result.pixels[static_cast<std::size_t>(y * 101 + x - 1)];
      const Pixel& right = result.pixels[static_cast<std::size_t>(y * 101 + x)];
      // Shading alone varies less than this from one pixel to the next.
      if (glm::length(left.color - right.color) < 0.06) continue;
      ++changes;
      EXPECT_TRUE(left.uncertain || right.uncertain) << x << ", " << y;
    }
  }
  EXPECT_GT(changes, 100);
  EXPECT_FALSE(result.pixels[50 * 101 + 50].uncertain);
}

TEST(Oracle, PlanesAreSeenFromBothSides) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = emptyScene();
    addPlane(scene, dvec3(0.0, 0.0, 7.0 * side), dvec3(3.0, 2.0, -10.0));
    scene.lights = {lightAt(dvec3(3.0, 0.0, -6.0))};
    // l = (0.6, 0, 0.8) at (0, 0, -10).
    expectColor(pixelAt(scene, 50, 50), phong(0.8, 0.64));
  }
}

TEST(Oracle, SpheresAreInvisibleFromInside) {
  Scene scene = emptyScene();
  addSphere(scene, dvec3(0.0), 5.0);
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0));
  scene.lights = {lightAt(dvec3(3.0, 0.0, -6.0))};
  expectColor(pixelAt(scene, 50, 50), phong(0.8, 0.64));
  // Seen from the plane, a light inside the sphere is hidden by the sphere's near side.
  scene.lights = {lightAt(dvec3(0.0, 0.0, 1.0))};
  expectColor(pixelAt(scene, 50, 50), kMaterial.ambient);
}

TEST(Oracle, MirrorsAddWhatTheySee) {
  Scene scene = emptyScene();
  Material mirror = kMaterial;
  mirror.reflectance = dvec3(0.5, 0.25, 1.0);
  Material back;
  back.ambient = dvec3(0.2, 0.4, 0.6);
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), mirror);
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, 4.0), back);
  expectColor(pixelAt(scene, 50, 50), mirror.ambient + mirror.reflectance * back.ambient);
  // The reflected colour is not clamped before it is multiplied.
  scene.materials[1].ambient = dvec3(1.2, 3.0, 0.1);
  expectColor(pixelAt(scene, 50, 50), mirror.ambient + mirror.reflectance * scene.materials[1].ambient);
  expectColor(pixelAt(scene, 50, 50, 0), mirror.ambient);
}

TEST(Oracle, ParallelMirrorsEndAtTheDepthOrWhereRaysCountForNothing) {
  for (const auto& [reflectance, maxDepth, rays] : {std::tuple{0.5, 8, 8}, {0.5, 2, 2}, {0.009, 8, 1}}) {
    Scene scene = emptyScene();
    Material mirror;
    mirror.ambient = dvec3(0.1);
    mirror.reflectance = dvec3(reflectance);
    addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), mirror);
    addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, 4.0), mirror);
    double sum = 0.0;
    for (int depth = 0; depth <= rays; ++depth) sum += 0.1 * std::pow(reflectance, depth);
    expectColor(pixelAt(scene, 50, 50, maxDepth), dvec3(sum));
  }
}

TEST(Oracle, OfCoincidentSurfacesTheFirstOfTheSceneIsSeen) {
  Scene scene = emptyScene();
  Material first;
  first.ambient = dvec3(0.25);
  const std::uint32_t object = addMaterial(scene, first);
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0));
  scene.triangles.push_back(
      {{dvec3(-9.0, -9.0, -10.0), dvec3(9.0, -9.0, -10.0), dvec3(0.0, 9.0, -10.0)}, object});
  const Pixel pixel = pixelAt(scene, 51, 52);
  expectColor(pixel, first.ambient);
  EXPECT_TRUE(pixel.uncertain);
  scene.materials[1] = first;  // now either may be seen
  EXPECT_FALSE(pixelAt(scene, 51, 52).uncertain);
}

TEST(Oracle, AnotherSizeShowsTheSameRectangle) {
  Scene scene = emptyScene();
  addSphere(scene, dvec3(2.0, 1.0, -10.0), 4.0);
  scene.lights = {lightAt(dvec3(10.0, 10.0, 0.0))};
  const oracle::Result natural = oracle::render(scene);
  ASSERT_EQ(natural.width, 101);
  ASSERT_EQ(natural.height, 101);
  oracle::Options options;
  options.size = {303, 101};
  const oracle::Result wide = oracle::render(scene, options);
  ASSERT_EQ(wide.width, 303);
  for (std::size_t i = 0; i < natural.pixels.size(); ++i) {
    expectColor(wide.pixels[3 * i + 1], natural.pixels[i].color);
  }
}

TEST(Oracle, ACropIsPartOfTheWhole) {
  Scene scene = emptyScene();
  addSphere(scene, dvec3(2.0, 1.0, -10.0), 4.0);
  scene.lights = {lightAt(dvec3(10.0, 10.0, 0.0))};
  const oracle::Result whole = oracle::render(scene);
  oracle::Options options;
  options.x0 = 60;
  options.y0 = 30;
  options.x1 = 62;
  options.y1 = 33;
  const oracle::Result crop = oracle::render(scene, options);
  ASSERT_EQ(crop.pixels.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(crop.pixels[i].color, whole.pixels[(30 + i / 2) * 101 + 60 + i % 2].color);
  }
}

}  // namespace
}  // namespace lavaray
