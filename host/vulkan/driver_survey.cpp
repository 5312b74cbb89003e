#include "vulkan/driver_survey.hpp"

#include <algorithm>

#include "vulkan/driver_filter.hpp"
#include "vulkan/driver_search.hpp"
#include "vulkan/loader.hpp"
#include "vulkan/manifest_file.hpp"

namespace lavaray::vulkan {
namespace {

// From this version on, the loader's JSON reader accepts a byte-order mark.
constexpr std::uint32_t kAcceptsMarkFrom = VK_MAKE_API_VERSION(0, 1, 4, 303);

bool loaderAcceptsMark() {
  loadGlobalFunctions();
  const auto version = reinterpret_cast<PFN_vkEnumerateInstanceVersion>(
      vkGetInstanceProcAddr(VK_NULL_HANDLE, "vkEnumerateInstanceVersion"));
  std::uint32_t number = 0;
  return version != nullptr && version(&number) == VK_SUCCESS && number >= kAcceptsMarkFrom;
}

SurveyedDriver surveyDriver(const ManifestCandidate& candidate, bool acceptsMark) {
  if (!candidate.problem.empty())
    return {candidate.file, DriverState::kFaulty, candidate.naming + candidate.problem};
  const ManifestContents contents = readDriverManifest(candidate.file, acceptsMark);
  if (!contents.problem.empty())
    return {candidate.file, DriverState::kFaulty, candidate.naming + contents.problem};
  const std::string unused = whyFilteredOut(candidate.file);
  if (!unused.empty()) return {candidate.file, DriverState::kUnused, candidate.naming + unused};
  const DriverAnswer answer = probeDriver(contents.library);
  return {candidate.file, answer.state, candidate.naming + answer.text};
}

std::vector<SurveyedLayer> surveyLayers(const std::vector<ManifestCandidate>& candidates, bool acceptsMark) {
  std::vector<SurveyedLayer> layers;
  for (const ManifestCandidate& candidate : candidates) {
    if (!candidate.problem.empty()) continue;  // which troubles no loader
    const ManifestContents contents = readLayerManifest(candidate.file, acceptsMark);
    layers.push_back({candidate.file, contents.isUnparsable, candidate.naming + contents.problem});
  }
  return layers;
}

bool isBroken(const SurveyedLayer& layer) {
  return layer.isBroken;
}

}  // namespace

std::vector<std::string> DriverSurvey::lines(bool all) const {
  std::vector<std::string> lines;
  for (const SurveyedDriver& driver : drivers) {
    if (all || driver.state == DriverState::kFaulty) lines.push_back(driver.text);
  }
  for (const auto* layers : {&implicitLayers, &explicitLayers}) {
    for (const SurveyedLayer& layer : *layers) {
      if (layer.isBroken) lines.push_back(layer.text);
    }
  }
  return lines;
}

bool DriverSurvey::canDoWithout() const {
  const auto has = [&](DriverState state) {
    return std::any_of(drivers.begin(), drivers.end(),
                       [&](const SurveyedDriver& driver) { return driver.state == state; });
  };
  return has(DriverState::kWorks) &&
         (has(DriverState::kFaulty) || std::any_of(implicitLayers.begin(), implicitLayers.end(), isBroken) ||
          std::any_of(explicitLayers.begin(), explicitLayers.end(), isBroken));
}

DriverSurvey surveyDrivers() {
  const bool acceptsMark = loaderAcceptsMark();
  DriverSurvey survey;
  for (const ManifestCandidate& candidate : findDriverManifests()) {
    survey.drivers.push_back(surveyDriver(candidate, acceptsMark));
  }
  survey.implicitLayers = surveyLayers(findImplicitLayerManifests(), acceptsMark);
  survey.explicitLayers = surveyLayers(findExplicitLayerManifests(), acceptsMark);
  return survey;
}

}  // namespace lavaray::vulkan
