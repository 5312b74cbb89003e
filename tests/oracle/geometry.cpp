#include "oracle/geometry.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

namespace lavaray::oracle {
namespace {

using glm::dvec3;

constexpr std::size_t kBlock = 64;

void addFacet(Geometry& geometry, Facet facet) {
  const auto& [a, b, c] = facet.corners;
  facet.normal = glm::normalize(glm::cross(b - a, c - a));
  const dvec3 center = (a + b + c) / 3.0;
  double radius = 0.0;
  for (const dvec3& corner : facet.corners) radius = std::max(radius, glm::distance(center, corner));
  geometry.boundX.push_back(center.x);
  geometry.boundY.push_back(center.y);
  geometry.boundZ.push_back(center.z);
  geometry.boundRadius.push_back(radius);
  geometry.facets.push_back(facet);
}

void addMesh(Geometry& geometry, const Mesh& mesh, std::uint32_t object, const dvec3& camera) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const MeshTriangle& triangle = mesh.triangles[i];
    Facet facet{};
    facet.smooth = triangle.normals[0] != kNoNormal;
    facet.identity = {object, static_cast<std::uint32_t>(i)};
    for (std::size_t k = 0; k < 3; ++k) {
      facet.corners[k] = mesh.positions[triangle.positions[k]] - camera;
      if (facet.smooth) facet.cornerNormals[k] = mesh.normals[triangle.normals[k]];
    }
    addFacet(geometry, facet);
  }
}

// A sphere around each kBlock facets of the list, and padding for the last block.
void boundBlocks(Geometry& geometry) {
  const std::size_t blocks = (geometry.facets.size() + kBlock - 1) / kBlock;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t begin = block * kBlock;
    const std::size_t end = std::min(begin + kBlock, geometry.facets.size());
    dvec3 center(0.0);
    for (std::size_t i = begin; i < end; ++i) center += geometry.facets[i].corners[0];
    center /= static_cast<double>(end - begin);
    double radius = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      for (const dvec3& corner : geometry.facets[i].corners) {
        radius = std::max(radius, glm::distance(center, corner));
      }
    }
    geometry.blocks.push_back({center, radius, {}});
  }
  for (auto* array : {&geometry.boundX, &geometry.boundY, &geometry.boundZ, &geometry.boundRadius}) {
    array->resize(blocks * kBlock, 0.0);
  }
}

// Negative where the line comes close to the sphere of that radius, d = center - origin. The margins are far
// wider than the rounding errors, and as wide as the errors that make a shadow uncertain.
inline double clearance(double dx, double dy, double dz, double radius, const dvec3& direction) {
  const double cx = dy * direction.z - dz * direction.y;
  const double cy = dz * direction.x - dx * direction.z;
  const double cz = dx * direction.y - dy * direction.x;
  return cx * cx + cy * cy + cz * cz - 1.01 * radius * radius - 1e-9 * (dx * dx + dy * dy + dz * dz);
}

// Calls visit(surface, facet) for each facet whose bounding sphere the line comes close to, until it
// returns false. The first inner loop is free of branches for the compiler to vectorise.
template <typename Visit>
void visitFacets(const Geometry& geometry, const dvec3& origin, const dvec3& direction, Visit visit) {
  const std::size_t first = geometry.planes.size() + geometry.balls.size();
  for (std::size_t begin = 0; begin < geometry.facets.size(); begin += kBlock) {
    const Ball& block = geometry.blocks[begin / kBlock];
    const dvec3 toBlock = block.center - origin;
    if (clearance(toBlock.x, toBlock.y, toBlock.z, block.radius, direction) > 0.0) continue;
    const double* x = geometry.boundX.data() + begin;
    const double* y = geometry.boundY.data() + begin;
    const double* z = geometry.boundZ.data() + begin;
    const double* radius = geometry.boundRadius.data() + begin;
    std::array<double, kBlock> clear;
    for (std::size_t i = 0; i < kBlock; ++i) {
      clear[i] = clearance(x[i] - origin.x, y[i] - origin.y, z[i] - origin.z, radius[i], direction);
    }
    const std::size_t count = std::min(kBlock, geometry.facets.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      if (clear[i] > 0.0) continue;
      if (!visit(static_cast<std::uint32_t>(first + begin + i), geometry.facets[begin + i])) return;
    }
  }
}

