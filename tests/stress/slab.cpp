// The slab test on the device against exact arithmetic: no box that a ray hits may be missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "stress/quad.hpp"
#include "stress/report.hpp"
#include "stress/shape_probe.hpp"
#include "support/random_numbers.hpp"

namespace lavaray {
namespace {

// What a scenario does to a generic box and ray; see makeQuery.
struct Scenario {
  const char* name;
  float offset = 0.0F;            // of box and origin from the coordinates' origin
  int zeros = 0;                  // direction components that are 0 or -0
  bool onSlab = false;            // the origin lies in the plane of a side, on those axes or on one
  bool tinyComponents = false;    // direction components down to denormal numbers
  bool endsAtTheBox = false;      // the ray ends at about the box
  bool startsInOrBehind = false;  // the origin may be in the box, and the box behind the ray
};

constexpr std::array kScenarios{
    Scenario{.name = "generic"},
    Scenario{.name = "at 1e5", .offset = 1e5F},
    Scenario{.name = "one zero component", .zeros = 1},
    Scenario{.name = "two zero components", .zeros = 2},
    Scenario{.name = "one zero component, origin on a side's plane", .zeros = 1, .onSlab = true},
    Scenario{.name = "two zero components, origin on two sides' planes", .zeros = 2, .onSlab = true},
    Scenario{.name = "origin on a side's plane", .onSlab = true},
    Scenario{.name = "two zero components, origin on two sides' planes, at 1e5",
             .offset = 1e5F,
             .zeros = 2,
             .onSlab = true},
    Scenario{.name = "tiny components", .tinyComponents = true},
    Scenario{.name = "ray ends at the box", .endsAtTheBox = true},
    Scenario{.name = "origin in the box, or box behind", .onSlab = true, .startsInOrBehind = true}};

// A third of the extents are 0. The ray is aimed at a corner, an edge, a face or the inside of the box, with
// a direction of any length.
gpu::ShapeQuery makeQuery(const Scenario& scenario, Random& random) {
  gpu::ShapeQuery query{};
  query.shape = gpu::kShapeBox;
  query.tMax = INFINITY;
  std::array<bool, 3> isZero{};
  for (int i = 0; i < scenario.zeros; ++i) isZero[(random() % 3 + i) % 3] = true;
  const auto slabAxis = static_cast<int>(random() % 3);
  for (int axis = 0; axis < 3; ++axis) {
    float& lower = query.a[axis];
    float& upper = query.b[axis];
    float& origin = query.origin[axis];
    lower = scenario.offset + uniform(random, -10.0F, 10.0F);
    upper = random() % 3 == 0 ? lower : lower + uniform(random, 0.0F, 5.0F);
    origin = scenario.offset + uniform(random, -20.0F, 20.0F);
    if (scenario.startsInOrBehind) origin = lower + (upper - lower) * uniform(random, -0.5F, 1.5F);
    const bool onSlab = scenario.onSlab && (scenario.zeros > 0 ? isZero[axis] : axis == slabAxis);
    if (isZero[axis] || (scenario.tinyComponents && axis == slabAxis)) {
      origin = lower + (upper - lower) * uniform(random, -0.05F, 1.05F);
    }
    if (onSlab) origin = random() % 2 == 0 ? lower : upper;
    const auto choice = random() % 3;
    const float target =
        choice == 0 ? lower : (choice == 1 ? upper : lower + (upper - lower) * uniform(random, 0.0F, 1.0F));
    query.direction[axis] = target - origin;
    if (isZero[axis]) query.direction[axis] = random() % 2 == 0 ? 0.0F : -0.0F;
    if (scenario.startsInOrBehind && random() % 2 == 0) query.direction[axis] = -query.direction[axis];
  }
  // Half of the directions keep their exact ends, the others are rounded.
  float scale = std::ldexp(1.0F, static_cast<int>(random() % 41) - 20);
  if (random() % 2 == 0) scale *= uniform(random, 0.5F, 1.0F);
  query.direction *= scale;
  if (scenario.endsAtTheBox) query.tMax = uniform(random, 1.0F - 3e-7F, 1.0F + 3e-7F) / scale;
  if (scenario.tinyComponents) {
    query.direction[slabAxis] *= std::ldexp(1.0F, -static_cast<int>(random() % 140));
  }
  return query;
}

// A parameter of the ray as an exact fraction; the denominator is positive.
struct Bound {
  Quad numerator;
  Quad denominator;
};

// By how much, relatively, the box's exit must be widened for the exact ray to hit it: 0 for a hit, infinity
// where no widening helps. No number is rounded but the result: differences of coordinates and their products
// with a component have at most 113 bits here, as the slabs' parameters are compared without a division.
double wideningToHit(const gpu::ShapeQuery& query) {
  std::array<Bound, 4> entries{Bound{0, 1}};
  std::array<Bound, 4> exits{};
  std::size_t bounds = 1;
  std::size_t exitCount = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Quad origin = query.origin[axis];
    const Quad direction = query.direction[axis];
    const Quad lower = query.a[axis] - origin;
    const Quad upper = query.b[axis] - origin;
    if (direction == 0) {
      if (lower > 0 || upper < 0) return INFINITY;
      continue;
    }
    entries[bounds++] = direction > 0 ? Bound{lower, direction} : Bound{-upper, -direction};
    exits[exitCount++] = direction > 0 ? Bound{upper, direction} : Bound{-lower, -direction};
  }
  if (std::isfinite(query.tMax)) exits[exitCount++] = Bound{query.tMax, 1};
  double widening = 0.0;
  for (std::size_t i = 0; i < bounds; ++i) {
    for (std::size_t k = 0; k < exitCount; ++k) {
      const Quad entry = entries[i].numerator * exits[k].denominator;
      const Quad exit = exits[k].numerator * entries[i].denominator;
      if (entry <= exit) continue;
      if (exit <= 0) return INFINITY;
      widening = std::max(widening, static_cast<double>((entry - exit) / exit));
    }
  }
  return widening;
}

struct Outcome {
  std::size_t trueHits = 0;
  std::size_t falseMisses = 0;
  std::size_t falseHits = 0;
  double widest = 0.0;  // of the false hits
};

Outcome compareWithExact(const Scenario& scenario, std::size_t count) {
  Random random(17);
  std::vector<gpu::ShapeQuery> queries(count);
  for (gpu::ShapeQuery& query : queries) query = makeQuery(scenario, random);
  const std::vector<float> entries = intersectShapes(queries);
  std::vector<double> widenings(count);
  constexpr std::size_t kChunk = 4096;
  parallelFor((count + kChunk - 1) / kChunk, hardwareThreads(), [&](std::size_t chunk) {
    const std::size_t end = std::min(count, (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) widenings[i] = wideningToHit(queries[i]);
  });
  Outcome outcome;
  for (std::size_t i = 0; i < count; ++i) {
    const bool hit = entries[i] < INFINITY;
    if (widenings[i] == 0.0) {
      ++outcome.trueHits;
      if (!hit) ++outcome.falseMisses;
    } else if (hit) {
      ++outcome.falseHits;
      outcome.widest = std::max(outcome.widest, widenings[i]);
    }
  }
  return outcome;
}

TEST(Slab, MissesNoBoxThatARayHits) {
  const std::size_t count = sized(60'000, 600'000);
  const double ulp = std::ldexp(1.0, -23);
  Outcome total;
  for (const Scenario& scenario : kScenarios) {
    const Outcome outcome = compareWithExact(scenario, count);
    EXPECT_EQ(outcome.falseMisses, 0U) << scenario.name;
    EXPECT_LE(outcome.widest, 4.0 * ulp) << scenario.name;
    EXPECT_GT(outcome.trueHits, count / 10) << scenario.name;
    report(std::string(scenario.name) + ": " + grouped(outcome.falseMisses) + " false misses in " +
           grouped(outcome.trueHits) + " hits; " + grouped(outcome.falseHits) + " false hits, by at most " +
           shortNumber(outcome.widest / ulp) + " ulp");
    total.trueHits += outcome.trueHits;
    total.falseMisses += outcome.falseMisses;
  }
  report(grouped(total.falseMisses) + " false misses in " + grouped(total.trueHits) + " hits of " +
         grouped(count * kScenarios.size()) + " boxes");
}

}  // namespace
}  // namespace lavaray
