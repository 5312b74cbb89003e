// What the layers of a picture hold, against closed forms.
#include "render/layer.hpp"
#include "bvh/flatten.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "bvh/frame.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "device/test_device.hpp"

namespace lavaray {
namespace {

constexpr int kSide = 60;

// A camera that is not in the origin before a ball, the second object, whose first one is out of sight; all
// lengths times `unit`.
Scene ballBeside(double unit) {
  Scene scene;
  scene.camera = {glm::dvec3(3, -2, 7) * unit, 90.0, kSide / 2.0, 1.0};
  scene.spheres.push_back({glm::dvec3(0, 0, 90) * unit, unit, addObject(scene, glow(glm::dvec3(0.5)))});
  scene.spheres.push_back(
      {glm::dvec3(1, -3, -3) * unit, 4.0 * unit, addObject(scene, glow(glm::dvec3(0.5)))});
  return scene;
}

std::vector<float> traced(const Scene& scene, Layer layer, const Rectangle& part = {0, 0, kSide, kSide}) {
  // Settings that are not the layer's are to change nothing.
  RenderSettings settings = settingsFor({kSide, kSide}, 16);
  settings.targetError = 0.1;
  settings.crop = part;
  std::vector<float> values;
  const bool isWhole = traceLayer(
      testDevice(), flatten(scene, 2), settings, layer,
      [&](std::span<const float> some) { values.insert(values.end(), some.begin(), some.end()); },
      [](double) { return true; });
  EXPECT_TRUE(isWhole);
  return values;
}

TEST(Layer, IsThatOfTheRayThroughThePixelsCentre) {
  for (const double unit : {1.0, 1e-7, 1e9}) {
    const Scene scene = ballBeside(unit);
    const Sphere& ball = scene.spheres[1];
    const std::vector<float> depths = traced(scene, Layer::kDepth);
    const std::vector<float> normals = traced(scene, Layer::kNormal);
    const std::vector<float> objects = traced(scene, Layer::kObject);
    ASSERT_EQ(depths.size(), std::size_t{kSide} * kSide);
    ASSERT_EQ(normals.size(), 3 * depths.size());
    ASSERT_EQ(objects.size(), depths.size());
    int hits = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const glm::dvec3 direction = glm::normalize(
          glm::dvec3(i % kSide + 0.5 - kSide / 2.0, kSide / 2.0 - i / kSide - 0.5, -kSide / 2.0));
      const glm::dvec3 toCenter = ball.center - scene.camera.position;
      const double middle = glm::dot(toCenter, direction);
      const double offAxis = glm::length(middle * direction - toCenter);
      if (std::abs(offAxis - ball.radius) < 1e-3 * ball.radius) continue;  // rounding may decide
      if (offAxis > ball.radius) {
        EXPECT_EQ(depths[i], std::numeric_limits<float>::infinity());
        EXPECT_EQ(objects[i], 0.0F);
        for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(normals[3 * i + axis], 0.0F);
        continue;
      }
      ++hits;
      const double distance = middle - std::sqrt(ball.radius * ball.radius - offAxis * offAxis);
      const glm::dvec3 normal = (distance * direction - toCenter) / ball.radius;
      EXPECT_NEAR(depths[i], distance, 1e-5 * distance) << "pixel " << i << ", unit " << unit;
      EXPECT_EQ(objects[i], 2.0F);
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(normals[3 * i + axis], normal[axis], 1e-5);
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(hits, kSide * kSide / 2);
  }
}

TEST(Layer, OfACropIsThatPartOfTheWhole) {
  const Scene scene = ballBeside(1.0);
  const Rectangle part{7, 20, 50, 41};
  for (const Layer layer : {Layer::kDepth, Layer::kNormal, Layer::kObject}) {
    const std::size_t channels = channelsOf(layer);
    const std::vector<float> whole = traced(scene, layer);
    const std::vector<float> some = traced(scene, layer, part);
    std::size_t at = 0;
    for (int y = part.y0; y < part.y1; ++y) {
      for (std::size_t i = channels * part.x0; i < channels * part.x1; ++i) {
        ASSERT_EQ(some.at(at++), whole[channels * kSide * y + i]);
      }
    }
    EXPECT_EQ(at, some.size());
  }
}

TEST(Layer, CanBeStopped) {
  const Scene scene = ballBeside(1.0);
  RenderSettings settings = settingsFor({kSide, kSide}, 1);
  settings.crop = {0, 0, kSide, kSide};
  EXPECT_FALSE(traceLayer(
      testDevice(), flatten(scene, 2), settings, Layer::kDepth, [](std::span<const float>) {},
      [](double) { return false; }));
}

}  // namespace
}  // namespace lavaray
