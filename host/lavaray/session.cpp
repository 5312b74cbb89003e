#include "lavaray/session.hpp"

#include <iostream>

#include "command_line/interrupt.hpp"
#include "lavaray/cache_folder.hpp"
#include "lavaray/json_report.hpp"
#include "lavaray/origin.hpp"
#include "lavaray/run_report.hpp"
#include "lavaray/standard_input.hpp"
#include "lavaray/text_report.hpp"

namespace lavaray {
namespace {

// An interrupted picture is still written in full, and compressing so many pixels takes over a second.
bool takesLongToWrite(const Rectangle& part) {
  return part.pixels() > 4'000'000;
}

// The beginning of a message, `interrupted at 37 %; `, if the render was interrupted.
std::optional<std::string> describeInterruption(const RenderJob& job, const Statistics& statistics) {
  if (statistics.stopReason != StopReason::kInterrupted) return std::nullopt;
  return "interrupted at " + std::to_string(static_cast<int>(100.0 * job.shareDone())) + " %; ";
}

}  // namespace

Session::Session(const Options& options, RenderContext& context)
    : options_(options),
      context_(context),
      progress_(context.progress),
      inputs_(options, context.compiler),
      viewer_(options) {}

bool Session::isEnded() const {
  return wasInterrupted() || viewer_.isClosed();
}

void Session::printWarnings() {
  progress_.end();
  lavaray::printWarnings(std::cerr, inputs_.takeWarnings());
}

int Session::renderAndWrite(const IsOutdated& isOutdated) {
  RenderJob job(context_.device, inputs_.scene(), completeOptions());
  const ImageSize partSize{job.part().width(), job.part().height()};
  Files files(options_);
  files.outputs.checkSize(partSize);
  buildHierarchy(job);
  openDevice(job);
  viewer_.open(job.size());
  Checkpoint checkpoint(checkpointName(options_), options_.checkpointSeconds);

  const TextEntries origin = describeOrigin(options_, job.size(), context_.device.info().name);
  if (!traceLayers(job, files.layers, origin, isOutdated)) return 0;
  job.begin();
  resume(job);
  files.outputs.beginPicture(partSize, origin);
  if (!run(job, checkpoint, files.outputs, isOutdated)) return 0;

  checkpoint.save(job);
  viewer_.showFinished(job);
  const Statistics statistics = job.statistics();
  const std::optional<std::string> interruption = describeInterruption(job, statistics);
  if (interruption && takesLongToWrite(job.part()))
    std::cerr << "lavaray: " << *interruption << "writing the picture, which takes a while\n";
  writePicture(job, statistics, files.outputs);
  // After the picture, which must survive whatever fails from here on.
  files.layers.write(job, origin);
  files.layers.commit();
  writeReport(job, statistics, files.outputs);
  tellOutcome(interruption, checkpoint);
  return context_.validationMessages == 0 ? 0 : static_cast<int>(ErrorKind::kInternal);
}

// Tells of the target error that nobody asked for.
RenderOptions Session::completeOptions() {
  RenderOptions render = options_.render;
  render.shader = inputs_.shader();
  const std::optional<double> error = defaultTargetError(options_, inputs_.scene().summary());
  if (!error) return render;
  render.targetError = error;
  if (options_.quiet) return render;
  progress_.end();
  std::cerr << shownName(options_.scene) << ": a light has a radius: using --target-error " << *error
            << "; --spp 1 is one sample per pixel\n";
  return render;
}

void Session::buildHierarchy(RenderJob& job) {
  progress_.begin("building the hierarchy");
  job.buildHierarchy();
  times_.endStep("build");
}

void Session::openDevice(RenderJob& job) {
  progress_.begin("opening the device");
  const std::string name = context_.device.info().name;
  times_.endStep("wait for device");
  progress_.end();
  lavaray::printWarnings(std::cerr, context_.device.warnings());
  if (options_.verbose) std::cerr << "device: " << name << '\n';
  progress_.begin("preparing the render");
  job.prepare();
  progress_.end();
  if (!options_.verbose) return;
  std::cerr << "tuning: " << context_.device.tuning();
  if (options_.tuning == "measure" && cacheFolder().empty())
    std::cerr << "; not kept: neither XDG_CACHE_HOME nor HOME names a folder";
  std::cerr << '\n';
}

// Before the picture, so that an interrupted one has its layers.
bool Session::traceLayers(RenderJob& job, Layers& layers, const TextEntries& origin,
                          const IsOutdated& isOutdated) {
  if (!layers.areTraced()) return true;
  bool isOutOfDate = false;
  progress_.begin("tracing the layers");
  const bool isWhole = layers.trace(job, origin, [&](double share) {
    progress_.update(share, "");
    isOutOfDate = isOutdated();
    return !isEnded() && !isOutOfDate;
  });
  progress_.end();
  times_.endStep("trace layers");
  if (!isWhole && !isOutOfDate) throwInterrupted("interrupted before the picture was begun");
  return isWhole;
}

void Session::resume(RenderJob& job) {
  if (!options_.resume.empty()) lavaray::printWarnings(std::cerr, job.resume(options_.resume));
}

bool Session::run(RenderJob& job, Checkpoint& checkpoint, Outputs& outputs, const IsOutdated& isOutdated) {
  bool isOutOfDate = false;
  progress_.begin("rendering");
  context_.keepWhenInterrupted();
  job.run(
      [&] {
        checkpoint.saveIfDue(job);
        isOutOfDate = isOutdated();
        return proceed(job) && !isOutOfDate;
      },
      [&](const float* rgb) { outputs.writeRow(rgb); });
  progress_.end();
  times_.endStep("render", outputs.timeOfRows());
  if (isOutOfDate) return false;
  if (job.samplesPerPixel() == 0.0 && job.statistics().stopReason == StopReason::kInterrupted)
    throwInterrupted("interrupted before anything was rendered");
  return true;
}

void Session::writePicture(RenderJob& job, const Statistics& statistics, Outputs& outputs) {
  const View view = options_.render.view;
  if (outputs.hasFilm()) {
    outputs.writeFilm(job);
  } else {
    job.takeRows([&](const float* rgb) { outputs.writeRow(rgb); });
    outputs.endPicture(describeOutcome(view, statistics, times_.seconds()));
  }
  times_.endStep("write image");
  const std::optional<std::string> scale = describeScale(view, statistics);
  if (scale && !options_.quiet) std::cerr << name(view) << ": " << *scale << '\n';
}

void Session::writeReport(const RenderJob& job, const Statistics& statistics, Outputs& outputs) {
  if (!options_.stats && outputs.json() == nullptr) return;
  const RunReport report{.scene = inputs_.scene().summary(),
                         .picture = job.size(),
                         .render = statistics,
                         .device = context_.device.info(),
                         .peakMemoryBytes = peakMemoryBytes(),
                         .times = times_};
  if (options_.stats) printReport(std::cerr, report);
  if (outputs.json() == nullptr) return;
  try {
    writeJsonReport(outputs.json(), report);
    outputs.commitJson();
  } catch (const Error& error) {
    throw Error(error.kind(), options_.output + " is written, but " + error.what());
  }
}

void Session::tellOutcome(const std::optional<std::string>& interruption,
                          const Checkpoint& checkpoint) const {
  if (interruption) {
    const std::string name = options_.output == "-" ? "stdout" : options_.output;
    throwInterrupted(*interruption + name + " holds what was rendered, pixels without a sample are black");
  }
  if (options_.verbose) std::cerr << "wrote " << options_.output << '\n';
  if (checkpoint.hasFailed()) {
    throw Error(ErrorKind::kOutput, options_.output + " is written, but the checkpoint " +
                                        options_.checkpoint.string() + " is not: see the warning");
  }
}

bool Session::proceed(RenderJob& job) {
  progress_.update(job.shareDone(), describeSamples(job));
  viewer_.update(job);
  return !isEnded();
}

}  // namespace lavaray
