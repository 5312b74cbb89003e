#include "lavaray/option_table.hpp"

#include <cstdint>
#include <limits>

#include "command_line/usage.hpp"

namespace lavaray {
namespace {

void addRenderOptions(CLI::App& app, Options& options) {
  app.add_option("-o,--output", options.output,
                 "Image to write; its ending says the format: .bmp, .png or .ppm (8 bits a channel), .pfm "
                 "(float), .exr (linear light, float) or .film (a part for lavaray-merge). '-' writes PPM to "
                 "stdout. Default: SCENE's name "
                 "with .bmp, in the current folder. {} stands for SCENE's name without its folder and ending "
                 "('stdin' "
                 "where that is -), and must be in it where there are several")
      ->type_name("FILE")
      ->check(fileName());
  const CLI::Validator side = integerFrom(1, kMaxImageSide);
  app.add_option("--width", options.render.width,
                 "Width in pixels of the same view; without --height by its aspect")
      ->type_name("W")
      ->check(side);
  app.add_option("--height", options.render.height,
                 "Height in pixels of the same view; without --width by its aspect")
      ->type_name("H")
      ->check(side);
  addCropOption(app, options.render.crop,
                "Render only the pixels X0 <= x < X1, Y0 <= y < Y1, y from the top");
  app.add_flag("--normalize", options.render.normalize, "Stretch the values so that the largest is 1");
}

// Throws Error(kUsage) if the text is no range.
SampleRange sampleRange(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string parts[] = {text.substr(0, colon), colon < text.size() ? text.substr(colon + 1) : ""};
  std::uint32_t numbers[2];
  for (int i = 0; i < 2; ++i) {
    if (!CLI::detail::lexical_cast(parts[i], numbers[i])) {
      throw Error(ErrorKind::kUsage,
                  "--sample-range " + text + " is no range, allowed is A:B, the samples A <= i < B");
    }
  }
  return {numbers[0], numbers[1]};
}

void addFilterOption(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--filter",
         [&options](const std::string& name) { options.render.filter = filterNamed(name).value(); },
         "Pixel filter")
      ->type_name("NAME")
      ->check(
          [](const std::string& name) {
            return filterNamed(name) ? std::string()
                                     : "there is no filter " + name + ", allowed are " + kPixelFilterNames;
          },
          kPixelFilterNames)
      ->default_str(name(options.render.filter));
}

void addSamplerOption(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--sampler",
         [&options](const std::string& name) { options.render.sampler = samplerNamed(name).value(); },
         "Sample positions; sobol is Owen-scrambled, random for comparison")
      ->type_name("NAME")
      ->check(
          [](const std::string& name) {
            return samplerNamed(name) ? std::string()
                                      : "there is no sampler " + name + ", allowed are " + kSamplerNames;
          },
          kSamplerNames)
      ->default_str(name(options.render.sampler));
}

void addSamplingOptions(CLI::App& app, Options& options) {
  CLI::Option* spp =
      app.add_option("--spp", options.render.samples,
                     "Samples per pixel; 1 is the pixel's centre. Where a light has a radius, the default is "
                     "--target-error 0.01 for the views of colours")
          ->type_name("N")
          ->each([&options](const std::string& /*text*/) { options.statesSamples = true; })
          ->check(integerFrom(1, kMaxSamplesPerPixel))
          ->capture_default_str();
  addFilterOption(app, options);
  app.add_option("--target-error", options.render.targetError,
                 "Sample until the image's RMSE is estimated to be at most E (colours in 0..1)")
      ->type_name("E")
      ->check(numberFrom(1e-6, 1.0))
      ->excludes(spp);
  app.add_option("--max-spp", options.render.maxSamples, "Samples per pixel that --target-error may take")
      ->type_name("N")
      ->check(integerFrom(2, kMaxSamplesPerPixel))
      ->capture_default_str();
  app.add_option("--time-limit", options.render.timeLimitSeconds, "Stop sampling after S seconds")
      ->type_name("S")
      ->check(numberFrom(0.0, 1e9));
  app.add_option_function<std::string>(
         "--sample-range", [&options](const std::string& text) { options.render.range = sampleRange(text); },
         "Only the samples A <= i < B of the --spp samples of each pixel, for a part to be merged")
      ->type_name("A:B")
      ->needs(spp);
  app.add_option("--seed", options.render.seed, "Other samples of the same picture")
      ->type_name("N")
      ->check(integerFrom(0, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str();
  addSamplerOption(app, options);
}

void addViewOption(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--view", [&options](const std::string& name) { options.render.view = viewNamed(name).value(); },
         "What the image shows; depth is in proportion to the largest, shadow the share of the lights that "
         "are not blocked, cost (nodes and primitives that a sample's rays test) and samples in proportion "
         "to the most, error as estimated, in units of a colour, with --target-error")
      ->type_name("NAME")
      ->check(
          [](const std::string& name) {
            return viewNamed(name) ? std::string()
                                   : "there is no view " + name + ", allowed are " + kViewNames;
          },
          kViewNames)
      ->default_str(name(options.render.view));
}

void addExrOptions(CLI::App& app, Options& options) {
  app.add_flag("--half", options.half, "Write the colours of an EXR file in 16 bits in place of 32");
  app.add_option_function<std::string>(
         "--layers", [&options](const std::string& names) { options.layers = layersNamed(names); },
         "Beside the EXR file OUT write OUT.NAME.exr for each NAME, parted by commas: numbers in 32 bits. "
         "normal "
         "(-1 to 1), depth (distance along the ray) and object (its number) are of the pixel's centre, "
         "samples "
         "(how many) and error (as estimated, with --target-error) of the picture")
      ->type_name("NAMES")
      ->check(CLI::Validator([](const std::string& /*names*/) { return std::string(); }, kLayerNames));
}

void addSceneOptions(CLI::App& app, Options& options) {
  app.add_option("--max-depth", options.render.maxDepth, "Mirror bounces")
      ->type_name("N")
      ->check(integerFrom(0, kMaxMirrorBounces))
      ->capture_default_str();
  app.add_option("--reflect", options.defaults.reflect,
                 "Materials without `ref` mirror K times their specular colour")
      ->type_name("K")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--light-radius", options.defaults.lightRadius,
                 "Lights without `rad` are spheres of radius R")
      ->type_name("R")
      ->check(numberFrom(0.0, kMaxMagnitude))
      ->capture_default_str();
}

