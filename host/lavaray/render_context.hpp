#pragma once

#include <optional>

#include "command_line/interrupt.hpp"
#include "command_line/progress.hpp"
#include "lavaray/open_device.hpp"
#include "lavaray/user_shader.hpp"

namespace lavaray {

// What a process keeps from one render to the next: the device with its pipelines, and the user's shader.
struct RenderContext {
  explicit RenderContext(const Options& options)
      : shader(options.shaders), device(options), progress(progressStyle(options.quiet)) {}

  // From the first ray until something is read anew: what is there by then is written.
  void keepWhenInterrupted() {
    if (!guard) guard.emplace();
  }

  std::optional<InterruptGuard> guard;  // goes last
  UserShader shader;                    // before the others, which have threads
  FutureDevice device;
  Progress progress;
};

}  // namespace lavaray
