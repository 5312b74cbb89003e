// The oracle's mirrors against the unfolded scene and the geometric series.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "oracle/oracle.hpp"
#include "unit/sampled_scenes.hpp"

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Options;
using oracle::Pixel;
using oracle::Result;

// The walls x = -2.5 and x = 2.5 are perfect mirrors. Cell k of the unfolded room is the room mirrored k
// times.
constexpr double kHalfWidth = 2.5;
const dvec3 kBall(0.8, -0.7, -6.0);
const dvec3 kLamp(-1.5, 2.0, -2.0);

dvec3 inCell(const dvec3& point, int cell) {
  return {2.0 * kHalfWidth * cell + (cell % 2 == 0 ? point.x : -point.x), point.y, point.z};
}

Scene mirrorRoom(const Material& ball, const Material& wall) {
  Scene scene = sceneWithView(90.0);
  scene.spheres = {{kBall, 1.2, addMaterial(scene, ball)}};
  scene.planes = {{dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), addMaterial(scene, wall)}};
  Material mirror;
  mirror.reflectance = dvec3(1.0);
  for (const double x : {-kHalfWidth, kHalfWidth}) {
    scene.planes.push_back({dvec3(1.0, 0.0, 0.0), dvec3(x, 0.0, 0.0), addMaterial(scene, mirror)});
  }
  return scene;
}

Scene unfoldedRoom(const Material& ball, const Material& wall) {
  Scene scene = sceneWithView(90.0);
  const std::uint32_t balls = addMaterial(scene, ball);
  for (int cell = -2; cell <= 2; ++cell) scene.spheres.push_back({inCell(kBall, cell), 1.2, balls});
  scene.planes = {{dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -10.0), addMaterial(scene, wall)}};
  return scene;
}

TEST(OracleMirrors, AMirrorRoomIsTheUnfoldedScene) {
  const Material ball = glow(dvec3(0.9, 0.2, 0.1));
  const Material wall = glow(dvec3(0.1, 0.3, 0.8));
  const Result mirrors = oracle::render(mirrorRoom(ball, wall), sampled(16));
  const Result unfolded = oracle::render(unfoldedRoom(ball, wall), sampled(16));
  int different = 0;
  for (std::size_t i = 0; i < mirrors.pixels.size(); ++i) {
    if (glm::distance(mirrors.pixels[i].color, unfolded.pixels[i].color) > 1e-12) ++different;
  }
  EXPECT_LE(different, 1);  // a silhouette that rounding moves across a sample
}

// With lights there is no single unfolded scene, because the lamp of one cell does not shine into the next.
// Each pixel must instead match the unfolded scene with the lamp in one of the cells.
TEST(OracleMirrors, AMirrorRoomIsLitAsTheUnfoldedScene) {
  const Material ball{dvec3(0.05), dvec3(0.6, 0.3, 0.2), dvec3(0.4), 20.0, dvec3(0.0)};
  const Material wall{dvec3(0.1), dvec3(0.2, 0.3, 0.5), dvec3(0.3), 5.0, dvec3(0.0)};
  const Light lamp{kLamp, dvec3(0.1), dvec3(0.9), dvec3(0.8), 0.0};
  Scene room = mirrorRoom(ball, wall);
  room.lights = {lamp};
  Options options;
  options.probeOffset = 0.0;
  const Result mirrors = oracle::render(room, options);
  std::vector<double> nearest(mirrors.pixels.size(), HUGE_VAL);
  for (int cell = -2; cell <= 2; ++cell) {
    Scene scene = unfoldedRoom(ball, wall);
    scene.lights = {lamp};
    scene.lights[0].position = inCell(kLamp, cell);
    const Result unfolded = oracle::render(scene, options);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      nearest[i] = std::min(nearest[i], glm::distance(mirrors.pixels[i].color, unfolded.pixels[i].color));
    }
  }
  int different = 0;
  for (const double distance : nearest) different += distance > 1e-10 ? 1 : 0;
  EXPECT_LE(different, 1);
}

TEST(OracleMirrors, FacingMirrorsAddUpToTheGeometricSeries) {
  constexpr double kGlow = 0.05;
  const dvec3 reflectance(0.9, 0.5, 0.2);
  Scene scene = sceneWithView(90.0);
  Material mirror = glow(dvec3(kGlow));
  mirror.reflectance = reflectance;
  for (const double z : {-10.0, 4.0}) {
    scene.planes.push_back({dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, z), addMaterial(scene, mirror)});
  }
  dvec3 last(0.0);
  for (const int depth : {0, 1, 2, 8, 32}) {
    Options options = sampled(4);
    options.maxDepth = depth;
    options.x1 = options.y1 = 2;
    const Pixel pixel = oracle::render(scene, options).pixels.at(3);
    for (int channel = 0; channel < 3; ++channel) {
      const double r = reflectance[channel];
      EXPECT_NEAR(pixel.color[channel], kGlow * (1.0 - std::pow(r, depth + 1)) / (1.0 - r), 1e-12);
      EXPECT_LE(pixel.color[channel], kGlow / (1.0 - r));
      EXPECT_GT(pixel.color[channel], last[channel]);
      EXPECT_NEAR(pixel.standardError[channel], 0.0, 1e-15);
    }
    last = pixel.color;
  }
}

}  // namespace
}  // namespace lavaray
