// lavaray-diff: compares two images.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/program.hpp"
#include "app/usage.hpp"
#include "app/version.hpp"
#include "core/errors.hpp"
#include "core/parallel.hpp"
#include "core/place.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/image_file.hpp"
#include "image/output_file.hpp"

namespace lavaray {
namespace {

struct DiffOptions {
  std::string image;
  std::string reference;
  std::string output;
  bool info = false;
  std::optional<double> tolerance;  // in 1/255
  std::optional<std::size_t> maxDiffering;
  std::optional<double> maxRmse;
  std::optional<double> maxFlip;
};

// Nothing where the command line asked for help or the version, which are printed then.
std::optional<DiffOptions> parseDiffOptions(int argc, const char* const* argv) {
  DiffOptions options;
  CLI::App app("Compares two images, or says what one is.", "lavaray-diff");
  app.set_version_flag("--version", std::string("lavaray-diff ") + kVersion);
  app.footer(
      "Without a limit, images that differ at all exit with 10. Exit codes: 0 alike, 1 internal error,\n"
      "2 usage, 3 an image cannot be read, 5 output not written, 6 not enough memory, 10 the images differ.");
  app.add_option("IMAGE", options.image, "Image to look at (.bmp, .png, .ppm, .pfm)")->required();
  app.add_option("REFERENCE", options.reference, "Image to compare it with");
  app.add_option("--tolerance", options.tolerance, "A channel off by at most T/255 does not differ")
      ->type_name("T")
      ->check(numberFrom(0.0));
  app.add_option("--max-differing", options.maxDiffering, "Allow N differing pixels")
      ->type_name("N")
      ->check(integerFrom(0));
  app.add_option("--max-rmse", options.maxRmse, "Allow a root-mean-square error of E (colours in 0..1)")
      ->type_name("E")
      ->check(numberFrom(0.0));
  app.add_option("--max-flip", options.maxFlip, "Allow a mean FLIP (perceived difference, 0..1) of F")
      ->type_name("F")
      ->check(numberFrom(0.0));
  app.add_option("-o,--output", options.output,
                 "Picture of the difference to write (.bmp, .png, .ppm, .pfm), the largest as 1")
      ->type_name("FILE");
  CLI::Option* info = app.add_flag("--info", options.info, "Print size, format and texts of IMAGE alone");
  for (const char* other :
       {"REFERENCE", "--tolerance", "--max-differing", "--max-rmse", "--max-flip", "--output"}) {
    info->excludes(app.get_option(other));
  }
  if (!parseCommandLine(app, argc, argv)) return std::nullopt;
  if (options.reference.empty() && !options.info) {
    throw Error(ExitCode::kUsage, "REFERENCE is missing; lavaray-diff --help lists the options");
  }
  if (!options.output.empty() && !imageFormat(options.output)) {
    throw Error(ExitCode::kUsage, "--output " + options.output +
                                      ": its ending says no image format; allowed are " + kImageFormatNames);
  }
  return options;
}

// A limit that is not given does not count; without any, no pixel may differ.
bool withinLimits(const DiffOptions& options, const Difference& difference, double flip) {
  const bool pixelsCount = options.tolerance || options.maxDiffering || !(options.maxRmse || options.maxFlip);
  if (pixelsCount && difference.differing > options.maxDiffering.value_or(0)) return false;
  if (options.maxRmse && !(difference.rmse <= *options.maxRmse)) return false;
  return !options.maxFlip || flip <= *options.maxFlip;
}

// FLIP looks at what a display shows: of a file of floats what an 8-bit file of the same values would hold.
Image displayedFile(const std::string& file, const Image& image) {
  return imageFormat(file) == ImageFormat::kPfm ? asDisplayed(image) : image;
}

ExitCode diff(const DiffOptions& options) {
  const Image image = readImage(options.image);
  const Image reference = readImage(options.reference);
  std::cout << "size         " << image.width << " x " << image.height << '\n';
  if (image.width != reference.width || image.height != reference.height) {
    std::cout << "reference    " << reference.width << " x " << reference.height << "\n";
    return ExitCode::kImagesDiffer;
  }
  // Half a percent of a level, so that a difference of T levels, a rounded quotient of 255, is within T.
  const double tolerance = (options.tolerance.value_or(0.0) + (options.tolerance ? 0.005 : 0.0)) / 255.0;
  const Difference difference = compare(image, reference, tolerance);
  const double flip = meanFlip(displayedFile(options.image, image),
                               displayedFile(options.reference, reference), hardwareThreads());
  std::cout << "differing    " << difference.differing << " of " << difference.pixels << " pixels\n"
            << "largest      " << difference.largest * 255.0 << " / 255 at " << difference.x << ","
            << difference.y << '\n'
            << "RMSE         " << difference.rmse << '\n'
            << "PSNR         " << difference.psnr() << " dB\n"
            << "mean FLIP    " << flip << '\n';
  if (!options.output.empty()) {
    OutputFile file(options.output);
    writeImage(differencePicture(image, reference), imageFormat(options.output).value(), file.stream());
    file.commit();
  }
  return withinLimits(options, difference, flip) ? ExitCode::kSuccess : ExitCode::kImagesDiffer;
}

ExitCode info(const std::string& file) {
  const Image image = readImage(file);  // of each format, and so that a damaged file is found out
  const ImageFormat format = imageFormat(file).value();
  const auto print = [](const std::string& name, const std::string& value) {
    std::cout << std::left << std::setw(18) << printable(name) << ' ' << printable(value) << '\n';
  };
  print("format", formatName(format));
  print("size", std::to_string(image.width) + " x " + std::to_string(image.height));
  if (format != ImageFormat::kPng) return ExitCode::kSuccess;
  for (const auto& [keyword, text] : readPngTexts(file)) print(keyword, text);
  return ExitCode::kSuccess;
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray-diff", [&] {
    const auto options = lavaray::parseDiffOptions(argc, argv);
    if (!options) return lavaray::ExitCode::kSuccess;
    return options->info ? lavaray::info(options->image) : lavaray::diff(*options);
  });
}
