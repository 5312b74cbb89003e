// What the views other than that of colours show, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"

namespace lavaray {
namespace {

constexpr int kSide = 80;

// A camera that is not in the origin, and balls; the last one is behind the first.
Scene balls() {
  Scene scene;
  scene.camera = {{3, -2, 7}, 90.0, kSide / 2.0, 1.0};
  const std::array<Sphere, 3> spheres = {
      {{{1, -3, -3}, 3.0, 0}, {{8, 1, -5}, 4.0, 0}, {{0, 2, -15}, 6.0, 0}}};
  for (Sphere sphere : spheres) {
    sphere.object = addObject(scene, glow(glm::dvec3(0.5)));
    scene.spheres.push_back(sphere);
  }
  return scene;
}

Image viewOf(const Scene& scene, View view, std::uint32_t samples = 1) {
  RenderSettings settings = settingsFor({kSide, kSide}, samples);
  settings.view = view;
  return renderScene(scene, settings).image;
}

glm::dvec3 pixelOf(const Image& image, int x, int y) {
  const float* rgb = &image.rgb[3 * (static_cast<std::size_t>(y) * image.width + x)];
  return {rgb[0], rgb[1], rgb[2]};
}

// Unit vector through the centre of a pixel.
glm::dvec3 directionThrough(int x, int y) {
  return glm::normalize(glm::dvec3(x + 0.5 - kSide / 2.0, kSide / 2.0 - y - 0.5, -kSide / 2.0));
}

// How far from the origin along the unit vector the ball begins; nothing where the ray misses it. `clear`
// becomes false where the ray passes so near to its edge that rounding may decide.
std::optional<double> distanceTo(const Sphere& sphere, const glm::dvec3& origin, const glm::dvec3& direction,
                                 bool& clear) {
  const double middle = glm::dot(sphere.center - origin, direction);
  const double offAxis = glm::length(origin + middle * direction - sphere.center);
  clear = clear && std::abs(offAxis - sphere.radius) > 1e-3 * sphere.radius;
  if (middle < 0.0 || offAxis > sphere.radius) return std::nullopt;
  return middle - std::sqrt(sphere.radius * sphere.radius - offAxis * offAxis);
}

struct Seen {
  const Sphere* sphere;
  double distance;
  glm::dvec3 point;
};

std::optional<Seen> nearestBall(const Scene& scene, const glm::dvec3& direction, bool& clear) {
  std::optional<Seen> nearest;
  for (const Sphere& sphere : scene.spheres) {
    const auto distance = distanceTo(sphere, scene.camera.position, direction, clear);
    if (distance && (!nearest || *distance < nearest->distance)) {
      nearest = {&sphere, *distance, scene.camera.position + *distance * direction};
    }
  }
  return nearest;
}

// Calls `check` for each pixel that is clear; most of them are.
using Check = std::function<void(int x, int y, const std::optional<Seen>& seen)>;
void forClearPixels(const Scene& scene, const Check& check) {
  int checked = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      bool clear = true;
      const std::optional<Seen> seen = nearestBall(scene, directionThrough(x, y), clear);
      if (!clear) continue;
      ++checked;
      check(x, y, seen);
    }
  }
  EXPECT_GT(checked, kSide * kSide * 9 / 10);
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance, int x, int y) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "pixel " << x << ',' << y;
}

TEST(View, NormalIsTheSurfaces) {
  const Scene scene = balls();
  const Image image = viewOf(scene, View::kNormal);
  forClearPixels(scene, [&](int x, int y, const std::optional<Seen>& seen) {
    const glm::dvec3 expected =
        seen ? 0.5 * (seen->point - seen->sphere->center) / seen->sphere->radius + 0.5 : glm::dvec3(0.0);
    expectNear(pixelOf(image, x, y), expected, 1e-5, x, y);
  });
}

TEST(View, NormalIsOnTheSideThatIsSeen) {
  for (const double side : {-1.0, 1.0}) {
    Scene scene = balls();
    scene.spheres.clear();
    scene.planes.push_back({{0, 0, side}, {0, 0, -9}, addObject(scene, glow(glm::dvec3(0.5)))});
    const Image image = viewOf(scene, View::kNormal, 4);
    for (int i = 0; i < kSide; ++i) EXPECT_EQ(pixelOf(image, i, i), glm::dvec3(0.5, 0.5, 1.0));
  }
}

TEST(View, DepthIsInProportionToTheLargest) {
  const Scene scene = balls();
  const Image image = viewOf(scene, View::kDepth);
  EXPECT_EQ(*std::max_element(image.rgb.begin(), image.rgb.end()), 1.0F);
  // The largest distance may be that of a pixel that is not clear, so it is taken from the image.
  std::optional<double> scale;
  forClearPixels(scene, [&](int x, int y, const std::optional<Seen>& seen) {
    const glm::dvec3 shown = pixelOf(image, x, y);
    if (seen && !scale) scale = shown.x / seen->distance;
    expectNear(shown, glm::dvec3(seen ? seen->distance * scale.value() : 0.0), 1e-5, x, y);
  });
  EXPECT_NEAR(1.0 / scale.value(), std::sqrt(3.0 * 3.0 + 4.0 * 4.0 + 22.0 * 22.0 - 6.0 * 6.0), 1.0);
}

