// Shadow rays: none gets out of a closed room, shadows begin where things touch, and a sees b where b sees a.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/parallel.hpp"
#include "gpu/probe.hpp"
#include "gpu/render_scene.hpp"
#include "oracle/oracle.hpp"
#include "stress/report.hpp"
#include "stress/surface_probe.hpp"
#include "visibilityProbeSpirv.spv.h"

namespace lavaray {
namespace {

// Three unit vectors at right angles.
struct Frame {
  glm::dvec3 x{1, 0, 0};
  glm::dvec3 y{0, 1, 0};
  glm::dvec3 z{0, 0, 1};

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

Frame turned() {
  const glm::dvec3 z = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.1, 1.0, 0.2), z));
  return {x, glm::cross(z, x), z};
}

// A box about the camera, seen from inside. Its corners are numbered by bits: x, y, z.
struct Room {
  const char* name;
  Scene scene;
  std::array<glm::dvec3, 8> corners;

  struct Wall {
    std::array<int, 4> corners;  // around it
    glm::dvec3 inward;           // unit normal
  };
  std::array<Wall, 6> walls;
};

constexpr std::array<std::array<int, 4>, 6> kWallCorners{
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
constexpr int kFloor = 2;  // y = lower

// `floorIsPlane`: the walls stand on an infinite plane.
Room makeRoom(const char* name, const glm::dvec3& center, const glm::dvec3& halfSize, const Frame& frame,
              bool floorIsPlane) {
  Room room{name, {}, {}, {}};
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    room.corners[i] = center + frame.at(sign * halfSize);
  }
  for (int wall = 0; wall < 6; ++wall) {
    const auto& c = kWallCorners[wall];
    const glm::dvec3 a = room.corners[c[0]];
    const glm::dvec3 normal = glm::normalize(glm::cross(room.corners[c[1]] - a, room.corners[c[3]] - a));
    room.walls[wall] = {c, glm::dot(center - a, normal) < 0.0 ? -normal : normal};
    if (wall == kFloor && floorIsPlane) {
      addPlane(room.scene, room.walls[wall].inward, a);
    } else {
      addTriangle(room.scene, a, room.corners[c[1]], room.corners[c[2]]);
      addTriangle(room.scene, a, room.corners[c[2]], room.corners[c[3]]);
    }
  }
  return room;
}

std::vector<Room> rooms() {
  std::vector<Room> rooms;
  const glm::dvec3 center(0.1, -0.2, 0.3);
  const glm::dvec3 size(4.0, 2.5, 3.0);
  for (const bool floorIsPlane : {false, true}) {
    rooms.push_back(makeRoom("straight", center, size, Frame{}, floorIsPlane));
    rooms.push_back(makeRoom("turned", center, size, turned(), floorIsPlane));
    rooms.push_back(makeRoom("a hall of 1,000", 100.0 * center, 250.0 * size, turned(), floorIsPlane));
    rooms.push_back(makeRoom("flat", 0.01 * center, {4.0, 0.01, 3.0}, turned(), floorIsPlane));
  }
  return rooms;
}

// In [0, 1], half of the time close to one of its ends.
double oftenNearAnEnd(Random& random) {
  const double away = random() % 2 == 0 ? uniform(random, 0.0, 1.0) : std::exp2(uniform(random, -20.0, 0.0));
  return random() % 2 == 0 ? away : 1.0 - away;
}

glm::dvec3 pointOnWall(const Room& room, const Room::Wall& wall, Random& random) {
  const glm::dvec3 a = room.corners[wall.corners[0]];
  const double s = oftenNearAnEnd(random);
  return a + s * (room.corners[wall.corners[1]] - a) +
         oftenNearAnEnd(random) * (room.corners[wall.corners[3]] - a);
}

// A point on a random wall, and a light outside that is seen from there through another wall: half of the
// time through the edge or the corner where two others touch.
gpu::SurfaceQuery lightOutside(const Room& room, Random& random) {
  const Room::Wall& wall = room.walls[random() % 6];
  const glm::dvec3 point = pointOnWall(room, wall, random);
  glm::dvec3 exit;
  if (random() % 2 == 0) {
    exit = pointOnWall(room, room.walls[random() % 6], random);
  } else {
    const auto& other = room.walls[random() % 6].corners;
    const std::size_t corner = random() % 4;
    const glm::dvec3 from = room.corners[other[corner]];
    const double along = random() % 4 == 0 ? 0.0 : uniform(random, 0.0, 1.0);
    exit = from + along * (room.corners[other[(corner + 1) % 4]] - from);
  }
  gpu::SurfaceQuery query{};
  query.direction = point;  // from the camera, in the origin
  query.light = point + uniform(random, 1.1, 8.0) * (exit - point);
  return query;
}

