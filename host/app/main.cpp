#include <iostream>
#include <memory>

#include "app/interrupt.hpp"
#include "app/options.hpp"
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
  void write(const Image& image) {
    writeImage(image, format_, file_ ? file_->stream() : stdout);
    if (file_) file_->commit();
    if (!file_ && std::fflush(stdout) != 0)
      throw Error(ExitCode::kOutput, "the image cannot be written to stdout");
  }

 private:
  std::unique_ptr<OutputFile> file_;
  ImageFormat format_ = ImageFormat::kPpm;
};

ExitCode render(const Options& options, const Scene& scene, StepTimes& times) {
  const std::atomic<bool>& stop = catchInterrupts();
  const ImageSize size = outputSize(options, imageSize(scene.camera).value());
  const Rectangle whole{0, 0, size.width, size.height};
  const Rectangle part = outputCrop(options, size);
  // A crop is that part of the whole picture, so stretching needs the whole picture's largest value.
  const RenderSettings settings{size, options.normalize ? whole : part, options.stats};
  Output output(options.output);

  const GpuScene gpuScene = flatten(scene, hardwareThreads());
  times.endStep("build");
  const vulkan::Instance instance(options.validate);
  vulkan::Device device(vulkan::chooseDevice(instance, options.device));
  if (options.verbose) std::cerr << "device: " << device.description().name << '\n';
  times.endStep("open device");
  Renderer renderer(device, gpuScene, scene.camera, settings);
  times.endStep("upload, pipeline");
  RenderResult result = renderer.render(stop);
  times.endStep("render");

  if (options.normalize) {
    normalize(result.image);
    result.image = crop(result.image, part);
  }
  output.write(result.image);
  times.endStep("write image");
  if (options.stats) {
    printStatistics(std::cerr, scene, gpuScene, device, renderer, result);
    times.print(std::cerr);
  }
  if (!result.complete) {
    const std::string name = options.output == "-" ? "stdout" : options.output;
    throw Error(ExitCode::kInterrupted,
                "interrupted; " + name + " holds what was rendered, the rest is black");
  }
  if (options.verbose) std::cerr << "wrote " << options.output << '\n';
  return instance.validationMessages() == 0 ? ExitCode::kSuccess : ExitCode::kInternalError;
}

ExitCode run(const Options& options) {
  if (options.listDevices) {
    printDevices(std::cerr, vulkan::listDevices(vulkan::Instance(options.validate)));
    return ExitCode::kSuccess;
  }
  StepTimes times;
  const Scene scene = readScene(options.scene);
  times.endStep("read scene");
  for (const std::string& warning : scene.warnings) std::cerr << "warning: " << warning << '\n';
  if (options.check) {
    printScene(std::cerr, scene);
    return ExitCode::kSuccess;
  }
  return render(options, scene, times);
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray", [&] {
    const auto options = lavaray::parseOptions(argc, argv);
    return options ? lavaray::run(*options) : lavaray::ExitCode::kSuccess;
  });
}
