#include "app/session.hpp"

#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <type_traits>

#include "app/checkpoint.hpp"
#include "app/identity.hpp"
#include "app/interrupt.hpp"
#include "app/json_report.hpp"
#include "app/origin.hpp"
#include "app/usage.hpp"

namespace lavaray {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// A window shows a growing picture that often, at most; drawing it takes time from rendering.
constexpr auto kShowEvery = 250ms;
// How long a change or a key may wait to be noticed where nothing is rendered.
constexpr auto kIdle = 100ms;

// A crop is that part of the whole picture, so stretching needs the whole picture's largest value.
bool needsWhole(const Options& options) {
  return options.normalize || isMeasure(options.view);
}

RenderSettings renderSettings(const Options& options, const ImageSize& size, const Rectangle& part) {
  RenderSettings settings;
  settings.size = size;
  settings.crop = needsWhole(options) ? Rectangle{0, 0, size.width, size.height} : part;
  settings.maxDepth = options.maxDepth;
  settings.samples = options.samples;
  settings.range = options.sampleRange;
  settings.sampler = options.sampler;
  settings.filter = options.filter;
  settings.seed = options.seed;
  settings.targetError = options.targetError;
  settings.maxSamples = options.maxSamples;
  settings.timeLimitSeconds = options.timeLimitSeconds;
  settings.view = options.view;
  settings.countRays = options.stats || !options.json.empty();
  return settings;
}

std::string describeSamples(const Render& render) {
  std::ostringstream text;
  text << std::setprecision(3) << render.samplesPerPixel() << " spp";
  if (render.estimatedError() > 0.0) text << ", error " << render.estimatedError();
  return text.str();
}

bool keepsFilm(const Options& options) {
  return writesFilm(options) || !options.checkpoint.empty() || !options.resume.empty();
}

}  // namespace

Session::Session(const Options& options)
    : options_(options), inputs_(options), device_(options), progress_(progressStyle(options.quiet)) {}

bool Session::isEnded() const {
  return wasInterrupted() || windowClosed_;
}

ExitCode Session::run() {
  const ExitCode code = options_.watch ? watch() : renderOnce();
  return windowFailed_ && code == ExitCode::kSuccess ? ExitCode::kOutput : code;
}

ExitCode Session::renderOnce() {
  progress_.begin("reading the scene");
  inputs_.readScene({});
  times_.endStep("read scene");
  progress_.begin("compiling the shaders");
  if (inputs_.compileShaders({})) times_.endStep("compile shaders");
  printWarnings();
  const ExitCode code = renderAndWrite();
  showUntilClosed();
  return code;
}

void Session::printWarnings() {
  progress_.end();
  lavaray::printWarnings(std::cerr, inputs_.takeWarnings());
}

ExitCode Session::renderAndWrite() {
  catchInterrupts();  // Now, as there is a file from here on that must not stay behind.
  const Scene& scene = inputs_.scene();
  const ImageSize size = outputSize(options_, imageSize(scene.camera).value());
  const Rectangle part = cropWithin(options_.crop, size);
  RenderSettings settings = renderSettings(options_, size, part);
  settings.shader = inputs_.shader();
  Outputs outputs(options_);

  progress_.begin("building the hierarchy");
  inputs_.flatten();
  times_.endStep("build");
  progress_.begin("opening the device");
  OpenDevice& open = device_.get();
  times_.endStep("wait for device");
  progress_.end();
  lavaray::printWarnings(std::cerr, open.instance.takeWarnings());
  if (options_.verbose) std::cerr << "device: " << open.device.description().name << '\n';
  if (wasInterrupted()) throw Error(ExitCode::kInterrupted, "interrupted before anything was rendered");
  if (options_.display) openWindow(size);

  const Identity identity = keepsFilm(options_) ? describeIdentity(options_, scene, settings) : Identity{};
  Checkpoint checkpoint(options_.checkpoint, options_.checkpointSeconds, identity);
  Render render(open.device, inputs_.gpuScene(), scene.camera, settings);
  if (!options_.resume.empty()) {
    resume(options_.resume, identity, settings, open.device.description().name, render);
  }
  progress_.begin("rendering");
  render.run([&] {
    checkpoint.saveIfDue(render);
    return proceed(render);
  });
  progress_.end();
  times_.endStep("render");
  if (!changed_.empty()) return ExitCode::kSuccess;  // The picture is of the past already.

  checkpoint.save(render);
  if (window_) showInWindow(render, true);
  writeOutputs(render, settings, part, identity, outputs);
  if (render.statistics().stopReason == StopReason::kInterrupted) {
    const std::string name = options_.output == "-" ? "stdout" : options_.output;
    const int percent = static_cast<int>(100.0 * render.shareDone());
    throw Error(ExitCode::kInterrupted, "interrupted at " + std::to_string(percent) + " %; " + name +
                                            " holds what was rendered, pixels without a sample are black");
  }
  if (options_.verbose) std::cerr << "wrote " << options_.output << '\n';
  return open.instance.validationMessages() == 0 ? ExitCode::kSuccess : ExitCode::kInternalError;
}

