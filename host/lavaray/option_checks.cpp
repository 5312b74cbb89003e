#include "lavaray/option_checks.hpp"

#include <algorithm>
#include <string>

namespace lavaray {
namespace {

void checkOutput(const Options& options) {
  const std::string& output = options.output;
  if (output == "-" || imageFormat(output) || writesFilm(options)) return;
  throw Error(ErrorKind::kUsage, "--output " + output + ": its ending says no image format; allowed are " +
                                     kImageFormatNames + " and .film, or - for PPM to stdout");
}

void checkExr(const Options& options) {
  const bool isExr = imageFormat(options.output) == ImageFormat::kExr;
  if (options.half && !isExr) {
    throw Error(ErrorKind::kUsage, "--half is for EXR; give --output the ending .exr");
  }
  if (!options.layers.empty() && !isExr) {
    throw Error(ErrorKind::kUsage,
                "--layers writes EXR files beside an EXR picture; give --output the ending .exr");
  }
  const bool hasError = std::ranges::find(options.layers, Layer::kError) != options.layers.end();
  if (hasError && !options.render.targetError) {
    throw Error(ErrorKind::kUsage,
                "--layers error needs --target-error: without, the error is not estimated");
  }
}

void checkFilms(const Options& options) {
  if (writesFilm(options) && options.render.normalize) {
    throw Error(ErrorKind::kUsage, "--normalize is for the whole picture; give it to lavaray-merge");
  }
  if (options.render.range && !writesFilm(options)) {
    throw Error(ErrorKind::kUsage,
                "--sample-range is for a part of a picture; give --output the ending .film");
  }
  if (options.watch && (options.render.keepsFilm || options.output == "-")) {
    throw Error(ErrorKind::kUsage,
                "--watch writes a picture file again and again; it goes with neither films, "
                "--checkpoint nor --resume, nor with stdout");
  }
}

}  // namespace

void checkOptions(const Options& options) {
  checkOptions(options.render);
  checkOutput(options);
  checkExr(options);
  checkFilms(options);
}

}  // namespace lavaray
