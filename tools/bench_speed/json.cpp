#include <ostream>

#include <nlohmann/json.hpp>

#include "report.hpp"

namespace lavaray::bench {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<std::size_t>& value) {
  return value ? Json(*value) : Json();
}

template <typename Element, typename ToJson>
Json list(const std::vector<Element>& elements, const ToJson& toJson) {
  Json result = Json::array();
  for (const Element& element : elements) result.push_back(toJson(element));
  return result;
}

Json timingsJson(const std::vector<Timing>& timings) {
  return list(timings, [](const Timing& timing) -> Json {
    return {{"name", timing.name}, {"cpu", timing.cpu}, {"wall", timing.wall}};
  });
}

Json batchJson(const BatchResult& batch) {
  return {{"name", batch.name},
          {"rays_per_lane", batch.raysPerLane},
          {"rays", batch.rays},
          {"hits", batch.hits},
          {"unfinished", batch.unfinished},
          {"disagreements", orNull(batch.disagreements)},
          {"timings", timingsJson(batch.timings)}};
}

Json pictureJson(const PictureResult& picture) {
  return {{"rays", picture.rays},
          {"differing_pixels", orNull(picture.differingPixels)},
          {"timings", timingsJson(picture.timings)}};
}

Json sceneJson(const SceneResult& scene) {
  return {{"name", scene.name},
          {"what", scene.what},
          {"spheres", scene.isSpheres},
          {"primitives", scene.primitives},
          {"bytes", scene.bytes},
          {"peer_bytes", orNull(scene.peerBytes)},
          {"batches", list(scene.batches, batchJson)},
          {"picture", pictureJson(scene.picture)},
          {"builds", timingsJson(scene.builds)}};
}

}  // namespace

void writeJson(std::ostream& out, const Results& results) {
  const Json json = {{"device", results.device},
                     {"peer", results.peer},
                     {"threads", results.threads},
                     {"size", Json::array({results.size.width, results.size.height})},
                     {"rays_per_lane", results.raysPerLane},
                     {"rounds", results.rounds},
                     {"skipped", results.skipped},
                     {"scenes", list(results.scenes, sceneJson)}};
  // A folder's name need not be UTF-8, which JSON must be.
  out << json.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace lavaray::bench
