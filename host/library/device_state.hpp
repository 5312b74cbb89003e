#pragma once

#include <lavaray/device.h>

#include <future>
#include <memory>
#include <string>

#include "library/device_tuning.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// The instance of all devices that are open. Throws Error(kUsage) where one of them is validated and this is
// not, or the other way round.
std::shared_ptr<vulkan::Instance> sharedInstance(vulkan::OnMessage onMessage);

// A device and the instance that it belongs to.
struct OpenDevice {
  OpenDevice(const std::string& choice, vulkan::OnMessage onMessage, const TuningChoice& way,
             const std::filesystem::path& tuningFolder)
      : instance(sharedInstance(std::move(onMessage))),
        device(vulkan::chooseDevice(*instance, choice)),
        tuning(way, tuningFolder, device) {}
  std::shared_ptr<vulkan::Instance> instance;
  vulkan::Device device;
  DeviceTuning tuning;
};

}  // namespace lavaray

namespace lavaray::v0 {

// Opened while other work goes on: drivers take longer to start than most scenes to read.
struct Device::State {
  std::shared_future<std::shared_ptr<OpenDevice>> opening;

  // Waits the first time. Throws lavaray::Error(kDevice) if there is none.
  OpenDevice& open() const { return *opening.get(); }
};

}  // namespace lavaray::v0
