#pragma once

#include <lavaray/renderer.h>

#include <chrono>
#include <set>
#include <string>

namespace lavaray {

// Saves a film of a render from time to time.
class Checkpoint {
 public:
  // No file, no checkpoint. Throws Error(kOutput) if the file cannot be written.
  Checkpoint(const OutputName& file, double everySeconds);

  // If the file cannot be written they warn, once for each reason: the render goes on, and the next attempt
  // may succeed.
  void saveIfDue(RenderJob& job);
  void save(RenderJob& job);
  [[nodiscard]] bool hasFailed() const { return hasFailed_; }  // the last time

 private:
  using Clock = std::chrono::steady_clock;
  OutputName file_;
  std::chrono::duration<double> every_;
  Clock::time_point last_ = Clock::now();
  bool hasFailed_ = false;
  std::set<std::string> reasons_;
};

}  // namespace lavaray
