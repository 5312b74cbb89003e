#include "lavaray/run_report.hpp"

#include <sys/resource.h>

namespace lavaray {
namespace {

HierarchyReport reportHierarchy(const GpuScene& scene) {
  return {.primitives = scene.primitives.size(),
          .droppedDuplicates = scene.droppedDuplicates,
          .built = scene.bvhQuality,
          .isTraversed = !scene.hasFewPrimitives,
          .traversedNodes = scene.hasFewPrimitives ? 0 : scene.nodes.size(),
          .traversedDepth = scene.bvhDepth};
}

RayRates reportRayRates(const RenderStatistics& render) {
  const double seconds = render.activity.seconds;
  const auto rate = [&](std::uint64_t rays) {
    return seconds > 0.0 ? static_cast<double>(rays) / seconds : 0.0;
  };
  return {.camera = rate(render.counts.samples),
          .mirror = rate(render.counts.mirrorRays),
          .shadow = rate(render.counts.shadowRays)};
}

std::size_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t{1024} * static_cast<std::size_t>(usage.ru_maxrss);
}

}  // namespace

SceneReport reportScene(const Scene& scene) {
  SceneReport report{.file = scene.file.string(),
                     .image = imageSize(scene.camera).value(),
                     .planes = scene.planes.size(),
                     .spheres = scene.spheres.size(),
                     .triangles = scene.triangles.size(),
                     .meshes = scene.meshObjects.size(),
                     .meshTriangles = 0,
                     .lights = scene.lights.size(),
                     .meshFiles = {}};
  for (const MeshObject& object : scene.meshObjects) {
    report.meshTriangles += scene.meshes[object.mesh].triangles.size();
  }
  for (const Mesh& mesh : scene.meshes) {
    report.meshFiles.push_back({.file = mesh.file.string(),
                                .triangles = mesh.triangles.size(),
                                .vertices = mesh.positions.size(),
                                .normals = mesh.normals.size(),
                                .degenerateTriangles = mesh.degenerateTriangles});
  }
  return report;
}

RunReport reportRun(const Scene& scene, const GpuScene& gpuScene, const ImageSize& picture,
                    const vulkan::DeviceDescription& device, const RenderStatistics& render,
                    const StepTimes& times) {
  return {.scene = reportScene(scene),
          .picture = picture,
          .hierarchy = reportHierarchy(gpuScene),
          .render = render,
          .rayRates = reportRayRates(render),
          .device = device,
          .peakMemoryBytes = peakMemoryBytes(),
          .times = times};
}

}  // namespace lavaray
