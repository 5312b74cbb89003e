#include "lavaray/options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "command_line/usage.hpp"
#include "command_line/version.hpp"
#include "image/image_format.hpp"
#include "lavaray/layers.hpp"

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
  app.add_option("--width", options.width, "Width in pixels of the same view; without --height by its aspect")
      ->type_name("W")
      ->check(side);
  app.add_option("--height", options.height,
                 "Height in pixels of the same view; without --width by its aspect")
      ->type_name("H")
      ->check(side);
  addCropOption(app, options.crop, "Render only the pixels X0 <= x < X1, Y0 <= y < Y1, y from the top");
  app.add_flag("--normalize", options.normalize, "Stretch the values so that the largest is 1");
}

// Throws Error(kUsage) where the text is no range.
SampleRange sampleRange(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string parts[] = {text.substr(0, colon), colon < text.size() ? text.substr(colon + 1) : ""};
  std::uint32_t numbers[2];
  for (int i = 0; i < 2; ++i) {
    if (!CLI::detail::lexical_cast(parts[i], numbers[i])) {
      throw Error(ExitCode::kUsage,
                  "--sample-range " + text + " is no range, allowed is A:B, the samples A <= i < B");
    }
  }
  return {numbers[0], numbers[1]};
}

void checkSampleRange(const Options& options) {
  if (!options.sampleRange) return;
  const auto [first, end] = *options.sampleRange;
  const auto fits = [&](std::uint32_t i) { return i % gpu::kMaxSamplesPerItem == 0 || i == options.samples; };
  // Samples are summed in groups of so many, which a part must not divide: the sum would be rounded
  // otherwise.
  if (options.samples > 1 && first < end && end <= options.samples && fits(first) && fits(end)) return;
  throw Error(ExitCode::kUsage,
              "--sample-range A:B must have 0 <= A < B <= " + std::to_string(options.samples) +
                  ", the samples of --spp, of which 2 or " + "more must be asked for; A and B multiples of " +
                  std::to_string(gpu::kMaxSamplesPerItem) + ", or B all samples");
}

