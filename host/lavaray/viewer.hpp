#pragma once

#include <lavaray/renderer.h>

#include <chrono>
#include <memory>

#include "lavaray/options.hpp"
#include "lavaray/window.hpp"

namespace lavaray {

// The window of --display, which shows the growing picture; without that option it does nothing.
class Viewer {
 public:
  explicit Viewer(const Options& options) : options_(options) {}

  // The first time, opens the window for a picture of this size.
  void open(const ImageSize& size);
  // Handles keys and mouse, and shows the picture if it was last shown long enough ago.
  void update(RenderJob& job);
  void showFinished(RenderJob& job);
  // Handles keys and mouse while nothing is rendered.
  void idle();
  void waitUntilClosed();

  [[nodiscard]] bool isClosed() const { return isClosed_; }  // by the user
  [[nodiscard]] bool hasFailed() const { return hasFailed_; }

 private:
  void show(RenderJob& job, bool isFinished);

  const Options& options_;
  std::unique_ptr<Window> window_;
  bool isClosed_ = false;
  bool hasFailed_ = false;
  std::chrono::steady_clock::time_point lastShown_;
};

// Like `14 spp, error 0.01`.
std::string describeSamples(const RenderJob& job);

}  // namespace lavaray
