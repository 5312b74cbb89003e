// No shadow ray gets out of a closed room.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "bvh/flatten.hpp"
#include "stress/frame.hpp"
#include "stress/report.hpp"
#include "stress/surface_probe.hpp"

namespace lavaray {
namespace {

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

}  // namespace
}  // namespace lavaray
