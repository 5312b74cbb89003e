// How the oracle lights what it sees, against answers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.hpp"
#include "unit/oracle_scenes.hpp"

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Pixel;

TEST(Oracle, ShadesASphereByTheFormula) {
  Scene scene = emptyScene();
  addSphere(scene, dvec3(0.0, 0.0, -10.0), 2.0);
  scene.lights = {lightAt(dvec3(3.0, 0.0, -4.0))};
  // At (0, 0, -8): n = (0, 0, 1), l = (0.6, 0, 0.8), r = (-0.6, 0, 0.8), v = n.
  const Pixel pixel = pixelAt(scene, 50, 50);
  expectColor(pixel, phong(0.8, 0.64));
  EXPECT_FALSE(pixel.uncertain);
  expectColor(pixelAt(scene, 0, 0), dvec3(0.0));
}

TEST(Oracle, ShadowShowsExactlyTheAmbientReflection) {
  Scene scene = emptyScene();
  addPlane(scene, dvec3(0.0, 1.0, 0.0), dvec3(0.0, -1.0, 0.0));
  addSphere(scene, dvec3(0.0, 1.0, -5.05), 0.5);
  scene.lights = {lightAt(dvec3(0.0, 5.0, -5.05))};
  // The pixel (50, 60) sees (0, -1, -5.05), right below the sphere and the light.
  const Pixel shadow = pixelAt(scene, 50, 60);
  expectColor(shadow, kMaterial.ambient);
  EXPECT_FALSE(shadow.uncertain);
  EXPECT_GT(pixelAt(scene, 20, 60).color.x, kMaterial.ambient.x + 0.05);
}

TEST(Oracle, TurnsInterpolatedNormalsByTheSideOfTheirFace) {
  for (const bool reversed : {false, true}) {
    for (const double side : {2.0, -3.0}) {
      Scene scene = emptyScene();
      addMesh(scene, side * dvec3(0.6, 0.0, 0.8), reversed);
      scene.lights = {lightAt(dvec3(6.0, 0.0, -2.0))};  // along the normal
      // r = l = n, r.v = 0.8.
      expectColor(pixelAt(scene, 50, 50), phong(1.0, 0.64));
    }
  }
}

TEST(Oracle, KeepsANormalThatPointsAwayOnAFaceSeenFromTheFront) {
  Scene scene = emptyScene();
  addMesh(scene, dvec3(0.8, 0.0, 0.6));
  // The pixel (100, 50) looks along (50, 0, -50.5): towards the face, yet along its normal.
  const dvec3 point = dvec3(50.0, 0.0, -50.5) * (10.0 / 50.5);
  scene.lights = {lightAt(point + dvec3(0.8, 0.0, 0.6))};
  expectColor(pixelAt(scene, 100, 50), phong(1.0, 0.0));
}

TEST(Oracle, TakesTheFaceNormalWhereTheInterpolatedOneVanishes) {
  Scene scene = emptyScene();
  addMesh(scene, dvec3(0.0));
  scene.lights = {lightAt(dvec3(3.0, 0.0, -6.0))};
  expectColor(pixelAt(scene, 50, 50), phong(0.8, 0.64));
}

TEST(Oracle, CoincidentFacesDoNotShadowEachOther) {
  Scene scene = emptyScene();
  addMesh(scene, dvec3(0.0, 0.0, 1.0), false, 3);
  scene.lights = {lightAt(dvec3(3.0, 0.0, -6.0))};
  const Pixel pixel = pixelAt(scene, 50, 50);
  expectColor(pixel, phong(0.8, 0.64));
  EXPECT_FALSE(pixel.uncertain);
}

TEST(Oracle, ASurfaceThroughTheLightDoesNotBlockIt) {
  // The pixel (10, 50) sees the plane beside the triangle or sphere at the light.
  Scene scene = emptyScene();
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0));
  scene.lights = {lightAt(dvec3(0.0, 0.0, -5.0))};
  const dvec3 lit = pixelAt(scene, 10, 50).color;
  EXPECT_GT(lit.x, kMaterial.ambient.x);

  Scene triangle = scene;
  const std::uint32_t object = addMaterial(triangle);
  triangle.triangles.push_back(
      {{dvec3(-1.0, -1.0, -5.0), dvec3(1.0, -1.0, -5.0), dvec3(0.0, 1.0, -5.0)}, object});
  expectColor(pixelAt(triangle, 10, 50), lit);
  triangle.lights[0].position.z = -4.9;
  expectColor(pixelAt(triangle, 10, 50), kMaterial.ambient);

  Scene sphere = scene;
  addSphere(sphere, dvec3(0.0, 0.0, -4.0), 1.0);
  expectColor(pixelAt(sphere, 10, 50), lit);
  sphere.spheres[0].center.z = -6.0;  // now the light is on the far side
  expectColor(pixelAt(sphere, 10, 50), kMaterial.ambient);
}

TEST(Oracle, ALightBehindASurfaceGivesItsAmbientTermOnly) {
  Scene scene = emptyScene();
  Material rough = kMaterial;
  rough.shininess = 0.0;
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), rough);
  scene.lights = {lightAt(dvec3(3.0, 0.0, -14.0))};
  expectColor(pixelAt(scene, 50, 50), phong(0.0, 0.0));
  // The same for the far side of a sphere.
  Scene sphere = emptyScene();
  addSphere(sphere, dvec3(0.0, 0.0, -10.0), 2.0);
  sphere.lights = {lightAt(dvec3(0.0, 0.0, -20.0))};
  expectColor(pixelAt(sphere, 50, 50), phong(0.0, 0.0));
}

TEST(Oracle, ShininessZeroIsOneEvenWhereTheHighlightPointsAway) {
  Scene scene = emptyScene();
  Material rough = kMaterial;
  rough.shininess = 0.0;
  addPlane(scene, dvec3(1.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), rough);
  // n = (1, 0, 1) / sqrt 2, l = (0, 0, 1), r = (1, 0, 0): r.v = 0.
  scene.lights = {lightAt(dvec3(0.0, 0.0, -5.0))};
  expectColor(pixelAt(scene, 50, 50), phong(std::sqrt(0.5), 1.0));
  // l = (-0.6, 0, 0.8), r = (0.8, 0, -0.6): r.v < 0.
  scene.lights = {lightAt(dvec3(-0.6, 0.0, -9.2))};
  expectColor(pixelAt(scene, 50, 50), phong(0.2 * std::sqrt(0.5), 1.0));
}

TEST(Oracle, ALightAtThePointGivesItsAmbientTermOnly) {
  Scene scene = emptyScene();
  addPlane(scene, dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0));
  scene.lights = {lightAt(dvec3(0.0, 0.0, -10.0))};
  const Pixel pixel = pixelAt(scene, 50, 50);
  expectColor(pixel, phong(0.0, 0.0));
  EXPECT_TRUE(pixel.uncertain);
}

}  // namespace
}  // namespace lavaray
