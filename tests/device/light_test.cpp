// The directions in which the device samples a spherical light: uniform in the cone that the light subtends,
// and all of them within it, from the widest cones to those that float32 coordinates can hardly tell from a
// point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "device/shaders/probe.h"
#include "device/test_device.hpp"
#include "lightProbeSpirv.spv.h"
#include "render/scene_buffers.hpp"
#include "render/variant.hpp"
#include "vulkan/compute.hpp"

namespace lavaray {
namespace {

constexpr std::uint32_t kSamples = 1000000;
constexpr double kHalfUlp = 0x1p-24;

std::vector<gpu::ProbeLightSample> sampleLight(const gpu::Light& light, const glm::vec3& position,
                                               gpu::uint sampling) {
  vulkan::Device& device = testDevice();
  std::vector<vulkan::Buffer> buffers = uploadScene(device, GpuScene{});
  buffers.push_back(vulkan::Buffer::shared(device, "nothing", sizeof(gpu::ProbeLightSample)));
  buffers.push_back(vulkan::Buffer::shared(device, "samples", kSamples * sizeof(gpu::ProbeLightSample)));
  std::vector<std::uint32_t> specialization(gpu::kSpecCount);
  specialization[gpu::kSpecHasSphericalLights] = 1;
  specialization[gpu::kSpecSampling] = sampling;
  const gpu::LightConstants constants{light, position, kSamples};
  vulkan::ComputeShader shader(device, lightProbeSpirv, specialization, buffers, sizeof constants);
  shader.dispatch((kSamples + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
                  std::as_bytes(std::span(&constants, 1)));
  std::vector<gpu::ProbeLightSample> samples(kSamples);
  std::memcpy(samples.data(), buffers[gpu::kBindingProbeOut].bytes(),
              samples.size() * sizeof(gpu::ProbeLightSample));
  return samples;
}

// The probability that counts of as many equally likely bins deviate from their mean by this much or more.
// Wilson and Hilferty, "The Distribution of Chi-Square", 1931.
double chiSquaredProbability(const std::vector<int>& counts) {
  const double expected = double{kSamples} / static_cast<double>(counts.size());
  double chiSquared = 0.0;
  for (const int count : counts) chiSquared += std::pow(count - expected, 2.0) / expected;
  const double freedom = static_cast<double>(counts.size()) - 1.0;
  const double spread = 2.0 / (9.0 * freedom);
  const double normal = (std::cbrt(chiSquared / freedom) - (1.0 - spread)) / std::sqrt(spread);
  return 0.5 * std::erfc(normal / std::numbers::sqrt2);
}

// The cone as float32 coordinates give it, in double precision.
struct Cone {
  glm::dvec3 axis;
  double sine;    // of its half angle; 1 where the position is inside the light
  double height;  // 1 - cosine of it; 2 inside
};

Cone coneOf(const gpu::Light& light, const glm::vec3& position) {
  const glm::dvec3 axis = glm::dvec3(light.position) - glm::dvec3(position);
  const double distance = glm::length(axis);
  if (distance <= light.radius) return {distance > 0.0 ? axis / distance : glm::dvec3(0, 0, 1), 1.0, 2.0};
  const double sine = light.radius / distance;
  return {axis / distance, sine, sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)))};
}

// Bins of equal solid angle: kRings rings about the axis, each divided into kSectors.
constexpr int kRings = 32;
constexpr int kSectors = 32;

class Directions {
 public:
  explicit Directions(const Cone& cone) : cone_(cone), counts_(kRings * kSectors) {
    const glm::dvec3 other = std::abs(cone.axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    x_ = glm::normalize(glm::cross(cone.axis, other));
    y_ = glm::cross(cone.axis, x_);
  }

  void add(const glm::dvec3& direction) {
    const double x = glm::dot(direction, x_);
    const double y = glm::dot(direction, y_);
    const double along = glm::dot(direction, cone_.axis);
    const double sine = std::hypot(x, y);
    const double height = along > 0.0 ? sine * sine / (1.0 + along) : 1.0 - along;
    const double turn = 0.5 + std::atan2(y, x) / (2.0 * std::numbers::pi);
    const int ring = std::clamp(static_cast<int>(height / cone_.height * kRings), 0, kRings - 1);
    const int sector = std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1);
    ++counts_[ring * kSectors + sector];
    if (cone_.height < 2.0) excess_ = std::max(excess_, along > 0.0 ? sine - cone_.sine : 1.0);
  }

  [[nodiscard]] double probability() const { return chiSquaredProbability(counts_); }
  [[nodiscard]] double excess() const { return excess_; }  // of the sine over the cone's

