#pragma once

#include <string>
#include <vector>

#include "vulkan/driver_probe.hpp"

namespace lavaray::vulkan {

// A driver's manifest, or the vain naming of one.
struct SurveyedDriver {
  std::string file;
  DriverState state;
  std::string text;  // a line for the user: who names the manifest, and what there is to know of it
};

struct SurveyedLayer {
  std::string file;
  bool isBroken;  // cannot be parsed, at which old loaders give up altogether
  std::string text;
};

// All that the loader reads on its way to a device, and what comes of it. Found out without the loader, which
// does not say why it finds no driver.
struct DriverSurvey {
  std::vector<SurveyedDriver> drivers;
  std::vector<SurveyedLayer> implicitLayers;
  std::vector<SurveyedLayer> explicitLayers;

  // What keeps a user from a device: all that is broken and, with `all`, every driver.
  [[nodiscard]] std::vector<std::string> lines(bool all) const;
  // Whether the loader might find a driver if it could not see what is broken.
  [[nodiscard]] bool canDoWithout() const;
};

// Starts each driver, which takes its time: for an error, or when asked for. Throws Error(kDevice) if there
// is no loader.
DriverSurvey surveyDrivers();

}  // namespace lavaray::vulkan