void addSamplingOptions(CLI::App& app, Options& options) {
  CLI::Option* spp = app.add_option("--spp", options.samples, "Samples per pixel; 1 is the pixel's centre")
                         ->type_name("N")
                         ->check(integerFrom(1, kMostSamples))
                         ->capture_default_str();
  app.add_option_function<std::string>(
         "--filter", [&options](const std::string& name) { options.filter = pixelFilter(name).value(); },
         "Pixel filter")
      ->type_name("NAME")
      ->check(
          [](const std::string& name) {
            return pixelFilter(name) ? std::string()
                                     : "there is no filter " + name + ", allowed are " + kPixelFilterNames;
          },
          kPixelFilterNames)
      ->default_str("box");
  app.add_option("--target-error", options.targetError,
                 "Sample until the image's RMSE is estimated to be at most E (colours in 0..1)")
      ->type_name("E")
      ->check(numberFrom(1e-6, 1.0))
      ->excludes(spp);
  app.add_option("--max-spp", options.maxSamples, "Samples per pixel that --target-error may take")
      ->type_name("N")
      ->check(integerFrom(2, kMostSamples))
      ->capture_default_str();
  app.add_option("--time-limit", options.timeLimitSeconds, "Stop sampling after S seconds")
      ->type_name("S")
      ->check(numberFrom(0.0, 1e9));
  app.add_option_function<std::string>(
         "--sample-range", [&options](const std::string& text) { options.sampleRange = sampleRange(text); },
         "Only the samples A <= i < B of the --spp samples of each pixel, for a part to be merged")
      ->type_name("A:B")
      ->needs(spp);
  app.add_option("--seed", options.seed, "Other samples of the same picture")
      ->type_name("N")
      ->check(integerFrom(0, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--sampler",
         [&options](const std::string& name) {
           options.sampler = name == samplerName(Sampler::kRandom) ? Sampler::kRandom : Sampler::kSobol;
         },
         "Sample positions; sobol is Owen-scrambled, random for comparison")
      ->type_name("NAME")
      ->check(
          [](const std::string& name) {
            return name == samplerName(Sampler::kSobol) || name == samplerName(Sampler::kRandom)
                       ? std::string()
                       : "there is no sampler " + name + ", allowed are " + kSamplerNames;
          },
          kSamplerNames)
      ->default_str(samplerName(Sampler::kSobol));
}

void addViewOption(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--view", [&options](const std::string& name) { options.view = viewNamed(name).value(); },
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
      ->default_str("color");
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
  app.add_option("--max-depth", options.maxDepth, "Mirror bounces")
      ->type_name("N")
      ->check(integerFrom(0, 1000))
      ->capture_default_str();
  app.add_option("--reflect", options.reflect, "Materials without `ref` mirror K times their specular colour")
      ->type_name("K")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--light-radius", options.lightRadius, "Lights without `rad` are spheres of radius R")
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

bool isFilm(const std::string& output) {
  return std::filesystem::path(output).extension() == ".film";
}

void checkOutput(const std::string& output) {
  if (output == "-" || imageFormat(output) || isFilm(output)) return;
  throw Error(ExitCode::kUsage, "--output " + output + ": its ending says no image format; allowed are " +
                                    kImageFormatNames + " and .film, or - for PPM to stdout");
}

void checkExr(const Options& options) {
  const bool isExr = imageFormat(options.output) == ImageFormat::kExr;
  if (options.half && !isExr) {
    throw Error(ExitCode::kUsage, "--half is for EXR; give --output the ending .exr");
  }
  if (!options.layers.empty() && !isExr) {
    throw Error(ExitCode::kUsage,
                "--layers writes EXR files beside an EXR picture; give --output the ending .exr");
  }
  const bool hasError = std::ranges::find(options.layers, Layer::kError) != options.layers.end();
  if (hasError && !options.targetError) {
    throw Error(ExitCode::kUsage, "--layers error needs --target-error: without, the error is not estimated");
  }
}

void checkFilms(const Options& options) {
  const bool hasFilm = writesFilm(options) || !options.checkpoint.empty() || !options.resume.empty();
  if (hasFilm && options.view != View::kColor) {
    throw Error(ExitCode::kUsage, "a checkpoint or film is of colours; --view " + viewName(options.view) +
                                      " cannot be kept in one");
  }
  if (writesFilm(options) && options.normalize) {
    throw Error(ExitCode::kUsage, "--normalize is for the whole picture; give it to lavaray-merge");
  }
  if (options.sampleRange && !writesFilm(options)) {
    throw Error(ExitCode::kUsage,
                "--sample-range is for a part of a picture; give --output the ending .film");
  }
  if (options.watch && (hasFilm || options.output == "-")) {
    throw Error(ExitCode::kUsage,
                "--watch writes a picture file again and again; it goes with neither films, "
                "--checkpoint nor --resume, nor with stdout");
  }
}

}  // namespace

std::vector<Options> parseOptions(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> scenes;
  CLI::App app("Renders a scene file with Vulkan.", "lavaray");
  app.set_version_flag("--version", std::string("lavaray ") + kVersion);
  app.footer(
      "Exit codes: 0 fine, 1 internal error, 2 usage, 3 scene, mesh, shader or film, 4 no usable device,\n"
      "5 output not written or no screen for --display, 6 not enough memory, 129, 130 or 143 ended by\n"
      "SIGHUP, SIGINT or SIGTERM; what is rendered by then is written.");
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
  if (!parseCommandLine(app, argc, argv)) return {};
  if (options.listDevices) return {options};
  if (scenes.empty()) throw Error(ExitCode::kUsage, "SCENE is missing; lavaray --help lists the options");
  if (options.view == View::kError && !options.targetError) {
    throw Error(ExitCode::kUsage, "--view error needs --target-error: without, the error is not estimated");
  }
  if (options.targetError && tracedView(options.view) != gpu::kViewColor) {
    throw Error(ExitCode::kUsage, "--target-error is for the views color, samples and error; for view " +
                                      viewName(options.view) + " give --spp");
  }
  const std::vector<Options> all = optionsOfScenes(options, scenes);
  for (const Options& one : all) {
    checkOutput(one.output);
    checkExr(one);
    checkSampleRange(one);
    checkFilms(one);
  }
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
  return isFilm(options.output);
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