TEST(View, DepthOfAnEdgeIsThatOfTheSamplesThatHit) {
  Scene scene = balls();
  scene.spheres.resize(1);
  const Sphere& ball = scene.spheres.front();
  const double center = glm::length(ball.center - scene.camera.position);
  const double edge = std::sqrt(center * center - ball.radius * ball.radius);
  const Image image = viewOf(scene, View::kDepth, 16);
  double nearest = 1.0;
  for (const float depth : image.rgb) {
    if (depth > 0.0F) nearest = std::min(nearest, static_cast<double>(depth));
  }
  // Not nearer than the ball's front, as pixels at its edge would be that had the background's 0 in their
  // mean; the largest is a little less than the edge's.
  EXPECT_GT(nearest, (center - ball.radius) / edge);
  EXPECT_NEAR(nearest, (center - ball.radius) / edge, 0.02);
}

TEST(View, ObjectsHaveAColorEach) {
  Scene scene = balls();
  scene.planes.push_back({{0, 0, 1}, {0, 0, -40}, addObject(scene, glow(glm::dvec3(0.5)))});
  const Image image = viewOf(scene, View::kObject);
  std::array<std::set<std::array<double, 3>>, 4> colors;
  forClearPixels(scene, [&](int x, int y, const std::optional<Seen>& seen) {
    const glm::dvec3 color = pixelOf(image, x, y);
    colors[seen ? seen->sphere->object : 3].insert({color.x, color.y, color.z});
  });
  std::set<std::array<double, 3>> all;
  for (const auto& ofObject : colors) {
    EXPECT_EQ(ofObject.size(), 1U);
    all.insert(ofObject.begin(), ofObject.end());
  }
  EXPECT_EQ(all.size(), 4U);
  for (const float value : image.rgb) EXPECT_GE(value, 0.2F);
}

TEST(View, ShadowIsTheShareOfUnblockedLights) {
  Scene scene = balls();
  for (const glm::dvec3& position :
       {glm::dvec3(-9, -9, 0), glm::dvec3(-8, -8, 2), glm::dvec3(3, 20, 5), glm::dvec3(2, -2, 6)}) {
    scene.lights.push_back({.position = position});
  }
  const Image image = viewOf(scene, View::kShadow);
  std::set<int> shares;
  int checked = 0;
  forClearPixels(scene, [&](int x, int y, const std::optional<Seen>& seen) {
    if (!seen) {
      EXPECT_EQ(pixelOf(image, x, y), glm::dvec3(0.0));
      return;
    }
    int unblocked = 0;
    bool clear = true;
    for (const Light& light : scene.lights) {
      const glm::dvec3 toLight = light.position - seen->point;
      bool blocked = false;
      for (const Sphere& sphere : scene.spheres) {
        if (sphere.object == seen->sphere->object) continue;
        const auto distance = distanceTo(sphere, seen->point, glm::normalize(toLight), clear);
        blocked = blocked || (distance && *distance < glm::length(toLight));
      }
      unblocked += blocked ? 0 : 1;
    }
    if (!clear) return;
    ++checked;
    shares.insert(unblocked);
    EXPECT_EQ(pixelOf(image, x, y), glm::dvec3(unblocked / 4.0)) << "pixel " << x << ',' << y;
  });
  EXPECT_GT(checked, 1000);
  EXPECT_GE(shares.size(), 3U);
}

// So many lights that a dispatch does not look at all of them.
TEST(View, ShadowCountsLightsOverDispatches) {
  Scene scene = balls();
  scene.spheres.clear();
  scene.planes.push_back({{0, 0, 1}, {0, 0, -9}, addObject(scene, glow(glm::dvec3(0.5)))});
  scene.planes.push_back({{0, 0, 1}, {0, 0, 20}, addObject(scene, glow(glm::dvec3(0.5)))});
  for (int i = 0; i < 700; ++i) {
    const bool blocked = i % 7 == 0;  // by the plane behind the camera
    scene.lights.push_back({.position = {i % 20, i / 20, blocked ? 25.0 : 5.0}});
  }
  const Image image = viewOf(scene, View::kShadow);
  for (const float share : image.rgb) EXPECT_EQ(share, 6.0F / 7.0F);
  scene.planes.pop_back();
  for (const float share : viewOf(scene, View::kShadow).rgb) EXPECT_EQ(share, 1.0F);
}

TEST(View, ShadowOfASphericalLightIsAShareOfIt) {
  Scene scene = balls();
  scene.spheres.clear();
  scene.planes.push_back({{0, 0, 1}, {0, 0, -9}, addObject(scene, glow(glm::dvec3(0.5)))});
  // Covers the light's upper half, as seen from the height of the light and the camera.
  addParallelogram(scene, glow(glm::dvec3(0.5)), {-100, -2, 8}, {100, -2, 8}, {100, 100, 8});
  scene.lights.push_back({.position = {3, -2, 25}, .radius = 5.0});
  const Image image = viewOf(scene, View::kShadow, 64);
  EXPECT_NEAR(pixelOf(image, kSide / 2, kSide / 2).x, 0.5, 0.05);
  EXPECT_EQ(pixelOf(image, kSide / 2, 0).x, 0.0);
  EXPECT_EQ(pixelOf(image, kSide / 2, kSide - 1).x, 1.0);
}

}  // namespace
}  // namespace lavaray
