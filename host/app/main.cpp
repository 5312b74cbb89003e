#include <future>
#include <iostream>
#include <memory>
#include <optional>

#include "app/interrupt.hpp"
#include "app/json_report.hpp"
#include "app/options.hpp"
#include "app/origin.hpp"
#include "app/program.hpp"
#include "app/report.hpp"
#include "core/errors.hpp"
#include "core/parallel.hpp"
#include "core/scene_reader.hpp"
#include "image/image_file.hpp"
#include "image/output_file.hpp"

namespace lavaray {
namespace {

// Where the picture goes: a file that is replaced as a whole, or stdout. Made before the rendering, so that a
// folder that cannot be written to is found out before the work.
class Output {
 public:
  explicit Output(const std::string& name) {
    if (name != "-") {
      file_ = std::make_unique<OutputFile>(name);
      format_ = imageFormat(name).value();
    }
  }
  void write(const Image& image, const TextEntries& origin) {
    writeImage(image, format_, file_ ? file_->stream() : stdout, origin);
    if (file_) file_->commit();
    if (!file_ && std::fflush(stdout) != 0)
      throw Error(ExitCode::kOutput, "the image cannot be written to stdout");
  }

 private:
  std::unique_ptr<OutputFile> file_;
  ImageFormat format_ = ImageFormat::kPpm;
};

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

struct OpenDevice {
  explicit OpenDevice(const Options& options)
      : instance(options.validate), device(vulkan::chooseDevice(instance, options.device)) {}
  vulkan::Instance instance;
  vulkan::Device device;
};

using FutureDevice = std::future<std::unique_ptr<OpenDevice>>;

ExitCode renderScene(const Options& options, const Scene& scene, FutureDevice futureDevice,
                     StepTimes& times) {
  const std::atomic<bool>& interrupted = catchInterrupts();
  const ImageSize size = outputSize(options, imageSize(scene.camera).value());
  const Rectangle part = outputCrop(options, size);
  const RenderSettings settings = renderSettings(options, size, part);
  Output output(options.output);
  std::optional<OutputFile> json;
  if (!options.json.empty()) json.emplace(options.json);

  const GpuScene gpuScene = flatten(scene, hardwareThreads());
  times.endStep("build");
  const std::unique_ptr<OpenDevice> open = futureDevice.get();
  vulkan::Device& device = open->device;
  if (options.verbose) std::cerr << "device: " << device.description().name << '\n';
  times.endStep("wait for device");
  const auto proceed = [&](const RenderInProgress&) { return !interrupted; };
  RenderResult result = render(device, gpuScene, scene.camera, settings, proceed);
  times.endStep("render");

  const TextEntries origin =
      describeOrigin(options, settings, result, device.description().name, times.seconds());
  if (options.normalize) normalize(result.image);
  if (needsWhole(options)) {
    output.write(crop(result.image, part), origin);
  } else {
    output.write(result.image, origin);
  }
  times.endStep("write image");
  if (options.stats) {
    printStatistics(std::cerr, scene, gpuScene, device, result);
    times.print(std::cerr);
  }
  if (json) {
    writeJsonStatistics(json->stream(), scene, gpuScene, device, result, times);
    json->commit();
  }
  if (result.stopReason == StopReason::kInterrupted) {
    const std::string name = options.output == "-" ? "stdout" : options.output;
    throw Error(ExitCode::kInterrupted,
                "interrupted; " + name + " holds what was rendered, the rest is black");
  }
  if (options.verbose) std::cerr << "wrote " << options.output << '\n';
  return open->instance.validationMessages() == 0 ? ExitCode::kSuccess : ExitCode::kInternalError;
}

ExitCode run(const Options& options) {
  if (options.listDevices) {
    printDevices(std::cerr, vulkan::listDevices(vulkan::Instance(options.validate)));
    return ExitCode::kSuccess;
  }
  StepTimes times;
  // Drivers take longer to start than most scenes to read.
  FutureDevice device;
  if (!options.check) {
    device = std::async(std::launch::async, [&] { return std::make_unique<OpenDevice>(options); });
  }
  Scene scene = readScene(options.scene);
  applyDefaults(options, scene);
  times.endStep("read scene");
  for (const std::string& warning : scene.warnings) std::cerr << "warning: " << warning << '\n';
  if (options.check) {
    printScene(std::cerr, scene);
    return ExitCode::kSuccess;
  }
  return renderScene(options, scene, std::move(device), times);
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray", [&] {
    const auto options = lavaray::parseOptions(argc, argv);
    return options ? lavaray::run(*options) : lavaray::ExitCode::kSuccess;
  });
}
