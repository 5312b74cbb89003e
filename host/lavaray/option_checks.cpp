#include "lavaray/option_checks.hpp"

#include <algorithm>
#include <string>

#include "base/errors.hpp"
#include "image/image_format.hpp"

namespace lavaray {
namespace {

void checkOutput(const Options& options) {
  const std::string& output = options.output;
  if (output == "-" || imageFormat(output) || writesFilm(options)) return;
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
  if (hasError && !options.render.targetError) {
    throw Error(ExitCode::kUsage, "--layers error needs --target-error: without, the error is not estimated");
  }
}

void checkFilms(const Options& options) {
  const bool hasFilm = writesFilm(options) || !options.checkpoint.empty() || !options.resume.empty();
  if (hasFilm && options.render.view != View::kColor) {
    throw Error(ExitCode::kUsage, "a checkpoint or film is of colours; --view " +
                                      viewName(options.render.view) + " cannot be kept in one");
  }
  if (writesFilm(options) && options.normalize) {
    throw Error(ExitCode::kUsage, "--normalize is for the whole picture; give it to lavaray-merge");
  }
  if (options.render.range && !writesFilm(options)) {
    throw Error(ExitCode::kUsage,
                "--sample-range is for a part of a picture; give --output the ending .film");
  }
  if (options.watch && (hasFilm || options.output == "-")) {
    throw Error(ExitCode::kUsage,
                "--watch writes a picture file again and again; it goes with neither films, "
                "--checkpoint nor --resume, nor with stdout");
  }
}

void checkSampleRange(const Options& options) {
  if (!options.render.range) return;
  const auto [first, end] = *options.render.range;
  const auto fits = [&](std::uint32_t i) {
    return i % gpu::kMaxSamplesPerItem == 0 || i == options.render.samples;
  };
  // Samples are summed in groups of so many. A part must not split one, or the sum would be rounded
  // differently.
  if (options.render.samples > 1 && first < end && end <= options.render.samples && fits(first) && fits(end))
    return;
  throw Error(ExitCode::kUsage,
              "--sample-range A:B must have 0 <= A < B <= " + std::to_string(options.render.samples) +
                  ", the samples of --spp, of which 2 or " + "more must be asked for; A and B multiples of " +
                  std::to_string(gpu::kMaxSamplesPerItem) + ", or B all samples");
}

}  // namespace

void checkViewAndError(const Options& options) {
  const RenderSettings& render = options.render;
  if (render.view == View::kError && !render.targetError) {
    throw Error(ExitCode::kUsage, "--view error needs --target-error: without, the error is not estimated");
  }
  if (render.targetError && tracedView(render.view) != gpu::kViewColor) {
    throw Error(ExitCode::kUsage, "--target-error is for the views color, samples and error; for view " +
                                      viewName(render.view) + " give --spp");
  }
}

void checkOptions(const Options& options) {
  checkOutput(options);
  checkExr(options);
  checkSampleRange(options);
  checkFilms(options);
}

}  // namespace lavaray
