// Mirrors: what is seen in them is the scene unfolded, and bounces never add energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>

#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "oracle/oracle.hpp"

namespace lavaray {
namespace {

// How the room looks in mirrors: some of its coordinates are reversed, and it is moved.
struct Reflection {
  glm::dvec3 scale;
  glm::dvec3 offset;
  int bounces;

  [[nodiscard]] glm::dvec3 of(const glm::dvec3& point) const { return scale * point + offset; }
};

// What is in the room, seen in a reflection. It does not reach beyond the mirrors, so a reflection's things
// are lit by its lamp as if they were alone.
using Furnish = std::function<void(Scene& scene, const Reflection& reflection, const glm::dvec3* glowing)>;

struct MirrorRoom {
  Furnish furnish;
  std::function<void(Scene& scene)> hangMirrors;
  std::vector<Reflection> reflections;  // all that the camera sees; the room itself is among them
  Light lamp;
  glm::dvec3 reflectance;
};

Scene emptyScene() {
  Scene scene;
  scene.camera = {{0, 0, 0}, 90.0, 60.0, 1.0};
  return scene;
}

Light reflected(Light lamp, const Reflection& reflection) {
  lamp.position = reflection.of(lamp.position);
  return lamp;
}

Scene withMirrors(const MirrorRoom& room) {
  Scene scene = emptyScene();
  room.furnish(scene, {glm::dvec3(1.0), glm::dvec3(0.0), 0}, nullptr);
  room.hangMirrors(scene);
  scene.lights = {room.lamp};
  return scene;
}

// No single scene has all reflections lit, as each has a lamp that does not shine into the others. So there
// is one scene for each lamp, and one whose colours say which reflection is seen.
Scene unfolded(const MirrorRoom& room, const Reflection& litOne) {
  Scene scene = emptyScene();
  for (const Reflection& reflection : room.reflections) room.furnish(scene, reflection, nullptr);
  scene.lights = {reflected(room.lamp, litOne)};
  return scene;
}

Scene reflectionNumbers(const MirrorRoom& room) {
  Scene scene = emptyScene();
  for (std::size_t i = 0; i < room.reflections.size(); ++i) {
    const glm::dvec3 number(static_cast<double>(i + 1) / 16.0);
    room.furnish(scene, room.reflections[i], &number);
  }
  return scene;
}

void expectShowsTheUnfoldedScene(const MirrorRoom& room) {
  const Image mirrors = renderScene(withMirrors(room)).image;
  const oracle::Result numbers = oracle::render(reflectionNumbers(room));
  double fromOracle = 0.0;
  double fromRenderer = 0.0;
  std::vector<int> seen(room.reflections.size());
  int left = 0;
  for (std::size_t i = 0; i < room.reflections.size(); ++i) {
    const Scene scene = unfolded(room, room.reflections[i]);
    const oracle::Result truth = oracle::render(scene);
    const Image image = renderScene(scene).image;
    const glm::dvec3 weight = glm::pow(room.reflectance, glm::dvec3(room.reflections[i].bounces));
    for (std::size_t pixel = 0; pixel < truth.pixels.size(); ++pixel) {
      if (std::lround(16.0 * numbers.pixels[pixel].color.x) != static_cast<long>(i + 1)) continue;
      if (numbers.pixels[pixel].uncertain || truth.pixels[pixel].uncertain) continue;
      ++seen[i];
      ++left;
      for (int channel = 0; channel < 3; ++channel) {
        const double actual = mirrors.rgb[3 * pixel + channel];
        EXPECT_LT(truth.pixels[pixel].color[channel], 1.0);  // not clamped
        fromOracle =
            std::max(fromOracle, std::abs(actual - weight[channel] * truth.pixels[pixel].color[channel]));
        fromRenderer = std::max(fromRenderer,
                                std::abs(actual - weight[channel] * double{image.rgb[3 * pixel + channel]}));
      }
    }
  }
  EXPECT_LE(fromOracle, 1e-4);
  EXPECT_LE(fromRenderer, 1e-4);
  const double share = left / static_cast<double>(numbers.pixels.size());
  EXPECT_GT(share, 0.9);
  std::cout << "largest difference from the unfolded scene " << fromOracle << " (oracle), " << fromRenderer
            << " (renderer), in " << 100.0 * share << " % of the pixels; of each reflection:";
  for (const int count : seen) {
    EXPECT_GT(count, 100);
    std::cout << ' ' << count;
  }
  std::cout << '\n';
}

const Material kRed{glm::dvec3(0.05), {0.6, 0.2, 0.1}, glm::dvec3(0.3), 20.0};
const Material kBlue{glm::dvec3(0.05), {0.1, 0.3, 0.6}, glm::dvec3(0.2), 8.0};
const Material kGrey{{0.08, 0.07, 0.06}, {0.4, 0.45, 0.5}, glm::dvec3(0.0), 1.0};

// Two balls and a pyramid.
void addThings(Scene& scene, const Reflection& in, const std::function<Material(const Material&)>& shown) {
  scene.spheres.push_back({in.of({0.8, -0.7, -6.0}), 1.1, addObject(scene, shown(kRed))});
  scene.spheres.push_back({in.of({-1.4, 0.9, -7.5}), 0.8, addObject(scene, shown(kBlue))});
  const std::array<glm::dvec3, 4> corners = {
      {{-2.0, -1.6, -5.0}, {-0.6, -1.5, -5.5}, {-1.5, -1.7, -6.5}, {-1.3, -0.2, -5.6}}};
  for (int i = 0; i < 4; ++i) {
    scene.triangles.push_back({{in.of(corners[i]), in.of(corners[(i + 1) % 4]), in.of(corners[(i + 2) % 4])},
                               addObject(scene, shown(kBlue))});
  }
}

Material mirror(const glm::dvec3& reflectance) {
  Material material;
  material.reflectance = reflectance;
  return material;
}

// Mirrors left and right of a corridor, seen to the second reflection on either side.
TEST(Mirrors, FacingOnesShowTheUnfoldedScene) {
  constexpr double kHalfWidth = 2.5;
  MirrorRoom room;
  room.furnish = [](Scene& scene, const Reflection& in, const glm::dvec3* glowing) {
    const auto shown = [&](const Material& material) {
      return glowing != nullptr ? glow(*glowing) : material;
    };
    addThings(scene, in, shown);
    const double w = kHalfWidth;
    addParallelogram(scene, shown(kGrey), in.of({-w, -3, -10}), in.of({w, -3, -10}), in.of({w, 12, -10}));
    addParallelogram(scene, shown(kRed), in.of({-w, -3, 0.5}), in.of({w, -3, 0.5}), in.of({w, -3, -10}));
  };
  room.hangMirrors = [&room](Scene& scene) {
    for (const double x : {-kHalfWidth, kHalfWidth}) {
      scene.planes.push_back({{1, 0, 0}, {x, 0, 0}, addObject(scene, mirror(room.reflectance))});
    }
  };
  for (int cell = -2; cell <= 2; ++cell) {
    room.reflections.push_back(
        {{cell % 2 == 0 ? 1.0 : -1.0, 1, 1}, {2.0 * kHalfWidth * cell, 0, 0}, std::abs(cell)});
  }
  room.lamp = {{-1.5, 2.0, -2.0}, glm::dvec3(0.1), glm::dvec3(0.9), glm::dvec3(0.8)};
  for (const glm::dvec3& reflectance : {glm::dvec3(1.0), glm::dvec3(0.9, 0.7, 0.4)}) {
    room.reflectance = reflectance;
    expectShowsTheUnfoldedScene(room);
  }
}

// A mirror to the right, which is a plane, and one on the floor, of two triangles.
TEST(Mirrors, ThatMeetInACornerShowTheUnfoldedScene) {
  constexpr double kRight = 2.5;
  constexpr double kFloor = -2.0;
  MirrorRoom room;
  room.furnish = [](Scene& scene, const Reflection& in, const glm::dvec3* glowing) {
    const auto shown = [&](const Material& material) {
      return glowing != nullptr ? glow(*glowing) : material;
    };
    addThings(scene, in, shown);
    addParallelogram(scene, shown(kGrey), in.of({-12, kFloor, -10}), in.of({kRight, kFloor, -10}),
                     in.of({kRight, 12, -10}));
  };
  room.hangMirrors = [&room](Scene& scene) {
    const Material material = mirror(room.reflectance);
    scene.planes = {{{-2, 0, 0}, {kRight, 0, 0}, addObject(scene, material)}};
    addParallelogram(scene, material, {-15, kFloor, 1}, {kRight, kFloor, 1}, {kRight, kFloor, -11});
  };
  for (const int x : {0, 1}) {
    for (const int y : {0, 1}) {
      room.reflections.push_back(
          {{1.0 - 2.0 * x, 1.0 - 2.0 * y, 1.0}, {2.0 * kRight * x, 2.0 * kFloor * y, 0.0}, x + y});
    }
  }
  room.lamp = {{-2.0, 3.0, -1.0}, glm::dvec3(0.1), glm::dvec3(0.9), glm::dvec3(0.8)};
  for (const glm::dvec3& reflectance : {glm::dvec3(1.0), glm::dvec3(0.9, 0.7, 0.4)}) {
    room.reflectance = reflectance;
    expectShowsTheUnfoldedScene(room);
  }
}

// Between two facing mirrors each bounce adds the same light, k times weaker.
TEST(Mirrors, FacingOnesGiveAGeometricSeries) {
  constexpr double kReflectance = 0.9;
  Scene scene;
  scene.camera = {{0, 0, 0}, 60.0, 20.0, 1.0};
  scene.materials.resize(2);
  for (Material& material : scene.materials) {
    material.ambient = glm::dvec3(0.01);
    material.reflectance = glm::dvec3(kReflectance);
  }
  scene.planes = {{{0, 0, 1}, {0, 0, -1}, 0}, {{0, 0, 1}, {0, 0, 1}, 1}};
  double before = 0.0;
  double largest = 0.0;
  for (const std::uint32_t depth : {0U, 1U, 2U, 8U, 32U}) {
    RenderSettings settings = settingsFor({21, 21}, 1);
    settings.maxDepth = depth;
    const Image image = renderScene(scene, settings).image;
    const double expected = 0.01 * (1.0 - std::pow(kReflectance, depth + 1)) / (1.0 - kReflectance);
    for (const float value : image.rgb) {
      ASSERT_NEAR(value, expected, 1e-6) << depth;
      largest = std::max(largest, std::abs(value - expected));
    }
    EXPECT_GE(expected, before);
    before = expected;
  }
  std::cout << "largest error " << largest << '\n';
}

constexpr double kMinOfBounce = 0.01;
constexpr double kMaxOfBounce = 0.088;  // with all of the lamp: 0.01 + 0.008 + 0.04 + 0.03

// A room whose six sides and two balls are mirrors, so that no path ever ends.
Scene closedMirrorRoom(const glm::dvec3& reflectance) {
  Scene scene;
  scene.camera = {{0.1, 0.2, 0}, 70.0, 45.0, 1.3};
  const Material material{glm::dvec3(kMinOfBounce), glm::dvec3(0.04), glm::dvec3(0.03), 12.0, reflectance};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-2.5, 2.0}) {
      glm::dvec3 normal(0.0);
      normal[axis] = 1.0;
      scene.planes.push_back({normal, side * normal, addObject(scene, material)});
    }
  }
  scene.spheres = {{{0.6, -0.9, -1.5}, 0.7, addObject(scene, material)},
                   {{-0.9, 0.5, 1.0}, 0.5, addObject(scene, material)}};
  scene.lights = {{{-1.0, 1.5, -0.5}, glm::dvec3(0.8), glm::dvec3(1.0), glm::dvec3(1.0)}};
  return scene;
}

