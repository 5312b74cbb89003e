#include "render/scene_buffers.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace lavaray {
namespace {

template <typename Elements>
std::span<const std::byte> bytesOf(const Elements& elements) {
  return std::as_bytes(std::span(elements));
}

}  // namespace

vulkan::BufferUse sceneUse(const vulkan::Device& device, const GpuScene& scene) {
  std::size_t max = 0;
  const auto look = [&](const auto& elements) { max = std::max(max, bytesOf(elements).size()); };
  look(scene.nodes);
  look(scene.primitives);
  look(scene.trianglePlanes);
  look(scene.cornerNormals);
  look(scene.planes);
  look(scene.lights);
  look(scene.materials);
  const std::uint64_t reach = std::uint64_t{device.limits().texelBufferElements} * vulkan::kTexelBytes;
  return max <= reach ? vulkan::BufferUse::kTexels : vulkan::BufferUse::kStorage;
}

std::vector<vulkan::Buffer> uploadScene(vulkan::Device& device, const GpuScene& scene,
                                        vulkan::BufferUse use) {
  std::vector<vulkan::Buffer> buffers;
  const auto upload = [&]([[maybe_unused]] gpu::uint binding, const char* name,
                          std::span<const std::byte> content) {
    assert(binding == buffers.size());
    // Vulkan has no empty buffers; the pipeline of a scene without these things never reads this one.
    static constexpr std::array<std::byte, 64> kNothing{};
    buffers.push_back(vulkan::Buffer::uploaded(device, name, use, content.empty() ? kNothing : content));
  };
  upload(gpu::kBindingNodes, "BVH nodes", bytesOf(scene.nodes));
  upload(gpu::kBindingPrimitives, "spheres and triangles", bytesOf(scene.primitives));
  upload(gpu::kBindingTrianglePlanes, "triangle planes", bytesOf(scene.trianglePlanes));
  upload(gpu::kBindingCornerNormals, "corner normals", bytesOf(scene.cornerNormals));
  upload(gpu::kBindingPlanes, "planes", bytesOf(scene.planes));
  upload(gpu::kBindingLights, "lights", bytesOf(scene.lights));
  upload(gpu::kBindingMaterials, "materials", bytesOf(scene.materials));
  return buffers;
}

}  // namespace lavaray
