#include "scene/triangulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace lavaray {
namespace {

using Polygon = std::vector<glm::dvec3>;
using Corners = Triangulator::Corners;

Polygon flat(std::initializer_list<glm::dvec2> corners) {
  Polygon polygon;
  for (const glm::dvec2& corner : corners) polygon.emplace_back(corner, 0.0);
  return polygon;
}

glm::dvec3 twiceArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

glm::dvec3 twiceArea(const Polygon& polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += twiceArea(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

std::vector<Corners> triangulated(const Polygon& polygon) {
  return Triangulator().triangulate(polygon);
}

// Of a flat polygon: as many triangles as expected, all of the polygon's winding, which together have its
// area. Triangles of one winding inside whose areas add up to the polygon's are a partition of it.
void expectPartition(const Polygon& polygon, std::size_t expectedCount, double tolerance = 1e-9) {
  const auto triangles = triangulated(polygon);
  EXPECT_EQ(triangles.size(), expectedCount);
  const glm::dvec3 whole = twiceArea(polygon);
  const glm::dvec3 normal = glm::normalize(whole);
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const double area = glm::dot(twiceArea(polygon[a], polygon[b], polygon[c]), normal);
    EXPECT_GT(area, 0.0);
    sum += area;
  }
  EXPECT_NEAR(sum, glm::length(whole), tolerance * glm::length(whole));
}

// Every diagonal is shared by two triangles in opposite directions, every side belongs to one.
void expectMatchingSides(std::size_t corners, const std::vector<Corners>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(sides.emplace(t[i], t[(i + 1) % 3]).second);
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    EXPECT_TRUE(sides.contains({i, static_cast<std::uint32_t>((i + 1) % corners)})) << i;
  }
  for (const auto& [from, to] : sides) {
    EXPECT_TRUE((from + 1) % corners == to || sides.contains({to, from})) << from << " " << to;
  }
}

// About the origin at any angle: visible from there, hence simple.
Polygon randomStar(std::mt19937& random, std::size_t corners) {
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    polygon.push_back(radius(random) * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return polygon;
}

glm::dvec3 randomVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

// Into a random plane, a random distance from the origin.
Polygon placed(const Polygon& polygon, std::mt19937& random, double distance) {
  const glm::dvec3 u = glm::normalize(randomVector(random));
  const glm::dvec3 v = glm::normalize(glm::cross(u, randomVector(random)));
  const glm::dvec3 origin = distance * randomVector(random);
  Polygon result;
  for (const glm::dvec3& p : polygon) result.push_back(origin + p.x * u + p.y * v);
  return result;
}

TEST(HasArea, IsOfAnySize) {
  const glm::dvec3 o(0.0);
  EXPECT_TRUE(hasArea(o, {1, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(hasArea(o, {1e-200, 0, 0}, {0, 1e-200, 0}));
  EXPECT_TRUE(hasArea(o, {5e-324, 0, 0}, {0, 5e-324, 0}));
  EXPECT_TRUE(hasArea({1e15, -1e15, 1e15}, {-1e15, 1e15, 1e15}, {1e15, 1e15, -1e15}));
  EXPECT_TRUE(hasArea(o, {1e-300, 0, 0}, {0, 1e15, 0}));
}

TEST(HasArea, NotOfPointsAndLines) {
  const glm::dvec3 o(0.0);
  EXPECT_FALSE(hasArea(o, o, o));
  EXPECT_FALSE(hasArea({1, 2, 3}, {1, 2, 3}, {4, 5, 6}));
  EXPECT_FALSE(hasArea({4, 5, 6}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_FALSE(hasArea(o, {1, 2, 3}, {3, 6, 9}));
  EXPECT_FALSE(hasArea(o, {1e-200, 2e-200, 3e-200}, {3e-200, 6e-200, 9e-200}));
}

TEST(Triangulate, TriangleStays) {
  EXPECT_EQ(triangulated(flat({{0, 0}, {1, 0}, {0, 1}})), (std::vector<Corners>{{0, 1, 2}}));
  EXPECT_EQ(triangulated(flat({{0, 0}, {0, 1}, {1, 0}})), (std::vector<Corners>{{0, 1, 2}}));
  EXPECT_TRUE(triangulated(flat({{0, 0}, {1, 1}, {2, 2}})).empty());
}

TEST(Triangulate, ConvexIsAFan) {
  const auto pentagon = flat({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}});
  EXPECT_EQ(triangulated(pentagon), (std::vector<Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Triangulate, ConcaveQuadIsSplitAtTheReflexCorner) {
  // An arrowhead, its notch at each of the corners in turn, in both windings.
  Polygon arrow = flat({{0, 0}, {4, -2}, {1, 0}, {4, 2}});
  for (int winding = 0; winding < 2; ++winding) {
    for (std::size_t shift = 0; shift < 4; ++shift) {
      expectPartition(arrow, 2);
      std::ranges::rotate(arrow, arrow.begin() + 1);
    }
    std::ranges::reverse(arrow);
  }
}

TEST(Triangulate, FacingEveryAxis) {
  const Polygon letter = flat({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Polygon turned;
      for (const glm::dvec3& p : letter) {
        glm::dvec3 q(5.0);
        q[(axis + 1) % 3] = p.x;
        q[(axis + 2) % 3] = sign * p.y;
        turned.push_back(q);
      }
      expectPartition(turned, 4);
      expectMatchingSides(6, triangulated(turned));
    }
  }
}

TEST(Triangulate, CornersOnALine) {
  // Every side of a square has corners on it.
  const Polygon square = flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  expectPartition(square, 6);
  expectMatchingSides(8, triangulated(square));
  const Polygon triangle = flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}});
  expectPartition(triangle, 3);
  expectMatchingSides(5, triangulated(triangle));
}

TEST(Triangulate, CoincidentCornersCostOneTriangleEach) {
  expectPartition(flat({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}), 2);
  expectPartition(flat({{0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}}), 2);
  expectPartition(flat({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}), 2);
  expectPartition(flat({{0, 0}, {4, -2}, {1, 0}, {1, 0}, {4, 2}}), 2);
}

TEST(Triangulate, SpikeIsDropped) {
  expectPartition(flat({{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {0, 2}}), 2);
}

TEST(Triangulate, HoleByABridge) {
  expectPartition(flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}), 8);
}

TEST(Triangulate, NothingWithoutArea) {
  EXPECT_TRUE(triangulated(flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}})).empty());
  EXPECT_TRUE(triangulated(flat({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 1}})).empty());
}

