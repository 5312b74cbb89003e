#include "lavaray/json_report.hpp"

#include <string>

#include <nlohmann/json.hpp>

#include "command_line/version.hpp"
#include "scene/camera.hpp"

namespace lavaray {
namespace {

using Json = nlohmann::ordered_json;

// Raised by whoever removes or renames an entry, or changes its meaning.
constexpr int kSchema = 2;

Json sceneJson(const Scene& scene) {
  Json files = Json::array();
  for (const Mesh& mesh : scene.meshes) {
    files.push_back({{"file", mesh.file.string()},
                     {"triangles", mesh.triangles.size()},
                     {"vertices", mesh.positions.size()},
                     {"normals", mesh.normals.size()},
                     {"degenerateTriangles", mesh.degenerateTriangles}});
  }
  const ImageSize size = imageSize(scene.camera).value();
  return {{"file", scene.file.string()},
          {"width", size.width},
          {"height", size.height},
          {"planes", scene.planes.size()},
          {"spheres", scene.spheres.size()},
          {"triangles", scene.triangles.size()},
          {"meshes", scene.meshObjects.size()},
          {"meshTriangles", meshTriangles(scene)},
          {"lights", scene.lights.size()},
          {"meshFiles", files}};
}

Json bvhJson(const GpuScene& scene) {
  const BvhQuality& bvh = scene.bvhQuality;
  return {{"primitives", scene.primitives.size()},
          {"droppedDuplicates", scene.droppedDuplicates},
          {"innerNodes", bvh.innerNodes},
          {"leaves", bvh.leaves},
          {"primitivesPerLeaf", bvh.leafSize},
          {"depth", bvh.depth},
          {"mostDepth", gpu::kMaxBvhDepth},
          {"traversedNodes", scene.hasFewPrimitives ? 0 : scene.nodes.size()},
          {"traversedDepth", scene.bvhDepth},
          {"sahCost", bvh.sahCost}};
}

Json samplingJson(const RenderStatistics& result) {
  return {{"stopped", stopReasonName(result.stopReason)},
          {"samplesPerPixel", result.samplesPerPixel},
          {"mostSamplesPerPixel", result.mostSamples},
          {"skippedPixels", result.skippedPixels},
          {"estimatedRmse", result.estimatedError > 0.0 ? Json(result.estimatedError) : Json()}};
}

Json deviceJson(const vulkan::Device& device, const RenderStatistics& result) {
  const vulkan::DeviceDescription& description = device.description();
  return {{"name", description.name},
          {"kind", description.kind},
          {"driver", description.driver},
          {"bufferBytes", result.deviceBytes},
          {"dispatches", result.counts.dispatches}};
}

Json timesJson(const StepTimes& times) {
  Json steps = Json::array();
  for (const auto& [step, seconds] : times.steps()) {
    steps.push_back({{"step", step}, {"seconds", std::chrono::duration<double>(seconds).count()}});
  }
  return steps;
}

// What is known without rendering.
Json inputJson(const Scene& scene, const ImageSize& size) {
  return {{"schema", kSchema},
          {"lavaray", kVersion},
          {"scene", sceneJson(scene)},
          {"picture", {{"width", size.width}, {"height", size.height}}}};
}

void write(std::FILE* stream, const Json& report) {
  // A file's name need not be UTF-8, which JSON must be.
  const std::string text = report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  std::fwrite(text.data(), 1, text.size(), stream);
}

}  // namespace

void writeJsonCheck(std::FILE* stream, const Scene& scene, const ImageSize& size) {
  write(stream, inputJson(scene, size));
}

void writeJsonStatistics(std::FILE* stream, const Scene& scene, const ImageSize& size,
                         const GpuScene& gpuScene, const vulkan::Device& device,
                         const RenderStatistics& result, const StepTimes& times) {
  Json report = inputJson(scene, size);
  report["bvh"] = bvhJson(gpuScene);
  report["rays"] = {{"camera", result.counts.samples},
                    {"mirror", result.counts.mirrorRays},
                    {"shadow", result.counts.shadowRays},
                    {"skippedCamera", result.counts.skippedSamples},
                    {"skippedShadow", result.counts.skippedShadowRays}};
  report["sampling"] = samplingJson(result);
  report["device"] = deviceJson(device, result);
  report["memory"] = {{"peakBytes", peakMemoryBytes()}};
  report["steps"] = timesJson(times);
  report["seconds"] = times.seconds();
  write(stream, report);
}

}  // namespace lavaray