void Session::writeOutputs(Render& render, const RenderSettings& settings, const Rectangle& part,
                           const Identity& identity, Outputs& outputs) {
  const vulkan::Device& device = device_.get().device;
  const RenderStatistics statistics = render.statistics();
  if (outputs.hasFilm()) {
    outputs.writeFilm(render, identity);
  } else {
    Image image = render.takeImage();
    if (options_.normalize) normalize(image);
    if (needsWhole(options_)) image = crop(image, part);
    outputs.writePicture(
        image, describeOrigin(options_, settings, statistics, device.description().name, times_.seconds()));
  }
  times_.endStep("write image");
  if (options_.stats) {
    printStatistics(std::cerr, inputs_.scene(), inputs_.gpuScene(), device, statistics);
    times_.print(std::cerr);
  }
  if (outputs.json() != nullptr) {
    writeJsonStatistics(outputs.json(), inputs_.scene(), settings.size, inputs_.gpuScene(), device,
                        statistics, times_);
    outputs.commitJson();
  }
}

bool Session::proceed(const Render& render) {
  progress_.update(render.shareDone(), describeSamples(render));
  if (window_) {
    const bool isDue = Clock::now() - lastShown_ >= kShowEvery && render.samplesPerPixel() > 0.0;
    if (isDue) showInWindow(render, false);
    windowClosed_ = !window_->isOpen();
  }
  if (watcher_) changed_ = watcher_->changes(0ms);
  return !isEnded() && changed_.empty();
}

// What `work` returns; nothing where its input is wrong, which is printed: someone is about to mend it.
template <typename Work>
std::optional<std::invoke_result_t<Work>> Session::attempt(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.exitCode() != ExitCode::kInput && error.exitCode() != ExitCode::kUsage) throw;
    progress_.end();
    std::cerr << "lavaray: " << error.what() << '\n';
    return std::nullopt;
  }
}

ExitCode Session::watch() {
  catchInterrupts();
  watcher_.emplace();  // before anything is read, so that no change is lost
  ExitCode code = ExitCode::kSuccess;
  bool isDue = false;  // there is something that no picture shows yet
  for (Files changed; !isEnded(); changed = changed_.empty() ? waitForChanges() : changed_) {
    if (!options_.quiet) {
      for (const auto& file : changed) std::cerr << "changed: " << file.string() << '\n';
    }
    times_ = StepTimes();
    isDue = readChanged(changed) || isDue;
    watcher_->watch(inputs_.files());
    changed_.clear();
    if (!isDue || !inputs_.areComplete()) continue;
    const std::optional<ExitCode> result = attempt([&] { return renderAndWrite(); });
    code = result.value_or(code);
    isDue = !changed_.empty();  // which ended the render
    if (result && !isDue && !options_.quiet) {
      std::cerr << "wrote " << options_.output << ": " << times_.inOneLine() << '\n';
    }
  }
  return code;
}

// Returns whether there is something new to render.
bool Session::readChanged(const Files& changed) {
  const auto timed = [&](const std::string& step, const auto& read) {
    progress_.begin(step);
    const bool isNew = attempt(read).value_or(false);
    if (isNew) times_.endStep(step);
    return isNew;
  };
  const bool isSceneNew = timed("read scene", [&] { return inputs_.readScene(changed); });
  const bool isShaderNew = timed("compile shaders", [&] { return inputs_.compileShaders(changed); });
  printWarnings();
  return isSceneNew || isShaderNew;
}

Inputs::Files Session::waitForChanges() {
  Files changed;
  while (changed.empty() && !isEnded()) {
    changed = watcher_->changes(kIdle);
    if (window_) windowClosed_ = !window_->isOpen();
  }
  return changed;
}

void Session::openWindow(const ImageSize& size) {
  if (window_ || windowFailed_) return;
  try {
    window_ = std::make_unique<Window>("lavaray", size);
  } catch (const Error& error) {
    windowFailed_ = true;  // The picture is written nonetheless; the exit code tells.
    std::cerr << "lavaray: " << error.what() << '\n';
  }
}

void Session::showInWindow(const Render& render, bool isFinished) {
  std::ostringstream title;
  title << options_.scene.filename().string() << ": " << describeSamples(render);
  const double share = render.shareDone();
  if (!isFinished) {
    title << ", " << static_cast<int>(100.0 * share) << " %, "
          << hoursAndMinutes(remainingTime(render.elapsed(), share)) << " left";
  }
  Image image = render.image();
  if (options_.normalize) normalize(image);
  window_->show(std::move(image), title.str());
  lastShown_ = Clock::now();
}

void Session::showUntilClosed() {
  while (window_ && !isEnded()) {
    window_->wait(kIdle);
    windowClosed_ = !window_->isOpen();
  }
}

}  // namespace lavaray