// Each bounce adds at least what a surface glows by itself and at most what it shows in full light, times k
// for each bounce before: less than k^depth, which is what energy is bounded by.
TEST(Mirrors, NeverAddEnergyWithDepth) {
  const glm::dvec3 k(0.9, 0.8, 0.5);
  const Scene scene = closedMirrorRoom(k);
  RenderSettings settings = settingsFor(imageSize(scene.camera).value(), 1);
  std::vector<float> before(3 * static_cast<std::size_t>(settings.size.width) * settings.size.height);
  double highest = 0.0;
  double largestStep = 0.0;  // in proportion to the bound
  constexpr double kRounding = 1e-6;
  for (std::uint32_t depth = 0; depth <= 32; ++depth) {
    settings.maxDepth = depth;
    const Image image = renderScene(scene, settings).image;
    const glm::dvec3 weight = glm::pow(k, glm::dvec3(depth));
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const int channel = static_cast<int>(i % 3);
      const double step = double{image.rgb[i]} - before[i];
      ASSERT_LE(step, kMaxOfBounce * weight[channel] + kRounding) << "depth " << depth;
      ASSERT_GE(step, kMinOfBounce * weight[channel] - kRounding) << "depth " << depth;
      ASSERT_LE(image.rgb[i], kMaxOfBounce / (1.0 - k[channel]));
      if (weight[channel] > 0.01)
        largestStep = std::max(largestStep, step / (kMaxOfBounce * weight[channel]));
      highest = std::max(highest, double{image.rgb[i]});
    }
    before = image.rgb;
  }
  std::cout << "highest value " << highest << " of at most " << kMaxOfBounce / (1.0 - k.x)
            << "; largest step " << largestStep << " of what a bounce may add\n";
}

}  // namespace
}  // namespace lavaray
