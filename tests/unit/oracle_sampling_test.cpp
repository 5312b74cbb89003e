// The oracle's sampled images against closed forms. The seeds are fixed, so a statistical bound (four
// standard errors or more) that fails points to a bug, not to bad luck.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "support/closed_forms.hpp"
#include "unit/sampled_scenes.hpp"

namespace lavaray {
namespace {

using glm::dvec3;
using oracle::Options;
using oracle::Pixel;
using oracle::Result;

// So narrow a view that a whole pixel sees one point, as far as any test here can tell.
Scene narrowScene() {
  return sceneWithView(0.001);
}

// Shows 0.5 (1 + v), where v is the visible part of a light whose ambient colour is 1.
Material visibility() {
  Material material;
  material.ambient = dvec3(0.5);
  return material;
}

Light ambientLight(const dvec3& position, double radius) {
  return {position, dvec3(1.0), dvec3(0.0), dvec3(0.0), radius};
}

Pixel middlePixel(const Scene& scene, int samples) {
  Options options = sampled(samples);
  options.x0 = options.y0 = 50;
  options.x1 = options.y1 = 51;
  return oracle::render(scene, options).pixels.at(0);
}

double visiblePart(const Pixel& pixel) {
  return 2.0 * pixel.color.x - 1.0;
}

// `unit` is how much a quantity of 1 adds to the colour.
void expectWithin(double value, double expected, double standardError, double unit = 1.0) {
  EXPECT_NEAR(value, expected, 4.0 * standardError / unit + 1e-9);
}

TEST(OracleSampling, AreaOfASpheresImage) {
  for (const dvec3& center : {dvec3(0.0, 0.0, -10.0), dvec3(2.0, 1.0, -10.0)}) {
    Scene scene = sceneWithView(90.0);
    scene.spheres = {{center, 4.0, addMaterial(scene, glow(dvec3(1.0, 0.5, 7.0)))}};
    const Result image = oracle::render(scene, sampled(64));
    dvec3 area(0.0);
    dvec3 variance(0.0);
    for (const Pixel& pixel : image.pixels) {
      area += pixel.color;
      variance += pixel.standardError * pixel.standardError;
    }
    // The image plane cuts the cone of half angle a, whose axis makes the angle b with the view, in an
    // ellipse of area pi f^2 sin^2 a cos a / (cos^2 b - sin^2 a)^(3/2).
    const double sine = 4.0 / glm::length(center);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double axis = 10.0 / glm::length(center);
    const double expected =
        kPi * kFocalLength * kFocalLength * sine * sine * cosine / std::pow(axis * axis - sine * sine, 1.5);
    expectWithin(area.x, expected, std::sqrt(variance.x));
    expectWithin(area.y, 0.5 * expected, std::sqrt(variance.y));
    EXPECT_NEAR(area.x / expected, 1.0, 1e-3);
    EXPECT_DOUBLE_EQ(area.z, area.x);  // each sample is clamped, not their mean
  }
}

TEST(OracleSampling, PenumbraOfAHalfPlane) {
  const dvec3 point(0.0, 0.0, -10.0);
  const dvec3 light(3.0, 0.0, -3.0);
  for (const double radius : {2.0, 0.05}) {
    const double distance = glm::distance(point, light);
    for (const double share : {-1.1, -0.9, -0.5, 0.0, 0.3, 0.8, 1.1}) {
      const double a = std::asin(radius / distance);
      const double b = share * a;
      // Seen from the point, the edge lies in the light's direction turned by b towards the occluder.
      const double edge = 4.0 * std::tan(std::atan2(3.0, 7.0) + b);
      Scene scene = narrowScene();
      scene.planes = {{dvec3(0.0, 0.0, 1.0), point, addMaterial(scene, visibility())}};
      scene.triangles = {{{dvec3(edge, -900.0, -6.0), dvec3(edge, 900.0, -6.0), dvec3(900.0, 0.0, -6.0)},
                          addMaterial(scene, visibility())}};
      scene.lights = {ambientLight(light, radius)};
      const Pixel pixel = middlePixel(scene, 40000);
      expectWithin(visiblePart(pixel), 1.0 - capBeyond(a, b), pixel.standardError.x, 0.5);
      if (std::abs(share) > 1.0) {
        EXPECT_EQ(pixel.standardError.x, 0.0);
      } else {
        EXPECT_LT(pixel.standardError.x, 0.5 * 0.5 / std::sqrt(40000.0) + 1e-5);
      }
    }
  }
}

TEST(OracleSampling, PenumbraOfABallInFrontOfTheLight) {
  const dvec3 axis(0.6, 0.0, 0.8);
  const dvec3 point(0.0, 0.0, -10.0);
  for (const double radius : {0.1, 0.3, 0.5, 0.8}) {
    Scene scene = narrowScene();
    scene.planes = {{dvec3(0.0, 0.0, 1.0), point, addMaterial(scene, visibility())}};
    scene.spheres = {{point + 3.0 * axis, radius, addMaterial(scene, visibility())}};
    scene.lights = {ambientLight(point + 8.0 * axis, 2.0)};
    const Pixel pixel = middlePixel(scene, 40000);
    // Two cones about one axis.
    const double lightCap = 1.0 - std::sqrt(1.0 - 0.0625);
    const double ballCap = 1.0 - std::sqrt(1.0 - radius * radius / 9.0);
    expectWithin(visiblePart(pixel), std::max(1.0 - ballCap / lightCap, 0.0), pixel.standardError.x, 0.5);
  }
}

TEST(OracleSampling, WhatLiesInOrBehindTheLightBlocksNothing) {
  const dvec3 point(0.0, 0.0, -10.0);
  const dvec3 light(6.0, 0.0, -2.0);
  const dvec3 axis(0.6, 0.0, 0.8);
  for (const double along : {0.0, 0.9, 4.0}) {
    Scene scene = narrowScene();
    scene.planes = {{dvec3(0.0, 0.0, 1.0), point, addMaterial(scene, visibility())}};
    scene.spheres = {{light + along * axis, 1.0, addMaterial(scene, visibility())}};
    scene.lights = {ambientLight(light, 2.0)};
    EXPECT_EQ(visiblePart(middlePixel(scene, 1000)), 1.0) << along;
    // A point light there is hidden inside the ball.
    scene.lights[0].radius = 0.0;
    EXPECT_EQ(visiblePart(middlePixel(scene, 1000)), along < 1.0 ? 0.0 : 1.0) << along;
  }
}

TEST(OracleSampling, DiffuseLightOfASphere) {
  const dvec3 point(0.0, 0.0, -10.0);
  Material matte;
  matte.diffuse = dvec3(1.0);
  // The mean direction of a cone is its axis times (1 + cos a) / 2, as long as the whole cone is above the
  // horizon.
  for (const double radius : {0.01, 1.0, 5.0}) {
    Scene scene = narrowScene();
    scene.planes = {{dvec3(0.0, 0.0, 1.0), point, addMaterial(scene, matte)}};
    scene.lights = {{point + dvec3(6.0, 0.0, 8.0), dvec3(0.0), dvec3(1.0), dvec3(0.0), radius}};
    const Pixel pixel = middlePixel(scene, 40000);
    const double cosine = std::sqrt(1.0 - radius * radius / 100.0);
    expectWithin(pixel.color.x, 0.8 * (1.0 + cosine) / 2.0, pixel.standardError.x);
    if (radius < 0.1) {
      EXPECT_LT(pixel.standardError.x, 2e-6);
    }
  }
  // From inside, the light is everywhere: the mean of max(l.n, 0) is 1/4, and of the visible part 1.
  Scene scene = narrowScene();
  matte.ambient = dvec3(0.5);
  scene.planes = {{dvec3(0.0, 0.0, 1.0), point, addMaterial(scene, matte)}};
  scene.lights = {{point + dvec3(1.0, 2.0, 2.0), dvec3(0.0), dvec3(1.0), dvec3(0.0), 5.0}};
  const Pixel pixel = middlePixel(scene, 40000);
  // (0.5 plus the term is clamped to 1: subtract the excess, the mean of max(l.n - 0.5, 0).)
  expectWithin(pixel.color.x, 0.5 + 0.25 - 0.0625, pixel.standardError.x);
  scene.lights = {ambientLight(point + dvec3(1.0, 2.0, 2.0), 5.0)};
  EXPECT_EQ(visiblePart(middlePixel(scene, 100)), 1.0);
}

Scene softScene() {
  Scene scene = sceneWithView(60.0);
  const Material matte{dvec3(0.1), dvec3(0.5, 0.4, 0.3), dvec3(0.3), 10.0, dvec3(0.2)};
  scene.spheres = {{dvec3(0.0, 0.0, -10.0), 2.0, addMaterial(scene, matte)}};
  scene.planes = {{dvec3(0.0, 1.0, 0.0), dvec3(0.0, -2.0, 0.0), addMaterial(scene, matte)}};
  scene.lights = {{dvec3(5.0, 8.0, -8.0), dvec3(0.1), dvec3(0.8), dvec3(0.6), 2.0}};
  return scene;
}

TEST(OracleSampling, TheStandardErrorIsThatOfTheMean) {
  const Scene scene = softScene();
  const Result a = oracle::render(scene, sampled(64, 1));
  const Result b = oracle::render(scene, sampled(64, 2));
  const Result c = oracle::render(scene, sampled(64, (1ULL << 32) + 1));
  double squares = 0.0;
  int noisy = 0;
  int differing = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Pixel& p = a.pixels[i];
    const Pixel& q = b.pixels[i];
    if (p.color != c.pixels[i].color) ++differing;
    if (p.standardError.x < 0.005 || q.standardError.x < 0.005) continue;
    const double difference = p.color.x - q.color.x;
    squares += difference * difference /
               (p.standardError.x * p.standardError.x + q.standardError.x * q.standardError.x);
    ++noisy;
  }
  EXPECT_GT(noisy, 500);
  EXPECT_NEAR(squares / noisy, 1.0, 0.15);
  EXPECT_GT(differing, 500);  // all 64 bits of the seed matter
}

TEST(OracleSampling, APixelDependsOnSeedAndPlaceOnly) {
  const Scene scene = softScene();
  const Result whole = oracle::render(scene, sampled(5, 7));
  Options options = sampled(5, 7);
  options.x0 = 40;
  options.y0 = 60;
  options.x1 = 43;
  options.y1 = 62;
  const Result part = oracle::render(scene, options);
  ASSERT_EQ(part.pixels.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const Pixel& pixel = whole.pixels[(60 + i / 3) * 101 + 40 + i % 3];
    EXPECT_EQ(part.pixels[i].color, pixel.color);
    EXPECT_EQ(part.pixels[i].standardError, pixel.standardError);
  }
}

TEST(OracleSampling, OneSampleTakesLightsForPoints) {
  Scene scene = softScene();
  const Pixel soft = middlePixel(scene, 1);
  scene.lights[0].radius = 0.0;
  EXPECT_EQ(middlePixel(scene, 1).color, soft.color);
  EXPECT_EQ(soft.standardError, dvec3(0.0));
  EXPECT_THROW(oracle::render(scene, sampled(0)), std::invalid_argument);
}

}  // namespace
}  // namespace lavaray