// Sums up over surfaces. One certain occluder settles the matter; then it returns false.
bool settle(Occlusion& total, const Occlusion& one) {
  if (one.blocked && one.certain) {
    total = one;
    return false;
  }
  total.blocked = total.blocked || one.blocked;
  total.certain = total.certain && one.certain;
  return true;
}

}  // namespace

Geometry flatten(const Scene& scene) {
  const dvec3 camera = scene.camera.position;
  Geometry geometry;
  for (const Plane& plane : scene.planes) {
    // Scaled first: the square of the longest normal that a scene may state still fits, of the shortest not.
    const dvec3 normal = glm::normalize(plane.normal / magnitude(plane.normal));
    geometry.planes.push_back({plane.point - camera, normal, {plane.object, 0}});
  }
  for (const Sphere& sphere : scene.spheres) {
    geometry.balls.push_back({sphere.center - camera, sphere.radius, {sphere.object, 0}});
  }
  for (const Triangle& triangle : scene.triangles) {
    Facet facet{};
    for (std::size_t k = 0; k < 3; ++k) facet.corners[k] = triangle.vertices[k] - camera;
    facet.identity = {triangle.object, 0};
    addFacet(geometry, facet);
  }
  for (const MeshObject& object : scene.meshObjects) {
    addMesh(geometry, scene.meshes[object.mesh], object.object, camera);
  }
  boundBlocks(geometry);
  return geometry;
}

std::vector<Hit> nearestHits(const Geometry& geometry, const Ray& ray) {
  std::vector<Hit> hits;
  const double originScale = magnitude(ray.origin);
  const auto reach = [&](double distance, double part) { return part * (originScale + distance); };
  double nearest = kMiss;
  const auto consider = [&](double distance, std::uint32_t surface) {
    if (surface == ray.surface || !(distance < kMiss)) return;
    if (distance > nearest + reach(nearest, kFloatError)) return;
    nearest = std::min(nearest, distance);
    hits.push_back({distance, surface});
  };
  std::uint32_t surface = 0;
  for (const FlatPlane& plane : geometry.planes) consider(distanceTo(plane, ray), surface++);
  for (const Ball& ball : geometry.balls) consider(distanceTo(ball, ray), surface++);
  visitFacets(geometry, ray.origin, ray.direction, [&](std::uint32_t number, const Facet& facet) {
    consider(distanceTo(facet, ray), number);
    return true;
  });
  std::erase_if(hits, [&](const Hit& hit) { return hit.distance > nearest + reach(nearest, kFloatError); });
  if (hits.size() < 2) return hits;
  // Of those at the same distance the one that comes first in the scene is seen.
  const auto seen = std::min_element(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    const bool aTied = a.distance <= nearest + reach(nearest, kSameDistance);
    const bool bTied = b.distance <= nearest + reach(nearest, kSameDistance);
    if (aTied != bTied) return aTied;
    return identity(geometry, a.surface) < identity(geometry, b.surface);
  });
  std::iter_swap(hits.begin(), seen);
  return hits;
}

Occlusion occlusion(const Geometry& geometry, const dvec3& point, std::uint32_t surface, const dvec3& light) {
  const Ray ray{point, glm::normalize(light - point), surface};
  Occlusion total;
  std::uint32_t number = 0;
  for (const FlatPlane& plane : geometry.planes) {
    if (number++ != surface && !settle(total, occludes(plane, ray, light))) return total;
  }
  for (const Ball& ball : geometry.balls) {
    if (number++ != surface && !settle(total, occludes(ball, ray, light))) return total;
  }
  visitFacets(geometry, ray.origin, ray.direction, [&](std::uint32_t other, const Facet& facet) {
    return other == surface || settle(total, occludes(facet, ray, light));
  });
  return total;
}

const Identity& identity(const Geometry& geometry, std::uint32_t surface) {
  if (surface < geometry.planes.size()) return geometry.planes[surface].identity;
  surface -= static_cast<std::uint32_t>(geometry.planes.size());
  if (surface < geometry.balls.size()) return geometry.balls[surface].identity;
  return geometry.facets[surface - geometry.balls.size()].identity;
}

Normal shadingNormal(const Geometry& geometry, std::uint32_t surface, const dvec3& point,
                     const dvec3& direction) {
  if (surface < geometry.planes.size()) return shadingNormal(geometry.planes[surface], direction);
  surface -= static_cast<std::uint32_t>(geometry.planes.size());
  if (surface < geometry.balls.size()) return shadingNormal(geometry.balls[surface], point);
  return shadingNormal(geometry.facets[surface - geometry.balls.size()], point, direction);
}

}  // namespace lavaray::oracle
