#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/box.hpp"
#include "bvh/frame.hpp"
#include "interface.h"
#include "scene/scene.hpp"

namespace lavaray {

// What the BVH holds: all spheres and triangles of a scene, in its Frame, numbered in file order. Each is
// made of the scene whenever it is asked for, so that nothing need hold them all twice: the builder asks for
// their boxes, then flatten() for the rest in the order of the leaves.
class Primitives {
 public:
  // The scene must outlive this. Throws Error(kInput) if it has more than gpu::kMaxReference primitives.
  explicit Primitives(const Scene& scene);

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool hasCornerNormals() const;  // any of them

  [[nodiscard]] gpu::Primitive shape(
      std::uint32_t index) const;  // a triangle: as if it had no corner normals
  [[nodiscard]] Box box(std::uint32_t index) const;
  // As many shapes as indices; as many planes, zeros for a sphere, or none.
  void make(std::span<const std::uint32_t> indices, std::span<gpu::Primitive> shapes,
            std::span<gpu::TrianglePlane> planes) const;
  [[nodiscard]] bool hasCornerNormals(std::uint32_t index) const;
  [[nodiscard]] std::array<gpu::CornerNormal, 3> cornerNormals(std::uint32_t index) const;

 private:
  enum class Source { kSpheres, kTriangles, kMesh };
  // Primitives from number `first` on, which follow one another in their array of the scene.
  struct Run {
    std::uint32_t first;
    Source source;
    std::size_t begin;     // of the first one in Scene::spheres or Scene::triangles; 0 in a mesh
    const Mesh* mesh;      // null if they are in none
    std::uint32_t object;  // the mesh's
  };

  void addRun(Source source, std::size_t begin, std::size_t count, const MeshObject* mesh);
  [[nodiscard]] const Run& runOf(std::uint32_t index) const;
  [[nodiscard]] std::array<glm::dvec3, 3> vertices(const Run& run, std::uint32_t index) const;
  [[nodiscard]] gpu::Primitive sphere(const Run& run, std::uint32_t index) const;
  [[nodiscard]] gpu::Primitive triangle(const Run& run, std::uint32_t index,
                                        const std::array<glm::dvec3, 3>& v) const;

  const Scene& scene_;
  Frame frame_;
  std::uint32_t size_ = 0;
  std::vector<Run> runs_;
};

std::size_t primitiveCount(const Scene& scene);

// The smallest box with float32 coordinates that contains the shape.
Box boundingBox(const gpu::Primitive& shape);

// The numbers of all primitives, spheres before triangles; within each kind the order stays.
std::vector<std::uint32_t> spheresFirst(const Primitives& primitives);

// The numbers of the primitives without those that coincide with an earlier one and affect no pixel: of
// several triangles with the same vertices only the first is ever seen, and none of them occludes another. Of
// equal spheres the first two stay, because the second occludes the far side of the first.
std::vector<std::uint32_t> withoutCoincident(const Primitives& primitives);

}  // namespace lavaray
