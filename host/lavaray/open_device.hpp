#pragma once

#include <future>
#include <memory>

#include "lavaray/options.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// The device that the options ask for, and the instance that it belongs to.
struct OpenDevice {
  explicit OpenDevice(const Options& options)
      : instance(options.validate), device(vulkan::chooseDevice(instance, options.device)) {}
  vulkan::Instance instance;
  vulkan::Device device;
};

// A device that is opened while other work goes on: drivers take longer to start than most scenes to read.
class FutureDevice {
 public:
  explicit FutureDevice(const Options& options)
      : future_(std::async(std::launch::async, [&] { return std::make_unique<OpenDevice>(options); })) {}

  // Waits for it the first time. Throws Error(kDevice) if there is none.
  OpenDevice& get() {
    if (!device_) device_ = future_.get();
    return *device_;
  }

 private:
  std::future<std::unique_ptr<OpenDevice>> future_;
  std::unique_ptr<OpenDevice> device_;
};

}  // namespace lavaray
