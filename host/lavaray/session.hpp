#pragma once

#include <lavaray/renderer.h>

#include <functional>
#include <optional>
#include <string>

#include "lavaray/checkpoint.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/layers.hpp"
#include "lavaray/options.hpp"
#include "lavaray/outputs.hpp"
#include "lavaray/render_context.hpp"
#include "lavaray/step_times.hpp"
#include "lavaray/viewer.hpp"

namespace lavaray {

// A scene and, as the options say, a render of it to its files, or one after the other as the scene changes.
class Session {
 public:
  // Both must outlive it.
  Session(const Options& options, RenderContext& context);

  // Asked during a render. Once it returns true, the picture is out of date: the render ends, and nothing is
  // written.
  using IsOutdated = std::function<bool()>;
  // Renders the scene that the inputs have read, and writes its files. Returns the exit code.
  int renderAndWrite(const IsOutdated& isOutdated = [] { return false; });
  void printWarnings();  // of the inputs

  Inputs& inputs() { return inputs_; }
  StepTimes& times() { return times_; }
  Viewer& viewer() { return viewer_; }
  // Whether the user has closed the window or interrupted the program.
  [[nodiscard]] bool isEnded() const;

 private:
  // What is written but the checkpoint. Made before the work, so that what cannot be written is found out by
  // then.
  struct Files {
    explicit Files(const Options& options) : outputs(options), layers(options) {}
    Outputs outputs;
    Layers layers;
  };

  // The steps of renderAndWrite. Those that return a bool return false if the picture is out of date.
  RenderOptions completeOptions();
  void buildHierarchy(RenderJob& job);
  void openDevice(RenderJob& job);
  bool traceLayers(RenderJob& job, Layers& layers, const TextEntries& origin, const IsOutdated& isOutdated);
  void resume(RenderJob& job);
  bool run(RenderJob& job, Checkpoint& checkpoint, Outputs& outputs, const IsOutdated& isOutdated);
  void writePicture(RenderJob& job, const Statistics& statistics, Outputs& outputs);
  void writeReport(const RenderJob& job, const Statistics& statistics, Outputs& outputs);
  // Throws if the picture is not all that was asked for, or the checkpoint is not written.
  void tellOutcome(const std::optional<std::string>& interruption, const Checkpoint& checkpoint) const;

  bool proceed(RenderJob& job);

  const Options& options_;
  RenderContext& context_;
  Progress& progress_;
  Inputs inputs_;
  StepTimes times_;
  Viewer viewer_;
};

}  // namespace lavaray
