#include "lavaray/json_report.hpp"

#include <string>

#include <nlohmann/json.hpp>

#include "command_line/version.hpp"
#include "library/tuning_file.hpp"

namespace lavaray {
namespace {

using Json = nlohmann::ordered_json;

// To be raised with every entry that is removed or renamed, or changes its meaning.
constexpr int kSchema = 2;

Json sceneJson(const SceneReport& scene) {
  Json files = Json::array();
  for (const MeshFileReport& mesh : scene.meshFiles) {
    files.push_back({{"file", mesh.file},
                     {"triangles", mesh.triangles},
                     {"vertices", mesh.vertices},
                     {"normals", mesh.normals},
                     {"degenerateTriangles", mesh.degenerateTriangles}});
  }
  return {{"file", scene.file},           {"width", scene.image.width},
          {"height", scene.image.height}, {"planes", scene.planes},
          {"spheres", scene.spheres},     {"triangles", scene.triangles},
          {"meshes", scene.meshes},       {"meshTriangles", scene.meshTriangles},
          {"lights", scene.lights},       {"meshFiles", files}};
}

Json bvhJson(const HierarchyReport& hierarchy) {
  const BvhQuality& built = hierarchy.built;
  return {{"primitives", hierarchy.primitives},
          {"droppedDuplicates", hierarchy.droppedDuplicates},
          {"innerNodes", built.innerNodes},
          {"leaves", built.leaves},
          {"primitivesPerLeaf", built.leafSize},
          {"depth", built.depth},
          {"mostDepth", gpu::kMaxBvhDepth},
          {"traversedNodes", hierarchy.traversedNodes},
          {"traversedDepth", hierarchy.traversedDepth},
          {"sahCost", built.sahCost}};
}

Json shareOrNull(double share) {
  return share > 0.0 ? Json(share) : Json();
}

Json raysJson(const TraceCounts& counts, const RayRates& rates) {
  return {
      {"camera", counts.samples},
      {"mirror", counts.mirrorRays},
      {"shadow", counts.shadowRays},
      {"skippedCamera", counts.skippedSamples},
      {"skippedShadow", counts.skippedShadowRays},
      {"perSecond",
       {{"camera", rates.camera}, {"mirror", rates.mirror}, {"shadow", rates.shadow}, {"all", rates.all()}}},
      {"lanesInUse",
       {{"nearestHits", shareOrNull(counts.nearestHitLanesInUse())},
        {"shadows", shareOrNull(counts.shadowLanesInUse())}}}};
}

Json samplingJson(const RenderStatistics& render) {
  return {{"stopped", stopReasonName(render.stopReason)},
          {"samplesPerPixel", render.samplesPerPixel},
          {"mostSamplesPerPixel", render.maxSamples},
          {"skippedPixels", render.skippedPixels},
          {"estimatedRmse", render.estimatedError > 0.0 ? Json(render.estimatedError) : Json()}};
}

Json activityJson(const vulkan::Activity& activity) {
  Json spans = Json::array();
  for (const vulkan::SubmissionSpan& span : activity.first)
    spans.push_back({span.submitted, span.begin, span.end, span.waitBegin, span.waitEnd});
  return {{"clock", activity.byDeviceClock ? "device" : "host"},
          {"seconds", activity.seconds},
          {"deviceIdleSeconds", activity.deviceIdleSeconds},
          {"hostWaitSeconds", activity.hostWaitSeconds},
          {"firstDispatches", spans}};
}

Json deviceJson(const vulkan::DeviceDescription& device, const RenderStatistics& render) {
  return {{"name", device.name},
          {"kind", device.kind},
          {"driver", device.driver},
          {"sceneReadAs", sceneReadAs(render.tuning.sceneInStorage)},
          {"raysPerInvocation", render.tuning.raysPerLane},
          {"bufferBytes", render.deviceBytes},
          {"dispatches", render.counts.dispatches},
          {"activity", activityJson(render.activity)}};
}

Json timesJson(const StepTimes& times) {
  Json steps = Json::array();
  for (const auto& [step, duration] : times.steps()) {
    steps.push_back({{"step", step}, {"seconds", std::chrono::duration<double>(duration).count()}});
  }
  return steps;
}

// What is known without rendering.
Json inputJson(const SceneReport& scene, const ImageSize& picture) {
  return {{"schema", kSchema},
          {"lavaray", kVersion},
          {"scene", sceneJson(scene)},
          {"picture", {{"width", picture.width}, {"height", picture.height}}}};
}

void write(std::FILE* stream, const Json& report) {
  // A file's name need not be UTF-8, which JSON must be.
  const std::string text = report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  std::fwrite(text.data(), 1, text.size(), stream);
}

}  // namespace

void writeJsonCheck(std::FILE* stream, const SceneReport& scene, const ImageSize& picture) {
  write(stream, inputJson(scene, picture));
}

void writeJsonReport(std::FILE* stream, const RunReport& report) {
  Json json = inputJson(report.scene, report.picture);
  json["bvh"] = bvhJson(report.hierarchy);
  json["rays"] = raysJson(report.render.counts, report.rayRates);
  json["sampling"] = samplingJson(report.render);
  json["device"] = deviceJson(report.device, report.render);
  json["memory"] = {{"peakBytes", report.peakMemoryBytes}};
  json["steps"] = timesJson(report.times);
  json["seconds"] = report.times.seconds();
  write(stream, json);
}

}  // namespace lavaray
