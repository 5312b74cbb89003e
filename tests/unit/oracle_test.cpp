#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "support/image_compare.hpp"

// The oracle against answers worked out by hand. The camera is at the origin with a field of 90 degrees and
// an image of 101 x 101 pixels, so that the pixel (50 + i, 50 + j) looks along (i, -j, -50.5).

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Pixel;

constexpr double kFocalLength = 50.5;
const Material kMaterial{dvec3(0.1, 0.15, 0.05), dvec3(0.3, 0.2, 0.4), dvec3(0.2, 0.3, 0.1), 2.0, dvec3(0.0)};
const Light kLight{dvec3(0.0), dvec3(0.5, 0.4, 0.3), dvec3(0.9, 1.0, 0.8), dvec3(0.6, 0.7, 0.8), 0.0};

Light lightAt(const dvec3& position) {
  Light light = kLight;
  light.position = position;
  return light;
}

// The format's formula for one visible light, the cosines given.
dvec3 phong(double diffuseCosine, double specularPower) {
  return kMaterial.ambient + kLight.ambient * kMaterial.ambient +
         kLight.diffuse * kMaterial.diffuse * diffuseCosine +
         kLight.specular * kMaterial.specular * specularPower;
}

Scene emptyScene() {
  Scene scene;
  scene.camera = {dvec3(0.0), 90.0, kFocalLength, 1.0};
  return scene;
}

std::uint32_t addMaterial(Scene& scene, const Material& material = kMaterial) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void addPlane(Scene& scene, const dvec3& normal, const dvec3& point, const Material& material = kMaterial) {
  scene.planes.push_back({normal, point, addMaterial(scene, material)});
}

void addSphere(Scene& scene, const dvec3& center, double radius, const Material& material = kMaterial) {
  scene.spheres.push_back({center, radius, addMaterial(scene, material)});
}

// A large triangle in the plane z = -10 with the same normal at each corner, `copies` times.
void addMesh(Scene& scene, const dvec3& normal, bool reversed = false, int copies = 1) {
  Mesh mesh;
  mesh.positions = {dvec3(-40.0, -40.0, -10.0), dvec3(40.0, -40.0, -10.0), dvec3(0.0, 80.0, -10.0)};
  mesh.normals = {normal};
  MeshTriangle triangle{{0, 1, 2}, {0, 0, 0}};
  if (reversed) triangle.positions = {0, 2, 1};
  mesh.triangles.assign(static_cast<std::size_t>(copies), triangle);
  scene.meshes.push_back(mesh);
  scene.meshObjects.push_back({scene.meshes.size() - 1, addMaterial(scene)});
}

Pixel pixelAt(const Scene& scene, int x, int y, int maxDepth = 8) {
  oracle::Options options;
  options.x0 = x;
  options.y0 = y;
  options.x1 = x + 1;
  options.y1 = y + 1;
  options.maxDepth = maxDepth;
  return oracle::render(scene, options).pixels.at(0);
}

void expectColor(const Pixel& pixel, const dvec3& expected) {
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(pixel.color[channel], expected[channel], 1e-12);
}

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
      // Shading alone changes less than this from pixel to pixel.
      if (glm::length(left.color - right.color) < 0.06) continue;
      ++changes;
      EXPECT_TRUE(left.uncertain || right.uncertain) << x << ", " << y;
    }
  }
  EXPECT_GT(changes, 100);
  EXPECT_FALSE(result.pixels[50 * 101 + 50].uncertain);
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
  // A light inside the sphere is behind the sphere's near side, seen from the plane.
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
  // Not clamped before the multiplication.
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
  // The pixel (100, 50) looks along (50, 0, -50.5): against the face, yet along the normal.
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
  scene.materials[1] = first;  // now it does not matter which
  EXPECT_FALSE(pixelAt(scene, 51, 52).uncertain);
}

TEST(Oracle, ASurfaceThroughTheLightDoesNotBlockIt) {
  // The pixel (10, 50) sees the plane past the triangle or the sphere at the light.
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

TEST(ImageCompare, CountsCertainPixelsThatAreOff) {
  oracle::Result expected{2, 2, std::vector<Pixel>(4, {dvec3(0.5), false})};
  expected.pixels[3].uncertain = true;
  std::vector<float> rgb(12, 0.5F);
  EXPECT_EQ(compare(rgb, expected).wrong, 0);
  rgb[1] += 0.9F / 255.0F;  // less than a level
  rgb[5] += 2.0F / 255.0F;
  rgb[6] = std::numeric_limits<float>::quiet_NaN();
  rgb[9] = 0.0F;  // uncertain
  const Comparison comparison = compare(rgb, expected);
  EXPECT_EQ(comparison.total, 4);
  EXPECT_EQ(comparison.uncertain, 1);
  EXPECT_EQ(comparison.wrong, 2);
  EXPECT_EQ(comparison.maxX, 0);
  EXPECT_EQ(comparison.maxY, 1);
  rgb.pop_back();
  EXPECT_THROW(compare(rgb, expected), std::invalid_argument);
}

TEST(ImageCompare, KnowsWhatIsOnTheOtherSideOfAnEdge) {
  // A ray through the horizon of a plane sees it or not.
  Scene scene;
  scene.camera = {{0, 0, 0}, 90.0, 1.5, 1.0};
  scene.materials = {{.ambient = {0.5, 0.25, 0.75}}};
  scene.planes = {{{0, 1, 0}, {0, -1, 0}, 0}};
  const oracle::Result image = oracle::render(scene);
  ASSERT_EQ(image.height, 3);
  const Pixel& horizon = image.pixels[4];
  ASSERT_TRUE(horizon.uncertain);
  EXPECT_TRUE(showsAlternative({0.0F, 0.0F, 0.0F}, 0, horizon));
  EXPECT_TRUE(showsAlternative({0.5F, 0.25F, 0.75F}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.25F, 0.125F, 0.375F}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.5F, 0.25F, std::numeric_limits<float>::quiet_NaN()}, 0, horizon));
  EXPECT_FALSE(showsAlternative({0.5F, 0.25F, 0.75F}, 0, image.pixels[7]));  // certain
}

TEST(ImageCompare, ForgivesEdgesOfByteImages) {
  oracle::Result oracle{4, 1, std::vector<Pixel>(4, {dvec3(0.5), false})};
  const std::vector<std::uint8_t> expected = truncatedBytes(oracle);
  EXPECT_EQ(expected, std::vector<std::uint8_t>(12, 127));
  EXPECT_EQ(truncatedBytes(oracle, true), std::vector<std::uint8_t>(12, 255));
  oracle.pixels[0].uncertain = true;
  std::vector<std::uint8_t> actual = expected;
  actual[4] = 0;    // next to the edge
  actual[8] = 126;  // one level
  actual[11] = 130;
  const ByteComparison comparison = compareBytes(actual, expected, oracle);
  EXPECT_EQ(comparison.differing, 3);
  EXPECT_EQ(comparison.maxDifference, 127);
  EXPECT_EQ(comparison.wrong, 1);
}

}  // namespace
}  // namespace lavaray
