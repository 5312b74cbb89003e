#pragma once

#include <functional>

#include "base/errors.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/layers.hpp"
#include "lavaray/options.hpp"
#include "lavaray/outputs.hpp"
#include "lavaray/render_context.hpp"
#include "lavaray/step_times.hpp"
#include "lavaray/viewer.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// A scene, and a render of it to its files as the options say, or one after the other while the scene
// changes.
class Session {
 public:
  // Both must outlive it.
  Session(const Options& options, RenderContext& context);

  // Asked during a render. Where it returns true the picture is of the past: the render ends, and nothing is
  // written.
  using IsOutdated = std::function<bool()>;
  // Renders the scene that the inputs have read, and writes its files.
  ExitCode renderAndWrite(const IsOutdated& isOutdated = [] { return false; });
  void printWarnings();  // of the inputs

  Inputs& inputs() { return inputs_; }
  StepTimes& times() { return times_; }
  Viewer& viewer() { return viewer_; }
  // Whether the user has closed the window or interrupted the program.
  [[nodiscard]] bool isEnded() const;

 private:
  void writePicture(Render& render, const RenderSettings& settings, const Identity& identity,
                    Outputs& outputs);
  void writeStatistics(const RenderStatistics& statistics, const RenderSettings& settings, Outputs& outputs);
  bool traceLayers(Layers& layers, const RenderSettings& settings, const Rectangle& part,
                   const IsOutdated& isOutdated);
  bool proceed(const Render& render);

  const Options& options_;
  RenderContext& context_;
  FutureDevice& device_;
  Progress& progress_;
  Inputs inputs_;
  StepTimes times_;
  Viewer viewer_;
};

}  // namespace lavaray
