#include "bvh/flatten.hpp"

#include <algorithm>
#include <functional>
#include <future>
#include <numeric>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "base/vector_math.hpp"
#include "bvh/frame.hpp"
#include "bvh/primitives.hpp"
#include "bvh/wide_bvh.hpp"

namespace lavaray {
namespace {

// Beyond this many primitives around one centre it is worth looking for duplicates: no tree can separate
// them, and a ray that reaches one has to test them all.
constexpr std::uint32_t kManyCoincident = 64;

// The hierarchy over those primitives whose numbers are given.
Bvh buildOver(const Primitives& primitives, std::span<const std::uint32_t> chosen, unsigned threads) {
  Bvh bvh = buildBvh(
      static_cast<std::uint32_t>(chosen.size()), [&](std::uint32_t i) { return primitives.box(chosen[i]); },
      threads);
  for (std::uint32_t& i : bvh.order) i = chosen[i];
  return bvh;
}

Bvh oneLeafOf(const Primitives& primitives) {
  const std::vector<std::uint32_t> chosen = spheresFirst(primitives);
  std::vector<Box> boxes;
  for (const std::uint32_t i : chosen) boxes.push_back(primitives.box(i));
  Bvh bvh = oneLeaf(boxes);
  for (std::uint32_t& i : bvh.order) i = chosen[i];
  return bvh;
}

// Makes the arrays of spheres and triangles: these primitives, in this order.
void fillPrimitives(const Primitives& primitives, std::span<const std::uint32_t> order, unsigned threads,
                    GpuScene& result) {
  constexpr std::size_t kChunkSize = 4096;
  const std::size_t chunks = (order.size() + kChunkSize - 1) / kChunkSize;
  const auto chunk = [&](std::size_t c) {
    return order.subspan(c * kChunkSize, std::min(kChunkSize, order.size() - c * kChunkSize));
  };
  std::vector<std::uint32_t> cornerNormals(chunks + 1, 0);  // before each chunk, and in all
  if (primitives.hasCornerNormals()) {
    parallelFor(chunks, threads, [&](std::size_t c) {
      const auto smooth =
          std::ranges::count_if(chunk(c), [&](std::uint32_t i) { return primitives.hasCornerNormals(i); });
      cornerNormals[c + 1] = 3 * static_cast<std::uint32_t>(smooth);
    });
    std::partial_sum(cornerNormals.begin(), cornerNormals.end(), cornerNormals.begin());
  }
  result.primitives.resize(order.size());
  if (result.hasTriangles) result.trianglePlanes.resize(order.size());
  result.cornerNormals.resize(cornerNormals.back());
  parallelFor(chunks, threads, [&](std::size_t c) {
    const std::span<gpu::Primitive> shapes =
        std::span(result.primitives).subspan(c * kChunkSize, chunk(c).size());
    const std::span<gpu::TrianglePlane> planes(result.trianglePlanes);
    primitives.make(chunk(c), shapes,
                    planes.empty() ? planes : planes.subspan(c * kChunkSize, shapes.size()));
    std::uint32_t cornerNormal = cornerNormals[c];
    if (cornerNormal == cornerNormals[c + 1]) return;
    for (gpu::Primitive& shape : shapes) {
      if (!primitives.hasCornerNormals(shape.order)) continue;
      shape.kind = cornerNormal;
      std::ranges::copy(primitives.cornerNormals(shape.order), &result.cornerNormals[cornerNormal]);
      cornerNormal += 3;
    }
  });
}

// A function of its own, so that the binary hierarchy is gone before the primitives are made.
WideBvh buildHierarchy(const Primitives& primitives, unsigned threads, GpuScene& result) {
  Bvh bvh = result.hasFewPrimitives
                ? oneLeafOf(primitives)
                : buildBvh(
                      primitives.size(), [&](std::uint32_t i) { return primitives.box(i); }, threads);
  if (bvh.largestCoincidentGroup > kManyCoincident) {
    const std::vector<std::uint32_t> kept = withoutCoincident(primitives);
    result.droppedDuplicates = primitives.size() - kept.size();
    if (result.droppedDuplicates > 0) bvh = buildOver(primitives, kept, threads);
  }
  // Adds up what rounds, so that one thread does it; the others widen meanwhile.
  const bool beside = threads > 1 && !result.hasFewPrimitives;
  std::future<BvhQuality> quality = std::async(
      beside ? std::launch::async | std::launch::deferred : std::launch::deferred, measure, std::cref(bvh));
  WideBvh wide = widen(bvh, threads);
  result.bvhQuality = quality.get();
  return wide;
}

void flattenPrimitives(const Scene& scene, unsigned threads, GpuScene& result) {
  const Primitives primitives(scene);
  if (primitives.size() == 0) return;
  WideBvh wide = buildHierarchy(primitives, threads, result);
  result.nodes = std::move(wide.nodes);
  result.bvhDepth = wide.depth;
  fillPrimitives(primitives, wide.order, threads, result);
}

gpu::Plane flattenPlane(const Plane& plane, const Frame& frame) {
  const glm::dvec3 normal = unitOrZero(plane.normal);
  return {toFloat(normal), frame.planeDistance(normal, plane.point), plane.object, 0, 0, 0};
}

}  // namespace

GpuScene flatten(const Scene& scene, unsigned threads) {
  GpuScene result;
  flattenShading(scene, result);
  flattenPrimitives(scene, threads, result);
  return result;
}

bool sameGeometry(const Scene& a, const Scene& b) {
  return frameOf(a) == frameOf(b) && a.spheres == b.spheres && a.triangles == b.triangles &&
         a.meshObjects == b.meshObjects && a.meshes == b.meshes;
}

void flattenShading(const Scene& scene, GpuScene& flat) {
  const Frame frame = frameOf(scene);
  static_cast<SceneFeatures&>(flat) = featuresOf(scene);
  flat.imagePlane = imagePlane(scene.camera);
  flat.scale = frame.scale;
  flat.planes.clear();
  for (const Plane& plane : scene.planes) flat.planes.push_back(flattenPlane(plane, frame));
  flat.lights.clear();
  for (const Light& light : scene.lights) {
    flat.lights.push_back({frame.position(light.position), frame.length(light.radius), toFloat(light.ambient),
                           0.0F, toFloat(light.diffuse), 0.0F, toFloat(light.specular), 0.0F});
  }
  flat.materials.clear();
  flat.materials.reserve(scene.materials.size());
  for (const Material& material : scene.materials) {
    flat.materials.push_back({toFloat(material.ambient), toFloat(material.shininess),
                              toFloat(material.diffuse), 0.0F, toFloat(material.specular), 0.0F,
                              toFloat(material.reflectance), 0.0F});
  }
}

}  // namespace lavaray
