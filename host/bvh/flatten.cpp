#include "bvh/flatten.hpp"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

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

std::vector<Box> boundingBoxes(const Primitives& primitives, unsigned threads) {
  constexpr std::size_t kChunkSize = 16384;
  std::vector<Box> boxes(primitives.shapes.size());
  parallelFor((boxes.size() + kChunkSize - 1) / kChunkSize, threads, [&](std::size_t chunk) {
    const std::size_t end = std::min(boxes.size(), (chunk + 1) * kChunkSize);
    for (std::size_t i = chunk * kChunkSize; i < end; ++i) boxes[i] = boundingBox(primitives.shapes[i]);
  });
  return boxes;
}

void flattenPrimitives(const Scene& scene, unsigned threads, GpuScene& result) {
  Primitives primitives = collectPrimitives(scene);
  result.hasFewPrimitives = hasFewPrimitives(scene);
  if (primitives.shapes.empty()) return;
  if (result.hasFewPrimitives) putSpheresFirst(primitives);
  Bvh bvh = result.hasFewPrimitives ? oneLeaf(boundingBoxes(primitives, threads))
                                    : buildBvh(boundingBoxes(primitives, threads), threads);
  if (bvh.largestCoincidentGroup > kManyCoincident) {
    result.droppedDuplicates = removeCoincident(primitives);
    if (result.droppedDuplicates > 0) bvh = buildBvh(boundingBoxes(primitives, threads), threads);
  }
  result.bvhQuality = measure(bvh);
  WideBvh wide = widen(bvh);
  result.nodes = std::move(wide.nodes);
  result.bvhDepth = wide.depth;
  result.primitives.reserve(wide.order.size());
  for (const std::uint32_t i : wide.order) result.primitives.push_back(primitives.shapes[i]);
  result.trianglePlanes.reserve(primitives.planes.size());
  if (!primitives.planes.empty()) {
    for (const std::uint32_t i : wide.order) result.trianglePlanes.push_back(primitives.planes[i]);
  }
  result.cornerNormals = std::move(primitives.cornerNormals);
  result.hasSpheres = !scene.spheres.empty();
  result.hasTriangles = !result.trianglePlanes.empty();
  result.hasCornerNormals = !result.cornerNormals.empty();
}

gpu::Plane flattenPlane(const Plane& plane, const Frame& frame) {
  const glm::dvec3 normal = unitOrZero(plane.normal);
  return {toFloat(normal), frame.planeDistance(normal, plane.point), plane.object, 0, 0, 0};
}

}  // namespace

bool hasFewPrimitives(const Scene& scene) {
  return primitiveCount(scene) <= gpu::kMaxFewPrimitives;
}

GpuScene flatten(const Scene& scene, unsigned threads) {
  GpuScene result;
  flattenPrimitives(scene, threads, result);
  flattenShading(scene, result);
  return result;
}

bool sameGeometry(const Scene& a, const Scene& b) {
  return frameOf(a) == frameOf(b) && a.spheres == b.spheres && a.triangles == b.triangles &&
         a.meshObjects == b.meshObjects && a.meshes == b.meshes;
}

void flattenShading(const Scene& scene, GpuScene& flat) {
  const Frame frame = frameOf(scene);
  flat.imagePlane = imagePlane(scene.camera);
  flat.scale = frame.scale;
  flat.planes.clear();
  for (const Plane& plane : scene.planes) flat.planes.push_back(flattenPlane(plane, frame));
  flat.lights.clear();
  flat.hasSphericalLights = false;
  for (const Light& light : scene.lights) {
    flat.lights.push_back({frame.position(light.position), frame.length(light.radius), toFloat(light.ambient),
                           0.0F, toFloat(light.diffuse), 0.0F, toFloat(light.specular), 0.0F});
    flat.hasSphericalLights = flat.hasSphericalLights || light.radius > 0.0;
  }
  flat.materials.clear();
  flat.materials.reserve(scene.materials.size());
  flat.hasMirrors = false;
  for (const Material& material : scene.materials) {
    flat.materials.push_back({toFloat(material.ambient), toFloat(material.shininess),
                              toFloat(material.diffuse), 0.0F, toFloat(material.specular), 0.0F,
                              toFloat(material.reflectance), 0.0F});
    flat.hasMirrors = flat.hasMirrors || glm::any(glm::greaterThanEqual(flat.materials.back().reflectance,
                                                                        glm::vec3(gpu::kMinReflectance)));
  }
}

}  // namespace lavaray
