#include "lavaray/session.hpp"

#include <iostream>
#include <span>

#include "base/available_memory.hpp"
#include "command_line/interrupt.hpp"
#include "lavaray/identity.hpp"
#include "lavaray/json_report.hpp"
#include "lavaray/origin.hpp"
#include "lavaray/run_report.hpp"
#include "lavaray/standard_input.hpp"
#include "lavaray/text_report.hpp"
#include "library/crop.hpp"
#include "render/preparation.hpp"

namespace lavaray {
namespace {

// A crop shows what the whole picture would show there, so stretching needs the largest value of the whole.
bool needsWhole(const Options& options) {
  return options.normalize || isMeasure(options.render.view);
}

bool keepsFilm(const Options& options) {
  return writesFilm(options) || !options.checkpoint.empty() || !options.resume.empty();
}

// At one sample per pixel, rows go to the file while others are traced, unless something needs all of them.
bool keepsPicture(const Options& options, const RenderSettings& settings) {
  return !takesCenters(settings) || needsWhole(options) || options.render.view == View::kSamples ||
         options.display || keepsFilm(options);
}

// The settings asked for, completed by what depends on the scene.
RenderSettings renderSettings(const Options& options, const Scene& scene, const ImageSize& size,
                              const Rectangle& part) {
  RenderSettings settings = options.render;
  if (!settings.targetError) settings.targetError = defaultTargetError(options, scene);
  settings.size = size;
  settings.crop = needsWhole(options) ? Rectangle{0, 0, size.width, size.height} : part;
  settings.keepsPicture = keepsPicture(options, settings);
  settings.countRays = options.stats || !options.json.empty();
  settings.recordTimes = settings.countRays;
  return settings;
}

// An interrupted picture is still written in full, and compressing so many pixels takes over a second.
bool takesLongToWrite(const Rectangle& part) {
  return std::int64_t{part.width()} * part.height() > 4'000'000;
}

// Called before the first ray: later, all that was rendered would be lost.
void checkMemory(const RenderSettings& settings, bool canBeCropped) {
  const std::uint64_t needed = hostBytes(settings);
  const AvailableMemory room = availableMemory();
  if (needed <= room.bytes) return;
  const Rectangle& part = settings.crop;
  throw Error(ExitCode::kMemory, "there is not enough memory: a picture of " + std::to_string(part.width()) +
                                     " x " + std::to_string(part.height()) + " pixels needs " +
                                     inGigabytes(needed) + ", and " + room.limit + ' ' +
                                     inGigabytes(room.bytes) + "; a smaller --width or --height needs less" +
                                     (canBeCropped ? ", or parts by --crop" : "") +
                                     (takesCenters(settings) ? "" : ", or one sample per pixel"));
}

bool isInterrupted(const Render& render) {
  return render.statistics().stopReason == StopReason::kInterrupted;
}

// The beginning of a message, `interrupted at 37 %; `, if the render was interrupted.
std::optional<std::string> describeInterruption(const Render& render) {
  if (!isInterrupted(render)) return std::nullopt;
  return "interrupted at " + std::to_string(static_cast<int>(100.0 * render.shareDone())) + " %; ";
}

}  // namespace

Session::Session(const Options& options, RenderContext& context)
    : options_(options),
      context_(context),
      device_(context.device),
      progress_(context.progress),
      inputs_(options, context.shader),
      viewer_(options) {}

bool Session::isEnded() const {
  return wasInterrupted() || viewer_.isClosed();
}

void Session::printWarnings() {
  progress_.end();
  lavaray::printWarnings(std::cerr, inputs_.takeWarnings());
}

ExitCode Session::renderAndWrite(const IsOutdated& isOutdated) {
  Plan plan = makePlan();
  if (plan.settings.targetError != options_.render.targetError) tellDefaultError(*plan.settings.targetError);
  Files files(options_);
  files.outputs.checkSize(plan.part.width(), plan.part.height());
  const std::unique_ptr<Preparation> preparation = beginPreparation(plan.settings);
  buildHierarchy();
  if (preparation && preparation->stop()) minStackSize_ = plan.settings.minStackSize;
  plan.settings.minStackSize = minStackSize_;
  OpenDevice& open = openDevice();
  tune(open, plan.settings);
  const std::string& deviceName = open.device.description().name;
  viewer_.open(plan.settings.size);
  const Identity identity =
      keepsFilm(options_) ? describeIdentity(options_, inputs_, plan.settings) : Identity{};
  Checkpoint checkpoint(checkpointName(options_), options_.checkpointSeconds, identity);
  checkMemory(plan.settings, !needsWhole(options_));

  if (!traceLayers(files.layers, plan, isOutdated)) return ExitCode::kSuccess;
  Render render(open.device, inputs_.gpuScene(), plan.settings);
  if (!options_.resume.empty()) resume(options_.resume, identity, plan.settings, deviceName, render);
  files.outputs.beginPicture(plan.part, describeOrigin(options_, plan.settings, deviceName));
  if (!run(render, checkpoint, files.outputs, isOutdated)) return ExitCode::kSuccess;

  checkpoint.save(render);
  viewer_.showFinished(render);
  const std::optional<std::string> interruption = describeInterruption(render);
  if (interruption && takesLongToWrite(plan.part))
    std::cerr << "lavaray: " << *interruption << "writing the picture, which takes a while\n";
  writePicture(render, plan, identity, files.outputs);
  // After the picture, which must survive whatever fails from here on.
  files.layers.write(render, plan.settings, plan.part, deviceName);
  files.layers.commit();
  writeReport(render.statistics(), plan.settings.size, files.outputs);
  tellOutcome(interruption, checkpoint);
  return open.validationMessages == 0 ? ExitCode::kSuccess : ExitCode::kInternalError;
}

void Session::tellDefaultError(double error) {
  if (options_.quiet) return;
  progress_.end();
  std::cerr << shownName(options_.scene) << ": a light has a radius: using --target-error " << error
            << "; --spp 1 is one sample per pixel\n";
}

Session::Plan Session::makePlan() const {
  const ImageSize size = outputSize(options_, imageSize(inputs_.scene().camera).value());
  const Rectangle part = options_.crop.value_or(Rectangle{0, 0, size.width, size.height});
  checkWithin(part, size);
  RenderSettings settings = renderSettings(options_, inputs_.scene(), size, part);
  settings.shader = inputs_.shader();
  return {settings, part};
}

// Before the first hierarchy: later ones are built with the pipeline of the first at hand.
std::unique_ptr<Preparation> Session::beginPreparation(RenderSettings& settings) {
  const SceneFeatures features = featuresOf(inputs_.scene());
  if (inputs_.isFlattened() || !isWorthPreparing(features, settings)) return nullptr;
  settings.minStackSize = expectedStackSize(features.primitiveCount);
  return std::make_unique<Preparation>(device_, features, settings);
}

void Session::buildHierarchy() {
  progress_.begin("building the hierarchy");
  inputs_.flatten();
  times_.endStep("build");
}

OpenDevice& Session::openDevice() {
  progress_.begin("opening the device");
  OpenDevice& open = device_.get();
  times_.endStep("wait for device");
  progress_.end();
  lavaray::printWarnings(std::cerr, open.instance.warnings());
  if (options_.verbose) std::cerr << "device: " << open.device.description().name << '\n';
  return open;
}

// A render that is worth measuring for has no pipeline prepared, which would look at the tuning meanwhile.
void Session::tune(OpenDevice& open, RenderSettings& settings) {
  progress_.begin("measuring the device");
  open.tuning.prepareFor(inputs_.gpuScene().lightCount, settings);
  progress_.end();
  settings.tuning = open.tuning.get();
  if (!options_.verbose) return;
  std::cerr << "tuning: " << open.tuning.description();
  if (options_.tuning == "measure" && cacheFolder().empty())
    std::cerr << "; not kept: neither XDG_CACHE_HOME nor HOME names a folder";
  std::cerr << '\n';
}

// Before the picture, so that an interrupted one has its layers.
bool Session::traceLayers(Layers& layers, const Plan& plan, const IsOutdated& isOutdated) {
  if (!layers.areTraced()) return true;
  bool isOutOfDate = false;
  progress_.begin("tracing the layers");
  const bool isWhole =
      layers.trace(device_.get().device, inputs_.gpuScene(), plan.settings, plan.part, [&](double share) {
        progress_.update(share, "");
        isOutOfDate = isOutdated();
        return !isEnded() && !isOutOfDate;
      });
  progress_.end();
  times_.endStep("trace layers");
  if (isWhole || isOutOfDate) return isWhole;
  throw Error(static_cast<ExitCode>(interruptCode()), "interrupted before the picture was begun");
}

bool Session::run(Render& render, Checkpoint& checkpoint, Outputs& outputs, const IsOutdated& isOutdated) {
  bool isOutOfDate = false;
  progress_.begin("rendering");
  context_.keepWhenInterrupted();
  render.run(
      [&] {
        checkpoint.saveIfDue(render);
        isOutOfDate = isOutdated();
        return proceed(render) && !isOutOfDate;
      },
      [&](std::span<const float> row) { outputs.writeRow(row); });
  progress_.end();
  times_.endStep("render", outputs.timeOfRows());
  if (isOutOfDate) return false;
  if (render.samplesPerPixel() == 0.0 && isInterrupted(render))
    throw Error(static_cast<ExitCode>(interruptCode()), "interrupted before anything was rendered");
  return true;
}

void Session::writePicture(Render& render, const Plan& plan, const Identity& identity, Outputs& outputs) {
  const RenderStatistics statistics = render.statistics();
  if (outputs.hasFilm()) {
    outputs.writeFilm(render, identity);
  } else {
    outputs.writeRowsOf(render, plan.settings.crop);
    outputs.endPicture(describeOutcome(plan.settings.view, statistics, times_.seconds()));
  }
  times_.endStep("write image");
  const std::optional<std::string> scale = describeScale(plan.settings.view, statistics);
  if (scale && !options_.quiet) std::cerr << viewName(plan.settings.view) << ": " << *scale << '\n';
}

void Session::writeReport(const RenderStatistics& statistics, const ImageSize& picture, Outputs& outputs) {
  if (!options_.stats && outputs.json() == nullptr) return;
  const RunReport report = reportRun(inputs_.scene(), inputs_.gpuScene(), picture,
                                     device_.get().device.description(), statistics, times_);
  if (options_.stats) printReport(std::cerr, report);
  if (outputs.json() == nullptr) return;
  try {
    writeJsonReport(outputs.json(), report);
    outputs.commitJson();
  } catch (const Error& error) {
    throw Error(error.exitCode(), options_.output + " is written, but " + error.what());
  }
}

void Session::tellOutcome(const std::optional<std::string>& interruption,
                          const Checkpoint& checkpoint) const {
  if (interruption) {
    const std::string name = options_.output == "-" ? "stdout" : options_.output;
    throw Error(static_cast<ExitCode>(interruptCode()),
                *interruption + name + " holds what was rendered, pixels without a sample are black");
  }
  if (options_.verbose) std::cerr << "wrote " << options_.output << '\n';
  if (checkpoint.hasFailed()) {
    throw Error(ExitCode::kOutput, options_.output + " is written, but the checkpoint " +
                                       options_.checkpoint.string() + " is not: see the warning");
  }
}

bool Session::proceed(const Render& render) {
  progress_.update(render.shareDone(), describeSamples(render));
  viewer_.update(render);
  return !isEnded();
}

}  // namespace lavaray
