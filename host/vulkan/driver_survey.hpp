#pragma once

#include <string>
#include <vector>

#include "vulkan/driver_probe.hpp"

namespace lavaray::vulkan {

// A driver's manifest, or what names one in vain.
struct SurveyedDriver {
  std::string file;
  DriverState state;
  std::string text;  // who names the manifest, and what is to be known of it: one line for a user
};

struct SurveyedLayer {
  std::string file;
  bool isBroken;  // it cannot be parsed, so that an old loader gives up altogether
  std::string text;
};

// All that the loader reads on its way to a device, and what comes of it, looked at apart from the loader,
// which does not say why it finds no driver.
struct DriverSurvey {
  std::vector<SurveyedDriver> drivers;
  std::vector<SurveyedLayer> implicitLayers;
  std::vector<SurveyedLayer> explicitLayers;

  // What is in the way of a device, for a user: what is broken, or, with `all`, all drivers as well.
  [[nodiscard]] std::vector<std::string> lines(bool all) const;
  // Whether the loader might find a driver if it did not see what is broken.
  [[nodiscard]] bool canDoWithout() const;
};

// Takes as long as it takes to start each driver: for an error, and where someone asks. Throws Error(kDevice)
// where there is no loader.
DriverSurvey surveyDrivers();

}  // namespace lavaray::vulkan
