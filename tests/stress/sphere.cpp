// The sphere test on the device against 113-bit arithmetic: small and distant spheres, and spheres for
// floors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "stress/quad.hpp"
#include "stress/report.hpp"
#include "stress/shape_probe.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

using Quad3 = std::array<Quad, 3>;

Quad dot(const Quad3& a, const Quad3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

constexpr double kHalfUlp = 0x1p-24;

// What the ray does in truth. Coordinates, differences and products of two are exact in Quad; products of
// four are rounded at the 113th bit, which is far below all thresholds here.
struct Truth {
  bool hit;
  double t;            // of the near side
  double passing;      // distance of the line from the centre in radii
  double sensitivity;  // relative change of t where the direction turns by one half of 2^-23
};

Truth exactSphere(const gpu::ShapeQuery& query) {
  Quad3 f;
  Quad3 d;
  for (int axis = 0; axis < 3; ++axis) {
    f[axis] = Quad(query.origin[axis]) - query.a[axis];
    d[axis] = query.direction[axis];
  }
  const Quad radius2 = Quad(query.b.x) * query.b.x;
  const Quad a = dot(d, d);
  const Quad b = -dot(f, d);
  const Quad c = dot(f, f) - radius2;
  const Quad discriminant = b * b - a * c;
  const auto passing = std::sqrt(std::max(0.0, static_cast<double>(1 - discriminant / (a * radius2))));
  if (b <= 0 || c <= 0 || discriminant < 0) return {false, INFINITY, passing, 0.0};
  // No cancellation is left, so the root need not be a quadruple one.
  const auto root = std::sqrt(static_cast<long double>(discriminant));
  const auto t = static_cast<double>(static_cast<long double>(c) / (static_cast<long double>(b) + root));
  const auto halfChord = static_cast<double>(root / std::sqrt(static_cast<long double>(a)));
  return {true, t, passing, kHalfUlp * passing * double{query.b.x} / halfChord};
}

// A sphere of any radius at `distance` radii, seen from the coordinates' origin or from anywhere, and a ray
// that passes its centre at up to 1.02 radii, uniformly distributed over that disc.
gpu::ShapeQuery distantSphere(double distance, bool fromOrigin, Random& random) {
  const double radius = std::exp2(uniform(random, -10.0, 10.0));
  const glm::dvec3 axis = randomDirection(random);
  const glm::dvec3 side = glm::normalize(glm::cross(axis, randomDirection(random)));
  const double away = fromOrigin ? 0.0 : distance * radius * uniform(random, 0.0, 1.0);
  const glm::vec3 origin(away * randomDirection(random));
  const glm::vec3 center(glm::dvec3(origin) + distance * radius * axis);
  const glm::dvec3 target = glm::dvec3(center) + 1.02 * radius * std::sqrt(uniform(random, 0.0, 1.0)) * side;
  gpu::ShapeQuery query{};
  query.shape = gpu::kShapeSphere;
  query.origin = origin;
  query.direction = (target - glm::dvec3(origin)) * uniform(random, 0.5, 1.0);
  query.a = center;
  query.b.x = static_cast<float>(radius);
  return query;
}

// Distance from the silhouette, in radii, within which float32 may decide otherwise than exact arithmetic.
double undecidedBand(double distanceInRadii) {
  return 1e-6 + 2e-7 * distanceInRadii;
}

struct Comparison {
  std::size_t wrong = 0;       // hit or miss
  double farthestWrong = 0.0;  // of those, |1 - passing| at most
  std::size_t hits = 0;
  double largestOffEdge = 0.0;    // relative error of t 1e-3 radii and more off the silhouette
  double largestError = 0.0;      // where rounding the direction changes t by less than `allowedError`
  double largestSensitive = 0.0;  // elsewhere, in units of what rounding the direction changes t by
};

// Close to its silhouette a sphere is hit at a distance that changes with the last bits of the direction:
// there no arithmetic in float32 is better than those.
Comparison compareWithExact(const std::vector<gpu::ShapeQuery>& queries, double allowedError) {
  const std::vector<float> distances = intersectShapes(queries);
  std::vector<Truth> truths(queries.size());
  parallelFor(queries.size(), hardwareThreads(), [&](std::size_t i) { truths[i] = exactSphere(queries[i]); });
  Comparison result;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Truth& truth = truths[i];
    const bool hit = distances[i] < INFINITY;
    const double edge = std::abs(1.0 - truth.passing);
    if (hit != truth.hit) {
      ++result.wrong;
      result.farthestWrong = std::max(result.farthestWrong, edge);
    } else if (hit) {
      ++result.hits;
      const double error = std::abs(double{distances[i]} / truth.t - 1.0);
      if (edge > 1e-3) result.largestOffEdge = std::max(result.largestOffEdge, error);
      if (truth.sensitivity < allowedError) {
        result.largestError = std::max(result.largestError, error);
      } else {
        result.largestSensitive = std::max(result.largestSensitive, error / truth.sensitivity);
      }
    }
  }
  return result;
}

struct DistantCase {
  double distance;      // in radii
  double allowedWrong;  // share of the rays
};
constexpr std::array kDistantCases{DistantCase{10.0, 1e-4}, DistantCase{1e2, 1e-4}, DistantCase{1e3, 1e-4},
                                   DistantCase{1e4, 5e-4}};

