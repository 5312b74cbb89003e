#pragma once

#include "app/open_device.hpp"
#include "app/progress.hpp"
#include "app/user_shader.hpp"

namespace lavaray {

// What a process keeps from one render to the next: the device with its pipelines, and the user's shader.
struct RenderContext {
  explicit RenderContext(const Options& options)
      : shader(options.shaders), device(options), progress(progressStyle(options.quiet)) {}
  UserShader shader;  // before the others, which have threads
  FutureDevice device;
  Progress progress;
};

}  // namespace lavaray
