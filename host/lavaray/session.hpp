#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/errors.hpp"
#include "lavaray/checkpoint.hpp"
#include "lavaray/inputs.hpp"
#include "lavaray/layers.hpp"
#include "lavaray/options.hpp"
#include "lavaray/outputs.hpp"
#include "lavaray/preparation.hpp"
#include "lavaray/render_context.hpp"
#include "lavaray/step_times.hpp"
#include "lavaray/viewer.hpp"
#include "render/render.hpp"

namespace lavaray {

// A scene and, as the options say, a render of it to its files, or one after the other as the scene changes.
class Session {
 public:
  // Both must outlive it.
  Session(const Options& options, RenderContext& context);

  // Asked during a render. Once it returns true, the picture is out of date: the render ends, and nothing is
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
  // What is rendered, and the part of it that the picture shows: where stretching needs all values, not all
  // is shown.
  struct Plan {
    RenderSettings settings;
    Rectangle part;
  };
  // What is written but the checkpoint. Made before the work, so that what cannot be written is found out by
  // then.
  struct Files {
    explicit Files(const Options& options) : outputs(options), layers(options) {}
    Outputs outputs;
    Layers layers;
  };

  // The steps of renderAndWrite. Those that return a bool return false if the picture is out of date.
  [[nodiscard]] Plan makePlan() const;
  void tellDefaultError(double error);
  std::unique_ptr<Preparation> beginPreparation(RenderSettings& settings);
  void buildHierarchy();
  OpenDevice& openDevice();
  void tune(OpenDevice& open, RenderSettings& settings);
  bool traceLayers(Layers& layers, const Plan& plan, const IsOutdated& isOutdated);
  bool run(Render& render, Checkpoint& checkpoint, Outputs& outputs, const IsOutdated& isOutdated);
  void writePicture(Render& render, const Plan& plan, const Identity& identity, Outputs& outputs);
  void writeReport(const RenderStatistics& statistics, const ImageSize& picture, Outputs& outputs);
  // Throws if the picture is not all that was asked for, or the checkpoint is not written.
  void tellOutcome(const std::optional<std::string>& interruption, const Checkpoint& checkpoint) const;

  bool proceed(const Render& render);

  const Options& options_;
  RenderContext& context_;
  FutureDevice& device_;
  Progress& progress_;
  Inputs inputs_;
  StepTimes times_;
  Viewer viewer_;
  std::uint32_t minStackSize_ = 0;  // of the pipeline that was prepared
};

}  // namespace lavaray