// Must the light be blocked? Where it is on the inner side of the point's own wall, as that does not block
// it. Points on an edge and lights in a wall, as far as float32 can tell, are left out.
bool mustBeBlocked(const Room& room, const gpu::SurfaceAnswer& answer, const glm::dvec3& light) {
  const bool isPlane = (answer.surface & 0x80000000U) != 0;
  std::size_t own = isPlane ? kFloor : answer.order / 2;
  if (!isPlane && !room.scene.planes.empty() && own >= kFloor) ++own;
  const double roundoff = 2e-6 * glm::distance(room.corners[0], room.corners[7]);
  const glm::dvec3 point(answer.position);
  bool isOutside = false;
  for (std::size_t wall = 0; wall < room.walls.size(); ++wall) {
    const glm::dvec3& inward = room.walls[wall].inward;
    const glm::dvec3& corner = room.corners[room.walls[wall].corners[0]];
    if (wall == own) {
      const glm::dvec3 toLight = light - point;
      if (glm::dot(inward, toLight) < 1e-5 * glm::length(toLight)) return false;
    } else if (glm::dot(inward, point - corner) < roundoff) {
      return false;
    } else if (glm::dot(inward, light - corner) < -roundoff) {
      isOutside = true;
    }
  }
  return isOutside;
}

TEST(ShadowRay, DoesNotLeakOutOfAClosedRoom) {
  const std::vector<Room> all = rooms();
  const std::size_t count = sized(200'000, 2'000'000) / all.size();
  std::size_t rays = 0;
  std::size_t lit = 0;
  for (const Room& room : all) {
    Random random(59);
    std::vector<gpu::SurfaceQuery> queries(count);
    for (gpu::SurfaceQuery& query : queries) query = lightOutside(room, random);
    const auto answers = findPoints(flatten(room.scene, 2), queries);
    std::size_t roomLit = 0;
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_NE(answers[i].surface, kNoSurface) << "a camera ray leaks";
      if (!mustBeBlocked(room, answers[i], queries[i].light)) continue;
      ++rays;
      if (answers[i].blocked == 0) ++roomLit;
    }
    EXPECT_EQ(roomLit, 0U) << room.name << (room.scene.planes.empty() ? "" : ", floor is a plane");
    lit += roomLit;
  }
  EXPECT_GT(rays, sized(100'000, 1'000'000));
  report(grouped(lit) + " lit points in " + grouped(rays) + " shadow rays out of " +
         std::to_string(all.size()) + " closed rooms");
}

// The longest row or column of pixels that `isWrong` is true of.
template <typename IsWrong>
int longestRun(const Rectangle& area, const IsWrong& isWrong) {
  int longest = 0;
  const auto scan = [&](int lines, int length, const auto& pixel) {
    for (int line = 0; line < lines; ++line) {
      int run = 0;
      for (int i = 0; i < length; ++i) {
        run = pixel(line, i) ? run + 1 : 0;
        longest = std::max(longest, run);
      }
    }
  };
  const int width = area.x1 - area.x0;
  const int height = area.y1 - area.y0;
  scan(height, width, [&](int y, int x) { return isWrong(x, y); });
  scan(width, height, [&](int x, int y) { return isWrong(x, y); });
  return longest;
}

// A sphere that rests on a plane, seen from `distance` and `height`, so that it has the same size in the
// picture.
Scene restingSphere(double distance, double height, const glm::dvec3& toLight, const Frame& frame) {
  Scene scene;
  const double focalLength = 540.0 * std::sqrt(3.0) * distance / 6.0;
  const double fovDegrees = 2.0 * std::atan(540.0 / focalLength) * 180.0 / std::numbers::pi;
  scene.camera = {{0.0, 0.0, 0.0}, fovDegrees, focalLength, 1920.0 / 1080.0};
  const glm::dvec3 contact = glm::dvec3(0.0, -height, -distance);
  const glm::dvec3 up = frame.y;
  scene.materials = {{glm::dvec3(0.1), glm::dvec3(0.0), glm::dvec3(0.0), 1.0, {}},
                     {glm::dvec3(0.1), glm::dvec3(0.8), glm::dvec3(0.0), 1.0, {}}};
  scene.spheres = {{contact + up, 1.0, 0}};
  scene.planes = {{up, contact, 1}};
  scene.lights = {{contact + frame.at(toLight), glm::dvec3(0.5), glm::dvec3(1.0), glm::dvec3(0.0)}};
  return scene;
}

TEST(ContactShadow, BeginsWithinAPixelOfTheContact) {
  const Frame tilted{
      glm::normalize(glm::dvec3(1.0, -0.3, 0.0)), glm::normalize(glm::dvec3(0.3, 1.0, 0.0)), {0, 0, 1}};
  int worst = 0;
  std::size_t pixels = 0;
  std::size_t shadowed = 0;
  std::size_t gaps = 0;
  for (const Frame& frame : {Frame{}, tilted}) {
    for (const double distance : {6.0, 600.0}) {
      for (const double slope : {0.01, 0.2}) {
        for (const glm::dvec3& toLight : {glm::dvec3(0.0, 20.0, 0.0), glm::dvec3(3.0, 4.0, 5.0)}) {
          const Scene scene = restingSphere(distance, slope * distance, toLight, frame);
          ASSERT_EQ(imageSize(scene.camera), (ImageSize{1920, 1080}));
          // Around the contact, a third of the radius each way.
          const int row = 540 + static_cast<int>(935.0 * slope);
          const Rectangle area{910, row - 50, 1010, std::min(row + 50, 1080)};
          const Image image = renderScene(scene, ImageSize{1920, 1080}, area).image;
          const oracle::Result expected = oracle::render(
              scene, {.x0 = area.x0, .y0 = area.y0, .x1 = area.x1, .y1 = area.y1, .probeOffset = 0.0});
          const auto isDark = [](double value) { return value < 0.11; };
          const auto isGap = [&](int x, int y) {
            const std::size_t i = static_cast<std::size_t>(y) * expected.width + x;
            return isDark(expected.pixels[i].color.r) && !isDark(image.rgb[3 * i]);
          };
          worst = std::max(worst, longestRun(area, isGap));
          for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
            ++pixels;
            if (isDark(expected.pixels[i].color.r)) ++shadowed;
            if (isGap(static_cast<int>(i) % expected.width, static_cast<int>(i) / expected.width)) ++gaps;
          }
        }
      }
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(shadowed, pixels / 10);
  EXPECT_LT(shadowed, pixels);
  report("a gap of " + std::to_string(worst) + " pixels at most at 1920 x 1080; " + grouped(gaps) + " of " +
         grouped(shadowed) + " shadowed pixels next to contacts are lit");
}

// A scene with surfaces of all kinds.
Scene symmetryScene() {
  Random random(61);
  Scene scene;
  Grid grid = sphereGrid(32, 0.1, random);
  for (auto& ring : grid) {
    for (glm::dvec3& point : ring) point = 3.0 * point + glm::dvec3(-5.0, 0.0, 1.0);
  }
  addGrid(scene, grid, random);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 center = randomPoint(random, 10.0);
    addSphere(scene, center, uniform(random, 0.3, 1.5));
  }
  addRandomTriangles(scene, 60, glm::dvec3(0.0), random);
  addPlane(scene, {0.1, 1.0, 0.2}, {0.0, -6.0, 0.0});
  return scene;
}

// Whether the point is farther than `clearance` from every surface, and in no sphere: a sphere is seen from
// outside only. Near a triangle's plane it counts as near the triangle wherever that may reach.
bool isClear(const Scene& scene, const glm::dvec3& p, double clearance) {
  for (const Plane& plane : scene.planes) {
    if (std::abs(glm::dot(glm::normalize(plane.normal), p - plane.point)) < clearance) return false;
  }
  for (const Sphere& sphere : scene.spheres) {
    if (glm::distance(p, sphere.center) < sphere.radius + clearance) return false;
  }
  for (const Triangle& triangle : scene.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    const double reach = std::max(glm::distance(a, b), glm::distance(a, c)) + clearance;
    if (glm::distance(p, a) > reach) continue;
    if (std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), p - a)) < clearance) return false;
  }
  return true;
}