 private:
  Cone cone_;
  glm::dvec3 x_;
  glm::dvec3 y_;
  std::vector<int> counts_;
  double excess_ = -1.0;
};

struct Case {
  std::string name;
  glm::vec3 toLight;  // from the position
  float radius;
  // Whether the directions, as float32 holds them, are dense enough in the cone to be counted in bins.
  bool isResolved = true;
};

void expectUniformWithinTheCone(const Case& test, const glm::vec3& position) {
  gpu::Light light{};
  light.position = position + test.toLight;
  light.radius = test.radius;
  const Cone cone = coneOf(light, position);
  // Of the coordinates that a sample is computed from.
  const double magnitude =
      glm::length(glm::dvec3(light.position)) + glm::length(glm::dvec3(position)) + light.radius;
  // Vulkan promises a sine and a cosine to within 2^-11 only, and they may both be off.
  const double ofTheTurn = isLavapipe() ? 0.0 : 0x1p-11 * std::numbers::sqrt2 * cone.sine;
  for (const gpu::uint sampling : {gpu::kSamplingRandom, gpu::kSamplingSobol}) {
    Directions directions(cone);
    double farthest = 0.0;  // of a target from the light's surface
    for (const gpu::ProbeLightSample& sample : sampleLight(light, position, sampling)) {
      const glm::dvec3 direction(sample.toLight);
      ASSERT_NEAR(glm::length(direction), 1.0, 4.0 * kHalfUlp);
      directions.add(direction);
      const double off = glm::distance(glm::dvec3(sample.target), glm::dvec3(light.position)) - light.radius;
      farthest = std::max(farthest, std::abs(off));
    }
    EXPECT_LE(directions.excess(), 6.0 * kHalfUlp + ofTheTurn) << test.name;
    EXPECT_LE(farthest, (16.0 * kHalfUlp + ofTheTurn) * magnitude) << test.name;
    const double probability = directions.probability();
    if (test.isResolved) {
      EXPECT_GT(probability, 0.001) << test.name;
      // Independent samples that are too even are not random.
      if (sampling == gpu::kSamplingRandom) {
        EXPECT_LT(probability, 0.999) << test.name;
      }
    }
    std::cout << test.name << (sampling == gpu::kSamplingSobol ? ", Sobol: " : ", random: ");
    if (test.isResolved) std::cout << "p = " << probability << ", ";
    if (cone.height < 2.0)
      std::cout << "sine past the cone's by " << directions.excess() / kHalfUlp << " half ulps, ";
    std::cout << "targets off the light by " << farthest / magnitude / kHalfUlp << '\n';
  }
}

TEST(LightSamples, AreUniformInWideCones) {
  expectUniformWithinTheCone({"sine 0.999", {0, 0, 1}, 0.999F}, {0, 0, 0});
  expectUniformWithinTheCone({"sine 0.7", {1, -2, 2}, 2.1F}, {0.3F, -0.2F, 5});
  expectUniformWithinTheCone({"sine 0.1", {-3, 1, -2}, 0.374F}, {1, 2, 3});
  expectUniformWithinTheCone({"sine 0.01", {0, 0, -8}, 0.08F}, {1, 2, 3});
}

// About an axis of the coordinates even the smallest cone's directions keep all their digits.
TEST(LightSamples, AreUniformInTinyCones) {
  expectUniformWithinTheCone({"sine 1e-4", {0, 3, 0}, 3e-4F}, {0, 0, 0});
  expectUniformWithinTheCone({"sine 1e-4, tilted", {1, -2, 2}, 3e-4F}, {0.3F, -0.2F, 5});
  expectUniformWithinTheCone({"sine 1e-6", {0, 0, -2}, 2e-6F}, {0, 0, 0});
  expectUniformWithinTheCone({"sine 1e-6, along x", {2, 0, 0}, 2e-6F}, {0, 0, 0});
  expectUniformWithinTheCone({"sine 1e-6, tilted", {1, -2, 2}, 3e-6F, false}, {0.3F, -0.2F, 5});
  expectUniformWithinTheCone({"sine 1e-12", {0, 0, 1}, 1e-12F}, {0, 0, 0});
}

TEST(LightSamples, AreUniformInAllDirectionsInsideTheLight) {
  expectUniformWithinTheCone({"in the light", {0.2F, -0.3F, 0.4F}, 1.5F}, {1, 2, 3});
  expectUniformWithinTheCone({"in its centre", {0, 0, 0}, 0.5F}, {1, 2, 3});
  expectUniformWithinTheCone({"on its surface", {0, 0, -0.5F}, 0.5F}, {1, 2, 3});
}

}  // namespace
}  // namespace lavaray
