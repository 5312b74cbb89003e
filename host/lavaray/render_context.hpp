#pragma once

#include <lavaray/device.h>

#include <atomic>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "command_line/interrupt.hpp"
#include "command_line/progress.hpp"
#include "lavaray/cache_folder.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// What the process keeps from one render to the next: the device with its pipelines, and the user's shader.
struct RenderContext {
  explicit RenderContext(const Options& options)
      : compiler(options.shaders.empty() ? std::nullopt
                                         : std::make_optional<ShaderCompiler>(options.shaders)),
        device(options.device, options.validate ? onMessage() : nullptr, {options.tuning, cacheFolder()}),
        progress(progressStyle(options.quiet)) {}
  RenderContext(const RenderContext&) = delete;
  RenderContext& operator=(const RenderContext&) = delete;

  // From the first ray until something is read anew, a signal is only remembered, and what is rendered is
  // written.
  void keepWhenInterrupted() {
    if (!guard) guard.emplace();
  }

  std::optional<InterruptGuard> guard;     // destroyed last
  std::optional<ShaderCompiler> compiler;  // forks: made before the others, which have threads
  std::atomic<int> validationMessages{0};
  Device device;
  Progress progress;

 private:
  std::function<void(const std::string&)> onMessage() {
    return [this](const std::string& message) {
      ++validationMessages;
      std::fprintf(stderr, "validation: %s\n", message.c_str());
    };
  }
};

}  // namespace lavaray