std::vector<gpu::ShapeQuery> distantSpheres(double distance, bool fromOrigin) {
  Random random(19);
  std::vector<gpu::ShapeQuery> queries(sized(100'000, 1'000'000));
  for (gpu::ShapeQuery& query : queries) query = distantSphere(distance, fromOrigin, random);
  return queries;
}

std::string from(bool fromOrigin) {
  return fromOrigin ? " from the origin" : " from anywhere";
}

TEST(DistantSphere, IsHitAndMissedAsInExactArithmetic) {
  for (const DistantCase& c : kDistantCases) {
    for (const bool fromOrigin : {true, false}) {
      const std::vector<gpu::ShapeQuery> queries = distantSpheres(c.distance, fromOrigin);
      const Comparison result = compareWithExact(queries, 1e-5);
      const double share = static_cast<double>(result.wrong) / static_cast<double>(queries.size());
      EXPECT_LE(share, c.allowedWrong) << c.distance << " radii" << from(fromOrigin);
      EXPECT_LE(result.farthestWrong, undecidedBand(c.distance))
          << c.distance << " radii" << from(fromOrigin);
      EXPECT_GT(result.hits, queries.size() / 2);
      report(shortNumber(c.distance) + " radii" + from(fromOrigin) + ": " + grouped(result.wrong) + " of " +
             grouped(queries.size()) + " rays wrong (" + shortNumber(100.0 * share) + " %), all within " +
             shortNumber(result.farthestWrong) + " radii of the silhouette");
    }
  }
}

constexpr double kAllowedSensitivity = 1.0;  // of Comparison::largestSensitive

std::string errorsOf(const Comparison& result) {
  return "relative error of t at most " + shortNumber(result.largestError) +
         " (1e-3 radii off the silhouette " + shortNumber(result.largestOffEdge) + ", right on it " +
         shortNumber(result.largestSensitive) + " times that of rounding the direction) in " +
         grouped(result.hits) + " hits";
}

TEST(DistantSphere, IsHitAtTheExactDistance) {
  for (const DistantCase& c : kDistantCases) {
    for (const bool fromOrigin : {true, false}) {
      const Comparison result = compareWithExact(distantSpheres(c.distance, fromOrigin), 1e-5);
      EXPECT_LE(result.largestOffEdge, 2e-6) << c.distance << " radii" << from(fromOrigin);
      EXPECT_LE(result.largestError, 1e-5) << c.distance << " radii" << from(fromOrigin);
      EXPECT_LE(result.largestSensitive, kAllowedSensitivity) << c.distance << " radii" << from(fromOrigin);
      report(shortNumber(c.distance) + " radii" + from(fromOrigin) + ": " + errorsOf(result));
    }
  }
}

// The camera is 1 above a floor that is a sphere, below it along an axis, and looks down by 0.02 radians or
// more.
TEST(FloorSphere, IsHitAtTheExactDistance) {
  for (const double radius : {1e3, 1e5, 1e6}) {
    Random random(23);
    std::vector<gpu::ShapeQuery> queries(sized(100'000, 1'000'000));
    for (gpu::ShapeQuery& query : queries) {
      const auto up = static_cast<int>(random() % 3);
      const float sign = random() % 2 == 0 ? 1.0F : -1.0F;
      const double elevation = -0.02 * std::pow(std::numbers::pi / 0.04, uniform(random, 0.0, 1.0));
      const double azimuth = uniform(random, 0.0, 2.0 * std::numbers::pi);
      query.shape = gpu::kShapeSphere;
      query.a[up] = -sign * static_cast<float>(radius + 1.0);
      query.b.x = static_cast<float>(radius);
      query.direction[up] = sign * static_cast<float>(std::sin(elevation));
      query.direction[(up + 1) % 3] = static_cast<float>(std::cos(elevation) * std::cos(azimuth));
      query.direction[(up + 2) % 3] = static_cast<float>(std::cos(elevation) * std::sin(azimuth));
    }
    const Comparison result = compareWithExact(queries, 5e-6);
    EXPECT_LE(result.largestError, 5e-6) << "radius " << radius;
    EXPECT_LE(result.largestSensitive, kAllowedSensitivity) << "radius " << radius;
    EXPECT_LE(result.farthestWrong, undecidedBand(1.0)) << "radius " << radius;
    EXPECT_GT(result.hits, queries.size() / 2) << "radius " << radius;  // the horizon of a small one is lower
    report("radius " + shortNumber(radius) + ": " + errorsOf(result));
  }
}

// Spheres are seen from outside only.
TEST(Sphere, IsNotSeenFromInside) {
  Random random(29);
  std::vector<gpu::ShapeQuery> queries(sized(100'000, 1'000'000));
  for (gpu::ShapeQuery& query : queries) {
    query = distantSphere(uniform(random, 0.0, 0.99999), false, random);
  }
  const std::vector<float> distances = intersectShapes(queries);
  const auto seen = std::count_if(distances.begin(), distances.end(), [](float t) { return t < INFINITY; });
  EXPECT_EQ(seen, 0);
  report(grouped(static_cast<std::uint64_t>(seen)) + " hits in " + grouped(queries.size()) +
         " rays from inside");
}

}  // namespace
}  // namespace lavaray
