// The device's arithmetic within what Vulkan promises, and the renderer's powers and unit vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "arithmeticProbeSpirv.spv.h"
#include "device/probe.hpp"
#include "device/test_device.hpp"
#include "stress/report.hpp"
#include "stress/shaders/stress_probes.h"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

using Query = gpu::ArithmeticQuery;
using Answer = gpu::ArithmeticAnswer;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<Answer> compute(const std::vector<Query>& queries) {
  const gpu::CountConstants constants{static_cast<gpu::uint>(queries.size())};
  return runProbe<Answer>(arithmeticProbeSpirv, GpuScene{}, queries, constants);
}

Answer computeOne(float a, float b) {
  return compute({{a, b, 0.0F, 0}})[0];
}

// Of either sign, its exponent anywhere in +-range.
float anyFloat(Random& random, double range) {
  const auto size = static_cast<float>(std::exp2(uniform(random, -range, range)));
  return random() % 2 == 0 ? size : -size;
}

// Distance in units in the last place of the exact value.
double ulps(float actual, long double exact) {
  const long double ulp = std::ldexp(1.0L, std::ilogb(exact) - 23);
  return static_cast<double>(std::abs(static_cast<long double>(actual) - exact) / ulp);
}

struct Function {
  const char* name;
  float Answer::*value;
  long double (*exact)(const Query&);
  double allowed;  // by Vulkan's table of precision, in ulp
};