void addFilmOptions(CLI::App& app, Options& options) {
  CLI::Option* checkpoint = app.add_option("--checkpoint", options.checkpoint,
                                           "Keep in FILE what is rendered so far, to be resumed from")
                                ->type_name("FILE")
                                ->check(fileNameNotStdout());
  app.add_option("--checkpoint-every", options.checkpointSeconds, "Seconds from one checkpoint to the next")
      ->type_name("S")
      ->check(numberFrom(0.0, 1e9))
      ->capture_default_str()
      ->needs(checkpoint);
  app.add_option("--resume", options.resume,
                 "Go on from the checkpoint FILE of the same picture; bit for bit as if never stopped")
      ->type_name("FILE")
      ->check(fileName());
}

void addInteractiveOptions(CLI::App& app, Options& options) {
  app.add_flag("--display", options.display,
               "Show the picture in a window while it grows; closes on Esc, q or its button");
  app.add_flag("--watch", options.watch,
               "Render again whenever the scene, its meshes or a shader of --shaders changes");
  app.add_option("--shaders", options.shaders, "Compile the shaders in DIR in place of those in the program")
      ->type_name("DIR")
      ->check(fileName());
}

void addOtherOptions(CLI::App& app, Options& options) {
  app.add_option(
         "--device", options.device,
         "Vulkan device, by number or part of its name. Default: the best one (discrete, integrated, CPU)")
      ->type_name("N or NAME");
  app.add_option(
         "--tuning", options.tuning,
         "How the device reads a scene that is searched, and how many rays an invocation traces together at "
         "most, which changes no bit of a picture: auto takes what was measured on the device before, and "
         "measures it before a long render; measure does so now. The variable LAVARAY_TUNING says the same")
      ->type_name("WAY")
      ->envname("LAVARAY_TUNING")
      ->check(
          [](const std::string& text) {
            return isTuningWay(text) ? std::string()
                                     : "there is no tuning " + text + ", allowed are " + kTuningWays;
          },
          kTuningWays)
      ->capture_default_str();
  app.add_flag("--list-devices", options.listDevices, "List the Vulkan devices and exit");
  app.add_flag("--check", options.check,
               "Read the scene and its meshes, say what is in them, render nothing");
  app.add_flag("--stats", options.stats, "Say where time and memory went, and what was done");
  app.add_option("--json", options.json,
                 "Write what --stats says to FILE, as JSON; with --check what that says, and the picture's "
                 "size. {} in it "
                 "is as for --output. JSON does not go to stdout: '-' is refused")
      ->type_name("FILE")
      ->check(fileNameNotStdout());
  app.add_flag("--validate", options.validate,
               "Run under the Khronos validation layer; its messages make the exit code 1");
  CLI::Option* quiet = app.add_flag("-q,--quiet", options.quiet, "Print nothing but warnings and errors");
  app.add_flag("-v,--verbose", options.verbose, "Say what is done")->excludes(quiet);
}

}  // namespace

void addOptions(CLI::App& app, Options& options, std::vector<std::string>& scenes) {
  app.add_option(
      "SCENE", scenes,
      "Scene file to render; '-' is standard input, whose meshes are looked for in the current folder. "
      "Several are rendered one after the other, by one process on one device");
  addRenderOptions(app, options);
  addSamplingOptions(app, options);
  addViewOption(app, options);
  addExrOptions(app, options);
  addSceneOptions(app, options);
  addFilmOptions(app, options);
  addInteractiveOptions(app, options);
  addOtherOptions(app, options);
}

}  // namespace lavaray
