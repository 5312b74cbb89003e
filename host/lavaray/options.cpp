#include "lavaray/options.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "command_line/usage.hpp"
#include "command_line/version.hpp"
#include "lavaray/layers.hpp"
#include "lavaray/option_checks.hpp"
#include "lavaray/option_table.hpp"

namespace lavaray {

std::vector<Options> parseOptions(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> scenes;
  CLI::App app("Renders a scene file with Vulkan.", "lavaray");
  app.set_version_flag("--version", std::string("lavaray ") + kVersion);
  app.footer(
      "Exit codes: 0 fine, 1 internal error, 2 usage, 3 scene, mesh, shader or film, 4 no usable device,\n"
      "5 output not written or no screen for --display, 6 not enough memory, 129, 130 or 143 ended by\n"
      "SIGHUP, SIGINT or SIGTERM; what is rendered by then is written.");
  addOptions(app, options, scenes);
  if (!parseCommandLine(app, argc, argv)) return {};
  if (options.listDevices) return {options};
  if (scenes.empty()) throw Error(ExitCode::kUsage, "SCENE is missing; lavaray --help lists the options");
  checkViewAndError(options);
  std::vector<Options> all = optionsOfScenes(options, scenes);
  for (const Options& one : all) checkOptions(one);
  return all;
}

std::vector<OutputName> outputNames(const Options& options) {
  std::vector<OutputName> names;
  if (!options.check && options.output != "-") names.push_back({"--output", options.output});
  for (const Layer layer : options.layers) {
    if (!options.check) names.push_back(layerOutput(options, layer));
  }
  if (!options.json.empty()) names.push_back({"--json", options.json});
  if (!options.check && !options.checkpoint.empty()) names.push_back(checkpointName(options));
  return names;
}

OutputName checkpointName(const Options& options) {
  return {"--checkpoint", options.checkpoint, options.resume};
}

bool writesFilm(const Options& options) {
  return std::filesystem::path(options.output).extension() == ".film";
}

std::optional<double> defaultTargetError(const Options& options, const Scene& scene) {
  constexpr double kTargetError = 0.01;
  const RenderSettings& render = options.render;
  const bool isStated = options.statesSamples || render.targetError;
  const bool hasSphere =
      std::ranges::any_of(scene.lights, [](const Light& light) { return light.radius > 0.0; });
  if (isStated || !hasSphere || tracedView(render.view) != gpu::kViewColor) return std::nullopt;
  return kTargetError;
}

void applyDefaults(const Options& options, Scene& scene) {
  for (Material& material : scene.materials) {
    if (!material.statesReflectance) material.reflectance = options.reflect * material.specular;
  }
  for (Light& light : scene.lights) {
    if (!light.statesRadius) light.radius = options.lightRadius;
  }
}

ImageSize outputSize(const Options& options, const ImageSize& cameraSize) {
  const double aspect = static_cast<double>(cameraSize.width) / cameraSize.height;
  ImageSize size = cameraSize;
  if (options.width) size.width = *options.width;
  if (options.height) size.height = *options.height;
  const auto rounded = [](double pixels) { return std::max(1, static_cast<int>(std::lround(pixels))); };
  if (options.width && !options.height) size.height = rounded(size.width / aspect);
  if (options.height && !options.width) size.width = rounded(size.height * aspect);
  if (size.width > kMaxImageSide || size.height > kMaxImageSide) {
    throw Error(ExitCode::kUsage, "an image of " + std::to_string(size.width) + " x " +
                                      std::to_string(size.height) + " pixels; each side may have 1 to " +
                                      std::to_string(kMaxImageSide));
  }
  return size;
}

}  // namespace lavaray