TEST(Triangulate, AnySizeAndPlace) {
  for (const double size : {1e-300, 1e-160, 1.0, 1e14}) {
    Polygon arrow = flat({{0, 0}, {4, -2}, {1, 0}, {4, 2}});
    for (glm::dvec3& p : arrow) p *= size;
    const auto triangles = triangulated(arrow);
    EXPECT_EQ(triangles, (std::vector<Corners>{{0, 1, 2}, {0, 2, 3}})) << size;
  }
  Polygon far = flat({{0, 0}, {4, -2}, {1, 0}, {4, 2}});
  for (glm::dvec3& p : far) p = 0.001 * p + glm::dvec3(1e5, -1e5, 1e5);
  expectPartition(far, 2);
}

TEST(Triangulate, SaddleIsCovered) {
  const Polygon saddle{{0, 0, 1}, {1, 0, -1}, {1, 1, 1}, {0, 1, -1}};
  EXPECT_EQ(triangulated(saddle), (std::vector<Corners>{{0, 1, 2}, {0, 2, 3}}));
}

// A thin, bent quad of a real mesh. Seen along the axis that it faces most, two of its sides cross.
TEST(Triangulate, BentQuadLeavesNoHole) {
  Polygon quad{{11.424191, 227.11412, 46.411819},
               {11.773045, 227.911987, 46.302418},
               {11.707062, 227.626556, 46.342155},
               {11.41707, 226.8853, 46.168762}};
  for (int shift = 0; shift < 4; ++shift) {
    const auto triangles = triangulated(quad);
    EXPECT_EQ(triangles.size(), 2U);
    expectMatchingSides(4, triangles);
    std::ranges::rotate(quad, quad.begin() + 1);
  }
}

TEST(Triangulate, RandomBentPolygonsLeaveNoHole) {
  std::mt19937 random(4);
  for (std::size_t corners = 4; corners < 30; ++corners) {
    for (int repetition = 0; repetition < 50; ++repetition) {
      Polygon polygon;
      for (std::size_t i = 0; i < corners; ++i) polygon.push_back(randomVector(random));
      const auto triangles = triangulated(polygon);
      EXPECT_EQ(triangles.size(), corners - 2);
      expectMatchingSides(corners, triangles);
    }
  }
}

TEST(Triangulate, RandomStars) {
  std::mt19937 random(1);
  for (std::size_t corners = 4; corners < 60; ++corners) {
    for (int repetition = 0; repetition < 20; ++repetition) {
      Polygon star = placed(randomStar(random, corners), random, repetition % 2 == 0 ? 0.0 : 1e5);
      expectPartition(star, corners - 2, 1e-6);
      expectMatchingSides(corners, triangulated(star));
      std::ranges::reverse(star);
      expectPartition(star, corners - 2, 1e-6);
    }
  }
}

TEST(Triangulate, GridPolygonsWithTouchingCorners) {
  // Steps up and down on a coarse grid: many corners on a line with others and with diagonals.
  std::mt19937 random(2);
  std::uniform_int_distribution<int> height(1, 4);
  for (int repetition = 0; repetition < 300; ++repetition) {
    Polygon polygon = flat({{0, 0}, {12, 0}});
    for (int x = 12; x > 0; --x) {
      const double y = height(random);
      polygon.emplace_back(x, y, 0.0);
      polygon.emplace_back(x - 1, y, 0.0);
    }
    // Equal neighbours coincide.
    const auto end = std::ranges::unique(polygon).begin();
    polygon.erase(end, polygon.end());
    expectPartition(polygon, polygon.size() - 2);
    expectMatchingSides(polygon.size(), triangulated(polygon));
  }
}

TEST(Triangulate, TenThousandCornersTakeNoLongTime) {
  std::mt19937 random(3);
  const auto start = std::chrono::steady_clock::now();
  const Polygon star = randomStar(random, 10000);
  expectPartition(star, 9998);
  Polygon chaos;
  for (int i = 0; i < 10000; ++i) chaos.push_back(randomVector(random));
  EXPECT_EQ(triangulated(chaos).size(), 9998U);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 30.0);
}

}  // namespace
}  // namespace lavaray
