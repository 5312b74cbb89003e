// The view of costs: how many nodes and primitives a sample's rays test.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "device/counting_traversal.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "device/test_device.hpp"
#include "render/entry_nodes.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

constexpr int kSide = 80;

RenderSettings costSettings(std::uint32_t samples = 1) {
  RenderSettings settings = settingsFor({kSide, kSide}, samples);
  settings.view = View::kCost;
  return settings;
}

// The number that the picture stands for.
double costAt(const RenderResult& result, int x, int y) {
  const std::size_t pixel = static_cast<std::size_t>(y) * result.image.width + x;
  return double{result.image.rgb[3 * pixel]} * result.largestMeasure;
}

double sumOf(const RenderResult& result) {
  double sum = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) sum += costAt(result, i % kSide, i / kSide);
  return sum;
}

Scene emptyScene() {
  Scene scene;
  scene.camera = {{3, -2, 7}, 90.0, kSide / 2.0, 1.0};
  return scene;
}

void addBall(Scene& scene, const glm::dvec3& center, double radius, const Material& material) {
  scene.spheres.push_back({center, radius, addObject(scene, material)});
}

// Shines on all surfaces, so that no shadow ray is left out.
Light ambientLight(const glm::dvec3& position) {
  return {.position = position, .ambient = glm::dvec3(0.1)};
}

TEST(Cost, IsThatOfAllPrimitivesWhereTheyAreFew) {
  Scene scene = emptyScene();
  addBall(scene, {3, -2, -3}, 3.0, glow(glm::dvec3(0.5)));
  scene.planes.push_back({{0, 0, 1}, {0, 0, -20}, addObject(scene, glow(glm::dvec3(0.5)))});
  scene.planes.push_back({{0, 0, 1}, {0, 0, 50}, addObject(scene, glow(glm::dvec3(0.5)))});
  scene.lights = {ambientLight({3, 9, 3}), ambientLight({3, 0, -30})};
  for (const std::uint32_t samples : {1U, 4U}) {
    const RenderResult result = renderScene(scene, costSettings(samples));
    // The camera ray tests three. From the ball each shadow ray tests the planes, but the second one is
    // blocked by the first of them; from the plane they test the ball and the other plane.
    EXPECT_EQ(result.largestMeasure, 3 + 2 + 2);
    EXPECT_EQ(costAt(result, 0, 0), 3 + 2 + 2);
    EXPECT_NEAR(costAt(result, kSide / 2, kSide / 2), 3 + 2 + 1, 1e-6);
  }
}

TEST(Cost, IsThatOfThePlanesAloneWhereNothingElseIs) {
  Scene scene = emptyScene();
  EXPECT_EQ(renderScene(scene, costSettings()).largestMeasure, 0.0);
  for (int planes = 1; planes <= 5; ++planes) {
    const auto z = static_cast<double>(10 + planes);  // behind the camera: all is background
    scene.planes.push_back({{0, 0, 1}, {0, 0, z}, addObject(scene, glow(glm::dvec3(0.5)))});
    const RenderResult result = renderScene(scene, costSettings());
    EXPECT_EQ(result.largestMeasure, planes);
    for (const float value : result.image.rgb) EXPECT_EQ(value, 1.0F);
  }
}

// Each of three balls is tested by each ray that does not leave it: camera, mirror and shadow rays, in all
// directions to a spherical light.
TEST(Cost, AddsUpToTheTestsOfAllRays) {
  Scene scene = emptyScene();
  Material mirror = glow(glm::dvec3(0.1));
  mirror.reflectance = glm::dvec3(0.9);
  addBall(scene, {1, -3, -3}, 3.0, mirror);
  addBall(scene, {8, 1, -5}, 4.0, mirror);
  addBall(scene, {0, 2, -15}, 6.0, mirror);
  scene.lights = {ambientLight({0, 40, 10})};
  scene.lights.front().radius = 3.0;
  RenderSettings settings = costSettings(4);
  settings.maxDepth = 2;  // few enough for one dispatch, where the counters count no path twice
  const RenderResult result = renderScene(scene, settings);
  ASSERT_GT(result.counts.mirrorRays, 0U);
  ASSERT_GT(result.counts.shadowRays, result.counts.mirrorRays);
  const double sum = sumOf(result);
  const auto tests = static_cast<double>(3 * result.counts.samples +
                                         2 * (result.counts.mirrorRays + result.counts.shadowRays));
  EXPECT_NEAR(4.0 * sum, tests, 1e-6 * tests);
}

// A path that goes on in another dispatch counts nothing twice.
TEST(Cost, DoesNotDependOnDispatches) {
  for (const char* name : {"extensions", "thousand-spheres"}) {
    Scene scene = readNamed(name);
    scene.lights.resize(1);
    for (Material& material : scene.materials) material.reflectance = glm::dvec3(0.04);
    RenderSettings settings = settingsFor(reducedSize(scene.camera, 60), 4);
    settings.view = View::kCost;
    settings.maxDepth = 3;
    const RenderResult direct = renderScene(scene, settings);
    settings.maxDepth = 200;
    const RenderResult resumable = renderScene(scene, settings);
    EXPECT_GT(resumable.deviceBytes, direct.deviceBytes);
    EXPECT_EQ(direct.largestMeasure, resumable.largestMeasure);
    EXPECT_TRUE(sameBits(direct.image, resumable.image)) << name;
  }
}

