#pragma once

#include <chrono>
#include <filesystem>
#include <set>
#include <string>

#include "base/output_file.hpp"
#include "film/film.hpp"
#include "render/render.hpp"

namespace lavaray {

// Lets the render resume from the film in `file`. Throws Error(kInput) naming what differs there: scene,
// options, crop, samples.
void resume(const std::filesystem::path& file, const Identity& identity, const RenderSettings& settings,
            const std::string& device, Render& render);

// Saves a film of a render from time to time.
class Checkpoint {
 public:
  // No file, no checkpoint. Throws Error(kOutput) if the file cannot be written.
  Checkpoint(const OutputName& file, double everySeconds, const Identity& identity);

  // If the file cannot be written they warn, once for each reason: the render goes on, and the next attempt
  // may succeed.
  void saveIfDue(const Render& render);
  void save(const Render& render);
  [[nodiscard]] bool hasFailed() const { return hasFailed_; }  // the last time

 private:
  using Clock = std::chrono::steady_clock;
  OutputName file_;
  std::chrono::duration<double> every_;
  const Identity& identity_;
  Clock::time_point last_ = Clock::now();
  bool hasFailed_ = false;
  std::set<std::string> reasons_;
};

}  // namespace lavaray
