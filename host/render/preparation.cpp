#include "render/preparation.hpp"

#include <bit>
#include <vector>

#include "render/variant.hpp"

namespace lavaray {
namespace {

// A hierarchy over fewer is built in a few milliseconds.
constexpr std::size_t kPrimitivesWorthPreparing = 10'000;
// An unused entry takes about a hundredth of the time of tracing.
constexpr double kMostRays = 4e6;

// The types of the bindings that Tracer's buffers give the shader.
std::vector<VkDescriptorType> bindingTypes(vulkan::BufferUse sceneUse) {
  const VkDescriptorType ofScene = vulkan::descriptorType(sceneUse);
  std::vector<VkDescriptorType> types(gpu::kBindingCount,
                                      vulkan::descriptorType(vulkan::BufferUse::kStorage));
  for (gpu::uint binding = 0; binding <= gpu::kBindingEntryNodes; ++binding) types[binding] = ofScene;
  return types;
}

}  // namespace

bool isWorthPreparing(const SceneFeatures& scene, const RenderSettings& settings) {
  return scene.primitiveCount >= kPrimitivesWorthPreparing &&
         estimatedRays(scene.lightCount, settings) <= kMostRays;
}

// Wide nodes have up to four children: a balanced hierarchy is log4(n) deep, and those of meshes, which are
// less balanced, are about three deeper.
std::uint32_t expectedStackSize(std::size_t primitives) {
  return static_cast<std::uint32_t>(std::bit_width(primitives)) / 2 + 3;
}

void preparePipeline(vulkan::Device& device, const SceneFeatures& scene, const RenderSettings& settings) {
  const PipelineVariant variant = chooseVariant(device, scene, 0, vulkan::BufferUse::kTexels, settings);
  device.pipelines().prepare({variant.shader, variant.specialization, bindingTypes(variant.sceneUse),
                              sizeof(gpu::DispatchConstants)});
}

}  // namespace lavaray
