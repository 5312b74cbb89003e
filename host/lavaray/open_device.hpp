#pragma once

#include <atomic>
#include <cstdio>
#include <future>
#include <memory>

#include "lavaray/cache_folder.hpp"
#include "lavaray/options.hpp"
#include "library/device_tuning.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// The device that the options ask for, and the instance that it belongs to.
struct OpenDevice {
  explicit OpenDevice(const Options& options)
      : instance(options.validate ? onMessage() : vulkan::OnMessage()),
        device(vulkan::chooseDevice(instance, options.device)),
        tuning(tuningChoice(options.tuning).value(), cacheFolder(), device) {}
  vulkan::OnMessage onMessage() {
    return [this](const std::string& message) {
      ++validationMessages;
      std::fprintf(stderr, "validation: %s\n", message.c_str());
    };
  }
  std::atomic<int> validationMessages{0};
  vulkan::Instance instance;
  vulkan::Device device;
  DeviceTuning tuning;
};

// A device that is opened while other work goes on: drivers take longer to start than most scenes to read.
class FutureDevice {
 public:
  explicit FutureDevice(const Options& options)
      : opening_(std::async(std::launch::async, [&] { return std::make_shared<OpenDevice>(options); })) {}

  // Waits for it the first time. Throws Error(kDevice) if there is none.
  OpenDevice& get() const { return *opening_.get(); }
  // For another thread to wait for it.
  [[nodiscard]] std::shared_future<std::shared_ptr<OpenDevice>> opening() const { return opening_; }

 private:
  std::shared_future<std::shared_ptr<OpenDevice>> opening_;
};

}  // namespace lavaray
