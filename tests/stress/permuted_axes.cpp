// The intersection functions do not depend on which axis is which.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "stress/report.hpp"
#include "stress/shape_probe.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

glm::vec3 randomVector(Random& random, float extent) {
  return glm::vec3(randomPoint(random, extent));
}

// A ray towards a box, triangle, sphere or plane of about the same size as its distance.
gpu::ShapeQuery randomShape(gpu::uint shape, Random& random) {
  gpu::ShapeQuery query{};
  query.shape = shape;
  query.tMax = INFINITY;
  query.origin = randomVector(random, 4.0F);
  query.a = randomVector(random, 2.0F);
  query.direction = query.a + randomVector(random, 1.0F) - query.origin;
  query.b = query.a + glm::vec3(1.0F) + randomVector(random, 1.0F);
  if (shape == gpu::kShapeTriangle) {
    query.b = query.a + randomVector(random, 3.0F);
    query.c = query.a + randomVector(random, 3.0F);
  } else if (shape == gpu::kShapeSphere) {
    query.b.x = uniform(random, 0.1F, 2.0F);
  } else if (shape == gpu::kShapePlane) {
    query.a = glm::normalize(query.a);
    query.b.x = uniform(random, -2.0F, 2.0F);
  }
  return query;
}

// The axes in another order, some of them reversed: 48 in all.
struct AxisPermutation {
  std::array<int, 3> axes;
  glm::vec3 signs;

  [[nodiscard]] glm::vec3 operator()(const glm::vec3& v) const {
    return signs * glm::vec3(v[axes[0]], v[axes[1]], v[axes[2]]);
  }
  [[nodiscard]] gpu::ShapeQuery operator()(gpu::ShapeQuery query) const {
    query.origin = (*this)(query.origin);
    query.direction = (*this)(query.direction);
    query.a = (*this)(query.a);
    query.c = (*this)(query.c);
    const bool isPoint = query.shape == gpu::kShapeBox || query.shape == gpu::kShapeTriangle;
    if (isPoint) query.b = (*this)(query.b);
    if (query.shape == gpu::kShapeBox) {
      const glm::vec3 a = query.a;
      query.a = glm::min(a, query.b);
      query.b = glm::max(a, query.b);
    }
    return query;
  }
};

std::vector<AxisPermutation> axisPermutations() {
  std::vector<AxisPermutation> permutations;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int bits = 0; bits < 8; ++bits) {
      const glm::vec3 signs((bits & 1) != 0 ? -1 : 1, (bits & 2) != 0 ? -1 : 1, (bits & 4) != 0 ? -1 : 1);
      permutations.push_back({axes, signs});
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return permutations;
}

// Relative, but for a plane, whose distance is the quotient of two sums that cancel where the ray starts
// close to it or grazes it: there in relation to the terms of these sums.
double differenceOf(const gpu::ShapeQuery& query, float t, float other) {
  const double difference = std::abs(double{t} - double{other});
  if (query.shape != gpu::kShapePlane) return difference == 0.0 ? 0.0 : difference / double{t};
  const glm::vec3 normal = glm::abs(query.a);
  const double terms = glm::dot(normal, glm::abs(query.origin)) + std::abs(query.b.x) +
                       t * glm::dot(normal, glm::abs(query.direction));
  return difference * std::abs(glm::dot(query.a, query.direction)) / terms;
}

TEST(PermutedAxes, AllShapesAreHitAtTheSameDistance) {
  struct Kind {
    gpu::uint shape;
    const char* name;
    double allowed;
  };
  const std::vector<AxisPermutation> permutations = axisPermutations();
  const std::size_t count = sized(20'000, 200'000);
  for (const Kind& kind : {Kind{gpu::kShapeBox, "box", 0.0}, Kind{gpu::kShapeTriangle, "triangle", 0.0},
                           Kind{gpu::kShapeSphere, "sphere", 1e-5}, Kind{gpu::kShapePlane, "plane", 1e-6}}) {
    Random random(71);
    std::vector<gpu::ShapeQuery> queries(count);
    for (gpu::ShapeQuery& query : queries) query = randomShape(kind.shape, random);
    const std::vector<float> expected = intersectShapes(queries);
    const auto hits = std::count_if(expected.begin(), expected.end(), [](float t) { return t < INFINITY; });
    std::size_t decidedOtherwise = 0;
    double largest = 0.0;
    for (const AxisPermutation& permutation : permutations) {
      std::vector<gpu::ShapeQuery> permuted;
      for (const gpu::ShapeQuery& query : queries) permuted.push_back(permutation(query));
      const std::vector<float> actual = intersectShapes(permuted);
      for (std::size_t i = 0; i < count; ++i) {
        if ((actual[i] < INFINITY) != (expected[i] < INFINITY)) {
          ++decidedOtherwise;
        } else if (expected[i] < INFINITY) {
          largest = std::max(largest, differenceOf(queries[i], expected[i], actual[i]));
        }
      }
    }
    EXPECT_LE(decidedOtherwise, count * permutations.size() / 10'000) << kind.name;
    EXPECT_LE(largest, kind.allowed) << kind.name;
    EXPECT_GT(hits, count / 10) << kind.name;
    report(std::string(kind.name) + ": " + grouped(decidedOtherwise) + " of " +
           grouped(count * permutations.size()) + " rays hit or miss otherwise, largest difference of t " +
           shortNumber(largest));
  }
}

}  // namespace
}  // namespace lavaray
