// Measures what specialization is worth. For each scene it compares the pipeline that has only what the scene
// needs with the general one, by the time until the first pixel is traced and by the time of a picture. It
// also times a picture by the pipeline that reads the scene from storage buffers, which always has the
// hierarchy. Run it without a shader cache, as tools/bench-speed does: a cached shader needs no compiling.
#include <charconv>
#include <iomanip>
#include <iostream>
#include <optional>
#include <span>
#include <string>

#include "base/errors.hpp"
#include "bvh/flatten.hpp"
#include "command_line/program.hpp"
#include "library/guarded.hpp"
#include "measure.hpp"
#include "render/tracer.hpp"
#include "scene/camera.hpp"
#include "scene/scene_reader.hpp"
#include "vulkan/device.hpp"

namespace lavaray::bench {
namespace {

constexpr int kColdRounds = 3;
constexpr const char* kUsage =
    "usage: bench-pipelines ROUNDS DEVICE SCENE... (DEVICE may be empty: the best one)";

struct Pipeline {
  const GpuScene& gpuScene;
  RenderSettings settings;
};

Tracer makeTracer(vulkan::Device& device, const Pipeline& pipeline, std::uint64_t items) {
  return {device, pipeline.gpuScene, pipeline.settings, pipeline.settings.crop, items};
}

void trace(Tracer& tracer, std::uint64_t pixels) {
  tracer.run(
      uniformPass(pixels, {0, 1}), 0, [](std::uint64_t, std::span<const gpu::WorkResult>) {},
      [] { return false; });
}

// Milliseconds by the clock until the first pixel, and of processor time for a picture; the minimum of the
// rounds.
void measureScene(vulkan::Device& device, const std::string& file, int rounds) {
  const Scene scene = readScene(file);
  const GpuScene gpuScene = flatten(scene, 1);
  RenderSettings settings;
  settings.size = imageSize(scene.camera).value();
  settings.crop = {0, 0, settings.size.width, settings.size.height};
  const Pipeline specialized{gpuScene, settings};
  settings.specialized = false;
  const Pipeline general{gpuScene, settings};
  settings.specialized = true;
  settings.sceneInStorage = true;
  const Pipeline inStorage{gpuScene, settings};
  const auto pixels =
      static_cast<std::uint64_t>(settings.size.width) * static_cast<std::uint64_t>(settings.size.height);

  const auto first = [&](const Pipeline& pipeline) {
    device.pipelines().clear();
    Tracer tracer = makeTracer(device, pipeline, 1);
    trace(tracer, 1);
  };
  const std::vector<Timing> cold = measure(
      {{"general", [&] { first(general); }}, {"specialized", [&] { first(specialized); }}}, kColdRounds);

  Tracer generalTracer = makeTracer(device, general, pixels);
  Tracer specializedTracer = makeTracer(device, specialized, pixels);
  Tracer storageTracer = makeTracer(device, inStorage, pixels);
  for (Tracer* tracer : {&generalTracer, &specializedTracer, &storageTracer}) {
    for (int i = 0; i < 2; ++i) trace(*tracer, pixels);  // in which it finds the size of its dispatches
  }
  const std::vector<Timing> pictures = measure({{"general", [&] { trace(generalTracer, pixels); }},
                                                {"specialized", [&] { trace(specializedTracer, pixels); }},
                                                {"storage", [&] { trace(storageTracer, pixels); }}},
                                               rounds);
  std::cout << std::left << std::setw(24) << scene.file.filename().string() << std::right << std::fixed;
  for (const double value : {1e3 * minimum(cold[0].wall), 1e3 * minimum(cold[1].wall),
                             1e3 * minimum(pictures[0].cpu), 1e3 * minimum(pictures[1].cpu)}) {
    std::cout << std::setprecision(1) << std::setw(10) << value;
  }
  std::cout << std::setprecision(2) << std::setw(10) << minimum(cold[1].wall) / minimum(cold[0].wall)
            << std::setw(10) << minimum(pictures[1].cpu) / minimum(pictures[0].cpu) << std::setw(12)
            << minimum(pictures[2].cpu) / minimum(pictures[1].cpu) << std::endl;
}

ExitCode run(std::span<const char* const> arguments) {
  int rounds = 0;
  const std::string text = arguments.size() < 4 ? "" : arguments[1];
  std::from_chars(text.data(), text.data() + text.size(), rounds);
  if (rounds < 1) throw Error(ExitCode::kUsage, kUsage);
  const vulkan::Instance instance;
  vulkan::Device device(vulkan::chooseDevice(instance, arguments[2]));
  std::cout << "device " << device.description().name << ", least of " << rounds << " rounds, " << kColdRounds
            << " of the first pixel\n"
            << std::left << std::setw(24) << "" << std::right
            << "  first pixel, wall ms    picture, CPU ms     specialized / general     storage /\n"
            << std::setw(24) << ""
            << "   general  special.   general  special.    first   picture  texels\n";
  for (const char* scene : arguments.subspan(3)) measureScene(device, scene, rounds);
  return ExitCode::kSuccess;
}

}  // namespace
}  // namespace lavaray::bench

int main(int argc, char** argv) {
  return lavaray::runProgram("bench-pipelines", [&] {
    return lavaray::guarded([&] {
      return static_cast<int>(lavaray::bench::run({argv, static_cast<std::size_t>(argc)}));
    });
  });
}
