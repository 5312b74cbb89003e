#pragma once

#include <optional>

#include "command_line/interrupt.hpp"
#include "command_line/progress.hpp"
#include "lavaray/open_device.hpp"
#include "lavaray/user_shader.hpp"

namespace lavaray {

// What the process keeps from one render to the next: the device with its pipelines, and the user's shader.
struct RenderContext {
  explicit RenderContext(const Options& options)
      : shader(options.shaders), device(options), progress(progressStyle(options.quiet)) {}

  // From the first ray until something is read anew, a signal is only remembered, and what is rendered is
  // written.
  void keepWhenInterrupted() {
    if (!guard) guard.emplace();
  }

  std::optional<InterruptGuard> guard;  // destroyed last
  UserShader shader;                    // forks: made before the others, which have threads
  FutureDevice device;
  Progress progress;
};

}  // namespace lavaray
