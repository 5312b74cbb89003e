#include "lavaray/json_report.hpp"

#include <string>

#include <nlohmann/json.hpp>

#include "command_line/version.hpp"

namespace lavaray {
namespace {

using Json = nlohmann::ordered_json;

// To be raised with every entry that is removed or renamed, or changes its meaning.
constexpr int kSchema = 2;

Json sceneJson(const SceneSummary& scene) {
  Json files = Json::array();
  for (const MeshSummary& mesh : scene.meshFiles) {
    files.push_back({{"file", mesh.file.string()},
                     {"triangles", mesh.triangles},
                     {"vertices", mesh.vertices},
                     {"normals", mesh.normals},
                     {"degenerateTriangles", mesh.degenerateTriangles}});
  }
  return {{"file", scene.file.string()},  {"width", scene.image.width},
          {"height", scene.image.height}, {"planes", scene.planes},
          {"spheres", scene.spheres},     {"triangles", scene.triangles},
          {"meshes", scene.meshes},       {"meshTriangles", scene.meshTriangles},
          {"lights", scene.lights},       {"meshFiles", files}};
}

Json bvhJson(const HierarchyStatistics& hierarchy) {
  return {{"primitives", hierarchy.primitives},
          {"droppedDuplicates", hierarchy.droppedDuplicates},
          {"innerNodes", hierarchy.innerNodes},
          {"leaves", hierarchy.leaves},
          {"primitivesPerLeaf", hierarchy.primitivesPerLeaf},
          {"depth", hierarchy.depth},
          {"mostDepth", hierarchy.maxDepth},
          {"traversedNodes", hierarchy.traversedNodes},
          {"traversedDepth", hierarchy.traversedDepth},
          {"sahCost", hierarchy.sahCost}};
}

Json shareOrNull(double share) {
  return share > 0.0 ? Json(share) : Json();
}

Json raysJson(const RayCounts& rays, const RayRates& rates) {
  return {
      {"camera", rays.camera},
      {"mirror", rays.mirror},
      {"shadow", rays.shadow},
      {"skippedCamera", rays.skippedCamera},
      {"skippedShadow", rays.skippedShadow},
      {"perSecond",
       {{"camera", rates.camera}, {"mirror", rates.mirror}, {"shadow", rates.shadow}, {"all", rates.all()}}},
      {"lanesInUse",
       {{"nearestHits", shareOrNull(rays.nearestHitLanesInUse)},
        {"shadows", shareOrNull(rays.shadowLanesInUse)}}}};
}

Json samplingJson(const Statistics& render) {
  return {{"stopped", name(render.stopReason)},
          {"samplesPerPixel", render.samplesPerPixel},
          {"mostSamplesPerPixel", render.maxSamples},
          {"skippedPixels", render.skippedPixels},
          {"estimatedRmse", render.estimatedError > 0.0 ? Json(render.estimatedError) : Json()}};
}

Json activityJson(const DeviceActivity& activity) {
  Json spans = Json::array();
  for (const DispatchTimes& times : activity.first)
    spans.push_back({times.submitted, times.begin, times.end, times.waitBegin, times.waitEnd});
  return {{"clock", activity.byDeviceClock ? "device" : "host"},
          {"seconds", activity.seconds},
          {"deviceIdleSeconds", activity.deviceIdleSeconds},
          {"hostWaitSeconds", activity.hostWaitSeconds},
          {"firstDispatches", spans}};
}

Json deviceJson(const DeviceInfo& device, const Statistics& render) {
  return {{"name", device.name},
          {"kind", device.kind},
          {"driver", device.driver},
          {"sceneReadAs", render.sceneReadAs},
          {"raysPerInvocation", render.raysPerInvocation},
          {"bufferBytes", render.deviceBytes},
          {"dispatches", render.dispatches},
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
Json inputJson(const SceneSummary& scene, const ImageSize& picture) {
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

void writeJsonCheck(std::FILE* stream, const SceneSummary& scene, const ImageSize& picture) {
  write(stream, inputJson(scene, picture));
}

void writeJsonReport(std::FILE* stream, const RunReport& report) {
  Json json = inputJson(report.scene, report.picture);
  json["bvh"] = bvhJson(report.render.hierarchy);
  json["rays"] = raysJson(report.render.rays, ratesOf(report.render));
  json["sampling"] = samplingJson(report.render);
  json["device"] = deviceJson(report.device, report.render);
  json["memory"] = {{"peakBytes", report.peakMemoryBytes}};
  json["steps"] = timesJson(report.times);
  json["seconds"] = report.times.seconds();
  write(stream, json);
}

}  // namespace lavaray