// Vulkan leaves the rounding mode open, so even a correctly rounded result may be 1 ulp off.
TEST(DeviceArithmetic, IsAsExactAsVulkanPromises) {
  const std::array functions{
      Function{"a + b", &Answer::sum, [](const Query& q) { return 0.0L + q.a + q.b; }, 1.0},
      Function{"a b", &Answer::product, [](const Query& q) { return 1.0L * q.a * q.b; }, 1.0},
      Function{"a / b", &Answer::quotient, [](const Query& q) { return 1.0L * q.a / q.b; }, 2.5},
      Function{"inversesqrt", &Answer::inverseRoot,
               [](const Query& q) { return 1.0L / std::sqrt(static_cast<long double>(q.a)); }, 2.0},
      // Vulkan: as exact as 1 / inversesqrt.
      Function{"sqrt", &Answer::root, [](const Query& q) { return std::sqrt(static_cast<long double>(q.a)); },
               4.5}};
  Random random(79);
  std::vector<Query> queries(sized(200'000, 1'500'000));
  for (Query& query : queries) query = {std::abs(anyFloat(random, 60.0)), anyFloat(random, 60.0), 0.0F, 0};
  const std::vector<Answer> answers = compute(queries);
  std::string figures;
  for (const Function& function : functions) {
    double largest = 0.0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      largest = std::max(largest, ulps(answers[i].*function.value, function.exact(queries[i])));
    }
    EXPECT_LE(largest, function.allowed) << function.name;
    figures += std::string(figures.empty() ? "" : ", ") + function.name + " " + shortNumber(largest);
  }
  report("ulp in " + grouped(queries.size()) + " cases: " + figures);
}

TEST(DeviceArithmetic, TakesExp2AsExactlyAsVulkanPromises) {
  Random random(83);
  std::vector<Query> queries(sized(200'000, 1'500'000));
  for (Query& query : queries) query.a = static_cast<float>(uniform(random, -120.0, 120.0));
  const std::vector<Answer> answers = compute(queries);
  double largest = 0.0;
  double share = 0.0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double error = ulps(answers[i].power2, std::exp2(static_cast<long double>(queries[i].a)));
    largest = std::max(largest, error);
    share = std::max(share, error / (3.0 + 2.0 * std::abs(double{queries[i].a})));
  }
  EXPECT_LE(share, 1.0);
  report("exp2 off by at most " + shortNumber(largest) + " ulp, " + shortNumber(share) +
         " of the promised 3 + 2 |x|, in " + grouped(queries.size()) + " cases");
}

// fma may be fused or not; then it must be the product and the sum, each rounded.
TEST(DeviceArithmetic, FmaIsFusedOrNot) {
  Random random(89);
  std::vector<Query> queries(sized(200'000, 1'500'000));
  for (Query& query : queries) {
    query = {anyFloat(random, 10.0), anyFloat(random, 10.0), 0.0F, 0};
    query.c = -query.a * query.b * static_cast<float>(uniform(random, 0.5, 2.0));
  }
  const std::vector<Answer> answers = compute(queries);
  std::size_t telling = 0;
  std::size_t fused = 0;
  std::size_t unfused = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto& [a, b, c, padding] = queries[i];
    const float inTwoSteps = a * b + c;
    const float inOne = std::fma(a, b, c);
    if (inTwoSteps == inOne) continue;
    ++telling;
    if (answers[i].fused == inOne) ++fused;
    if (answers[i].fused == inTwoSteps) ++unfused;
  }
  EXPECT_EQ(fused + unfused, telling);
  EXPECT_GT(telling, queries.size() / 10);
  report("fma is fused in " + grouped(fused) + " and unfused in " + grouped(unfused) + " of " +
         grouped(telling) + " telling cases");
}

// The renderer's tests are written so that a NaN fails them, and an infinite distance is no hit.
TEST(DeviceArithmetic, ComparesNaNAndInfinityAsTheRendererNeeds) {
  for (const float number : {-1.0F, 0.0F, 1.0F, kInfinity}) {
    for (const auto& [a, b] : {std::pair{kNaN, number}, std::pair{number, kNaN}}) {
      const Answer answer = computeOne(a, b);
      EXPECT_EQ(answer.isLess, 0U) << a << " < " << b;
      EXPECT_EQ(answer.isNotLess, 0U) << a << " >= " << b;
      for (const float value : {answer.minimum, answer.maximum}) {
        EXPECT_TRUE(std::isnan(value) || value == number) << "minimum or maximum of " << a << " and " << b;
      }
    }
  }
  EXPECT_EQ(computeOne(1.0F, 0.0F).quotient, kInfinity);
  EXPECT_EQ(computeOne(-1.0F, 0.0F).quotient, -kInfinity);
  EXPECT_EQ(computeOne(1.0F, -0.0F).quotient, -kInfinity);
  EXPECT_TRUE(std::isnan(computeOne(0.0F, kInfinity).product));
  EXPECT_EQ(computeOne(3e38F, kInfinity).isLess, 1U);
  const Answer withNaN = computeOne(kNaN, 1.0F);
  const Answer denormal = computeOne(1e-38F, 4.0F);
  report(testDevice().description().driver + ": min(NaN, 1) = " + shortNumber(withNaN.minimum) +
         ", max(NaN, 1) = " + shortNumber(withNaN.maximum) + ", denormal numbers are " +
         (denormal.quotient > 0.0F ? "kept" : "flushed"));
}

double exactPower(float oneMinusCosine, float exponent) {
  if (exponent == 0.0F) return 1.0;
  const double cosine = 1.0 - double{oneMinusCosine};
  return cosine > 0.0 ? std::pow(cosine, double{exponent}) : 0.0;
}

TEST(SpecularPower, IsFiniteAndClose) {
  Random random(97);
  std::vector<Query> queries;
  for (const float exponent : {0.0F, 0.1F, 0.5F, 1.0F, 2.0F, 5.0F, 8.0F, 20.0F, 32.0F, 64.0F, 100.0F, 256.0F,
                               500.0F, 1000.0F, 1e4F, 1e15F}) {
    // 1 - the cosine: of the mirrored direction, of right angles and less, and what is no cosine's.
    for (const float oneMinusCosine : {0.0F, 1e-45F, 1e-38F, 1e-8F, 0.25F, 0.25000003F, 1.0F - 6e-8F, 1.0F,
                                       1.0F + 1.2e-7F, 2.0F, 2.000001F, kNaN, kInfinity}) {
      queries.push_back({oneMinusCosine, exponent, 0.0F, 0});
    }
    for (std::size_t i = 0; i < sized(20'000, 90'000); ++i) {
      const double any = i % 2 == 0 ? uniform(random, 0.0, 1.0) : std::exp2(uniform(random, -24.0, 0.0));
      queries.push_back({static_cast<float>(any), exponent, 0.0F, 0});
    }
  }
  const std::vector<Answer> answers = compute(queries);
  std::size_t outside = 0;
  double largest = 0.0;
  double share = 0.0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const float power = answers[i].specular;
    const float exponent = queries[i].b;
    if (!(power >= 0.0F && double{power} <= 1.0 + 1e-5)) ++outside;
    if (exponent == 0.0F && power != 1.0F) ++outside;
    const double error = std::abs(double{power} - exactPower(queries[i].a, exponent));
    if (exponent <= 1000.0F) largest = std::max(largest, error);
    share = std::max(share, error / (2e-7 * std::max(8.0, double{exponent})));
  }
  EXPECT_EQ(outside, 0U);
  EXPECT_LE(share, 1.0);
  report(grouped(outside) + " of " + grouped(queries.size()) +
         " powers outside [0, 1 + 1e-5], or not 1 where the exponent is 0; off by at most " +
         shortNumber(largest) + " up to an exponent of 1,000, " + shortNumber(share) +
         " of 2e-7 max(8, exponent)");
}

TEST(UnitVector, HasUnitLengthWhateverItsInput) {
  Random random(101);
  std::vector<Query> queries(sized(200'000, 1'500'000));
  // Devices may take denormal numbers for zero, so no component that counts is one there, and divide as they
  // like by what is above 2^126.
  const bool keepsDenormals = computeOne(0x1p-126F, 0.5F).product != 0.0F;
  const double range = keepsDenormals ? 125.0 : 95.0;
  for (Query& query : queries) {
    const double size = std::exp2(uniform(random, -range, range));
    std::normal_distribution<double> normal;
    query.a = static_cast<float>(size * normal(random));
    query.b = random() % 8 == 0 ? 0.0F : static_cast<float>(size * normal(random));
    query.c = random() % 8 == 0 ? 0.0F : static_cast<float>(size * 1e-6 * normal(random));
  }
  const std::vector<Answer> answers = compute(queries);
  double length = 0.0;
  double direction = 0.0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const glm::dvec3 exact = glm::normalize(glm::dvec3(queries[i].a, queries[i].b, queries[i].c));
    const glm::dvec3 actual(answers[i].unitVector);
    length = std::max(length, std::abs(glm::length(actual) - 1.0));
    direction = std::max(direction, glm::distance(exact, actual));
  }
  EXPECT_LE(length, 3e-7);
  EXPECT_LE(direction, 3e-7);
  EXPECT_EQ(glm::length(compute({{0.0F, 0.0F, 0.0F, 0}})[0].unitVector), 0.0F);
  report("length off by at most " + shortNumber(length) + ", direction by " + shortNumber(direction) +
         ", in " + grouped(queries.size()) + " vectors of " +
         (keepsDenormals ? "1e-37 to 1e37" : "1e-28 to 1e28"));
}

}  // namespace
}  // namespace lavaray
