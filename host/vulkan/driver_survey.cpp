#include "vulkan/driver_survey.hpp"

#include <algorithm>

#include "vulkan/driver_filter.hpp"
#include "vulkan/driver_search.hpp"
#include "vulkan/loader.hpp"
#include "vulkan/manifest_file.hpp"

namespace lavaray::vulkan {
namespace {

// Since this version a byte-order mark is no fault to the loader, whose reader of JSON changed.
constexpr std::uint32_t kAcceptsMarkFrom = VK_MAKE_API_VERSION(0, 1, 4, 303);

bool loaderAcceptsMark() {
  loadGlobalFunctions();
  const auto version = reinterpret_cast<PFN_vkEnumerateInstanceVersion>(
      vkGetInstanceProcAddr(VK_NULL_HANDLE, "vkEnumerateInstanceVersion"));
  std::uint32_t number = 0;
  return version != nullptr && version(&number) == VK_SUCCESS && number >= kAcceptsMarkFrom;
}

SurveyedDriver surveyDriver(const ManifestPlace& place, bool acceptsMark) {
  if (!place.problem.empty()) return {place.file, DriverState::kFaulty, place.naming + place.problem};
  const ManifestContents contents = readDriverManifest(place.file, acceptsMark);
  if (!contents.problem.empty()) return {place.file, DriverState::kFaulty, place.naming + contents.problem};
  const std::string unused = whyFilteredOut(place.file);
  if (!unused.empty()) return {place.file, DriverState::kUnused, place.naming + unused};
  const DriverAnswer answer = probeDriver(contents.library);
  return {place.file, answer.state, place.naming + answer.text};
}

std::vector<SurveyedLayer> surveyLayers(const std::vector<ManifestPlace>& places, bool acceptsMark) {
  std::vector<SurveyedLayer> layers;
  for (const ManifestPlace& place : places) {
    if (!place.problem.empty()) continue;  // It keeps no loader from its work.
    const ManifestContents contents = readLayerManifest(place.file, acceptsMark);
    layers.push_back({place.file, contents.isUnparsable, place.naming + contents.problem});
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
  for (const ManifestPlace& place : findDriverManifests()) {
    survey.drivers.push_back(surveyDriver(place, acceptsMark));
  }
  survey.implicitLayers = surveyLayers(findImplicitLayerManifests(), acceptsMark);
  survey.explicitLayers = surveyLayers(findExplicitLayerManifests(), acceptsMark);
  return survey;
}

}  // namespace lavaray::vulkan