TEST(ShadowRay, FindsTheSameInBothDirections) {
  constexpr double kScale = 10.0;
  const Scene scene = symmetryScene();
  Random random(67);
  std::vector<gpu::PointPair> pairs(sized(100'000, 1'000'000));
  for (gpu::PointPair& pair : pairs) pair = {randomPoint(random, kScale), 0, randomPoint(random, kScale), 0};
  const GpuScene gpuScene = flatten(scene, 2);
  const gpu::SurfaceConstants constants{static_cast<gpu::uint>(pairs.size())};
  const auto answers = runProbe<gpu::PairAnswer>(visibilityProbeSpirv, gpuScene, pairs, constants);

  std::vector<char> clear(pairs.size());
  parallelFor(pairs.size(), hardwareThreads(), [&](std::size_t i) {
    clear[i] = isClear(scene, pairs[i].a, 1e-4 * kScale) && isClear(scene, pairs[i].b, 1e-4 * kScale);
  });
  std::size_t counted = 0;
  std::size_t blocked = 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (clear[i] == 0) continue;
    ++counted;
    blocked += answers[i].blockedFromAToB;
    if (answers[i].blockedFromAToB != answers[i].blockedFromBToA) ++differing;
  }
  EXPECT_EQ(differing, 0U);
  EXPECT_GT(counted, pairs.size() / 2);
  EXPECT_GT(blocked, counted / 4);
  EXPECT_LT(blocked, 3 * counted / 4);
  report(grouped(differing) + " of " + grouped(counted) +
         " pairs of points see each other in one direction only, " + grouped(blocked) +
         " do not see each other");
}

}  // namespace
}  // namespace lavaray
