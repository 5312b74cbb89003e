#include "core/flatten.hpp"

#include <cassert>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/parallel.hpp"
#include "core/primitives.hpp"
#include "core/vector.hpp"

namespace lavaray {
namespace {

// More primitives about one centre than this, and it is worth looking for duplicates among them: no tree can
// tell those apart, and a ray that reaches one has to test them all.
constexpr std::uint32_t kManyCoincident = 64;

std::vector<Box> boundingBoxes(const Primitives& primitives, unsigned threads) {
  constexpr std::size_t kChunkSize = 16384;
  std::vector<Box> boxes(primitives.shapes.size());
  parallelFor((boxes.size() + kChunkSize - 1) / kChunkSize, threads, [&](std::size_t chunk) {
    const std::size_t end = std::min(boxes.size(), (chunk + 1) * kChunkSize);
    for (std::size_t i = chunk * kChunkSize; i < end; ++i) boxes[i] = boundingBox(primitives.shapes[i]);
  });
  return boxes;
}

// Turns the tree as built into the tree as traversed: inner nodes only, without gaps, depth first, each with
// the boxes of its children; and primitives in the order of the leaves.
class BvhFlattener {
 public:
  BvhFlattener(const Bvh& bvh, const Primitives& primitives, GpuScene& scene)
      : bvh_(bvh), primitives_(primitives), scene_(scene) {}

  void run() {
    scene_.primitives.reserve(bvh_.order.size());
    scene_.rootReference = flattenNode(0, 0);
  }

 private:
  // Returns the node reference that stands for the subtree.
  gpu::uint flattenNode(std::uint32_t index, std::uint32_t depth) {
    const BvhNode& node = bvh_.nodes[index];
    if (node.count > 0) return flattenLeaf(node);
    assert(depth < gpu::kMaxBvhDepth);
    const auto reference = static_cast<gpu::uint>(scene_.nodes.size());
    const Box& left = bvh_.nodes[node.left].box;
    const Box& right = bvh_.nodes[node.right].box;
    scene_.nodes.push_back({left.lower, 0, left.upper, 0, right.lower, 0, right.upper, 0});
    const gpu::uint child0 = flattenNode(node.left, depth + 1);
    const gpu::uint child1 = flattenNode(node.right, depth + 1);
    scene_.nodes[reference].child0 = child0;
    scene_.nodes[reference].child1 = child1;
    return reference;
  }

  gpu::uint flattenLeaf(const BvhNode& leaf) {
    assert(leaf.count <= gpu::kMaxLeafSize);
    const auto first = static_cast<gpu::uint>(scene_.primitives.size());
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t primitive = bvh_.order[i];
      scene_.primitives.push_back(primitives_.shapes[primitive]);
      if (!primitives_.planes.empty()) scene_.trianglePlanes.push_back(primitives_.planes[primitive]);
    }
    return leaf.count << gpu::kLeafShift | first;
  }

  const Bvh& bvh_;
  const Primitives& primitives_;
  GpuScene& scene_;
};

void flattenPrimitives(const Scene& scene, unsigned threads, GpuScene& result) {
  Primitives primitives = collectPrimitives(scene);
  if (primitives.shapes.empty()) return;
  Bvh bvh = buildBvh(boundingBoxes(primitives, threads), threads);
  if (bvh.largestCoincidentGroup > kManyCoincident) {
    result.droppedDuplicates = removeCoincident(primitives);
    if (result.droppedDuplicates > 0) bvh = buildBvh(boundingBoxes(primitives, threads), threads);
  }
  result.bvhQuality = measure(bvh);
  BvhFlattener(bvh, primitives, result).run();
  result.cornerNormals = std::move(primitives.cornerNormals);
  result.hasSpheres = !scene.spheres.empty();
  result.hasTriangles = !result.trianglePlanes.empty();
  result.hasCornerNormals = !result.cornerNormals.empty();
}

gpu::Plane flattenPlane(const Plane& plane, const glm::dvec3& origin) {
  const glm::dvec3 normal = unitOrZero(plane.normal);
  const double distance = glm::dot(normal, plane.point - origin);
  return {normal, static_cast<float>(distance), plane.object, 0, 0, 0};
}

}  // namespace

GpuScene flatten(const Scene& scene, unsigned threads) {
  GpuScene result;
  flattenPrimitives(scene, threads, result);
  const glm::dvec3 origin = scene.camera.position;
  for (const Plane& plane : scene.planes) result.planes.push_back(flattenPlane(plane, origin));
  for (const Light& light : scene.lights) {
    result.lights.push_back({light.position - origin, static_cast<float>(light.radius), light.ambient, 0.0F,
                             light.diffuse, 0.0F, light.specular, 0.0F});
    result.hasSphericalLights = result.hasSphericalLights || light.radius > 0.0;
  }
  for (const Material& material : scene.materials) {
    result.materials.push_back({material.ambient, static_cast<float>(material.shininess), material.diffuse,
                                0.0F, material.specular, 0.0F, material.reflectance, 0.0F});
    result.hasMirrors =
        result.hasMirrors ||
        glm::any(glm::greaterThanEqual(result.materials.back().reflectance, glm::vec3(gpu::kMinReflectance)));
  }
  return result;
}

}  // namespace lavaray