// So many shadow rays that they are traced in several dispatches, through a tree and past a plane.
TEST(Cost, AddsUpOverDispatches) {
  constexpr std::uint32_t kLights = 700;
  Scene scene = emptyScene();
  for (int i = 0; i < 20; ++i)
    addBall(scene, {3 + 0.1 * i, 30, -9}, 0.02, glow(glm::dvec3(0.5)));  // out of sight
  scene.planes.push_back({{0, 0, 1}, {0, 0, -9}, addObject(scene, glow(glm::dvec3(0.01)))});
  RenderSettings settings = costSettings();
  const double ofCamera = renderScene(scene, settings).largestMeasure;
  EXPECT_EQ(ofCamera, 1.0);  // the plane
  // Below the balls, so that a ray tests the root alone.
  for (std::uint32_t i = 0; i < kLights; ++i) scene.lights.push_back({{3, -90, 5}, glm::dvec3(1e-3)});
  settings.crop = {0, kSide / 2, kSide, kSide};
  const RenderResult result = renderScene(scene, settings);
  EXPECT_GT(result.counts.dispatches, 1U);
  EXPECT_EQ(result.largestMeasure, ofCamera + kLights);
  for (const float value : result.image.rgb) EXPECT_EQ(value, 1.0F);
}

// Random balls, all before the camera, and a light.
Scene manyBalls() {
  Random random(16);
  Scene scene = emptyScene();
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 center = scene.camera.position + glm::dvec3(0, 0, -30) + randomPoint(random, 20.0);
    addBall(scene, center, uniform(random, 0.2, 1.5), glow(glm::dvec3(0.5)));
  }
  scene.lights = {ambientLight({-20, 60, 40})};
  return scene;
}

// Compares the pixels with what a search on the host tests, where that starts as `startOf` says.
// Returns all pixels' costs together.
template <typename StartOf>
double expectTestsOfHost(const GpuScene& scene, const RenderResult& result, const StartOf& startOf) {
  int clear = 0;
  int litFrom = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const int x = i % kSide;
    const int y = i / kSide;
    const glm::dvec3 direction(x + 0.5 - kSide / 2.0, kSide / 2.0 - y - 0.5, -kSide / 2.0);
    CountedSearch seen{glm::dvec3(0.0), direction, INFINITY, 0xFFFFFFFF};
    run(scene, startOf(x, y), seen);
    std::uint32_t tests = seen.tests;
    bool isClear = seen.isClear;
    if (seen.hit != 0xFFFFFFFF) {
      const glm::dvec3 point = seen.end * direction;
      CountedSearch shadow{point, glm::dvec3(scene.lights.front().position) - point, 1.0, seen.hit, true};
      run(scene, gpu::kRootGroup, shadow);
      tests += shadow.tests;
      isClear = isClear && shadow.isClear;
      litFrom += shadow.isClear && shadow.hit == 0xFFFFFFFF ? 1 : 0;
    }
    if (!isClear) continue;
    ++clear;
    EXPECT_EQ(std::round(costAt(result, x, y)), tests) << "pixel " << x << ',' << y;
  }
  EXPECT_GT(clear, kSide * kSide * 95 / 100);
  EXPECT_GT(litFrom, 100);
  std::cout << clear << " of " << kSide * kSide << " pixels are clear, at most " << result.largestMeasure
            << " tests\n";
  return sumOf(result);
}

TEST(Cost, IsThatOfASearchOnTheHost) {
  const Scene scene = manyBalls();
  const GpuScene flat = flatten(scene, 2);
  RenderSettings settings = costSettings();
  const EntryNodes nodes = entryNodes(flat, settings, settings.crop);
  const auto entryGroup = [&](int x, int y) {
    const auto column = static_cast<std::uint32_t>(x) >> nodes.shift;
    const auto row = static_cast<std::uint32_t>(y) >> nodes.shift;
    return nodes.groups[std::size_t{row} * nodes.across + column];
  };
  const auto root = [](int, int) { return gpu::kRootGroup; };
  const double fromTiles = expectTestsOfHost(flat, render(testDevice(), flat, settings), entryGroup);
  settings.specialized = false;
  const double fromRoot = expectTestsOfHost(flat, render(testDevice(), flat, settings), root);
  EXPECT_LT(fromTiles, 0.99 * fromRoot);
}

// Of whole tiles, which start where they start in the whole.
TEST(Cost, OfAPartIsThatOfTheWhole) {
  const Scene scene = manyBalls();
  RenderSettings settings = costSettings(2);
  const RenderResult whole = renderScene(scene, settings);
  settings.crop = {16, 24, 64, 56};
  const RenderResult part = renderScene(scene, settings);
  for (int y = settings.crop.y0; y < settings.crop.y1; ++y) {
    for (int x = settings.crop.x0; x < settings.crop.x1; ++x) {
      const double cost = costAt(part, x - settings.crop.x0, y - settings.crop.y0);
      EXPECT_EQ(std::round(2.0 * cost), std::round(2.0 * costAt(whole, x, y)));
    }
  }
}

}  // namespace
}  // namespace lavaray
