// lavaray-diff: compares two images.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/file_claims.hpp"
#include "base/output_file.hpp"
#include "base/parallel.hpp"
#include "base/text_location.hpp"
#include "command_line/program.hpp"
#include "command_line/usage.hpp"
#include "command_line/version.hpp"
#include "image/difference.hpp"
#include "image/image_reader.hpp"
#include "image/image_writer.hpp"
#include "image/mean_flip.hpp"

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

// Nothing if the command line asked for help or the version, which have been printed then.
std::optional<DiffOptions> parseDiffOptions(int argc, const char* const* argv) {
  DiffOptions options;
  CLI::App app("Compares two images, or says what one is.", "lavaray-diff");
  app.set_version_flag("--version", std::string("lavaray-diff ") + kVersion);
  app.footer(
      "An image is what its bytes say, whatever its ending. An image without alpha is opaque; FLIP sees\n"
      "alpha over black and over white, and the larger counts. Where one image has floats c and the\n"
      "other integers up to M, they are compared as trunc(M c), which is what lavaray writes. Infinity\n"
      "or NaN in one image alone is beyond every limit and magenta in the picture; the same in both is\n"
      "equal. Figures are over the pixels that are finite in both.\n"
      "\n"
      "Without a limit, images that differ at all exit with 10. Exit codes: 0 alike, 1 internal error,\n"
      "2 usage, 3 an image cannot be read, 5 output not written, 6 not enough memory, 10 the images differ.");
  app.add_option("IMAGE", options.image, "Image to look at (.bmp, .png, .ppm, .pgm, .pbm, .pfm, .exr)")
      ->required();
  app.add_option("REFERENCE", options.reference, "Image to compare it with");
  app.add_option("--tolerance", options.tolerance, "A channel off by at most T/255 does not differ")
      ->type_name("T")
      ->check(numberFrom(0.0));
  app.add_option("--max-differing", options.maxDiffering, "Allow N differing pixels")
      ->type_name("N")
      ->check(integerFrom(0));
  app.add_option("--max-rmse", options.maxRmse,
                 "Allow a root-mean-square error of E (colours in 0..1), of alpha, too")
      ->type_name("E")
      ->check(numberFrom(0.0));
  app.add_option("--max-flip", options.maxFlip, "Allow a mean FLIP (perceived difference, 0..1) of F")
      ->type_name("F")
      ->check(numberFrom(0.0));
  app.add_option("-o,--output", options.output,
                 "Picture of the difference to write (.bmp, .png, .ppm, .pfm, .exr), the largest as 1, "
                 "alpha's as grey")
      ->type_name("FILE")
      ->check(fileName());
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

// Only limits that are given count; if there are none, no pixel may differ. Infinity or NaN in just one of
// the images exceeds every limit.
bool withinLimits(const DiffOptions& options, const Difference& difference, double flip) {
  if (difference.unlike > 0) return false;
  const bool pixelsCount = options.tolerance || options.maxDiffering || !(options.maxRmse || options.maxFlip);
  if (pixelsCount && difference.differing > options.maxDiffering.value_or(0)) return false;
  const double rmse = std::max(difference.color.rmse, difference.alpha.rmse);
  if (options.maxRmse && !(rmse <= *options.maxRmse)) return false;
  return !options.maxFlip || flip <= *options.maxFlip;
}

std::string position(int x, int y) {
  return std::to_string(x) + "," + std::to_string(y);
}

void printNotes(const char* name, const Image& image) {
  for (const std::string& note : image.source.notes)
    std::cout << "note         " << name << ' ' << note << '\n';
}

bool holdsFloats(const Image& image) {
  return image.source.maxima[0] == 0;
}

// trunc(255 c), or several of these if the channels have different maxima.
std::string truncation(const Image& integers) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string one = "trunc(" + std::to_string(integers.source.maxima[i]) + " c)";
    if (text.find(one) == std::string::npos) text += (text.empty() ? "" : ", ") + one;
  }
  return text;
}

// Does nothing unless one image has floats and the other integers.
void compareAsWritten(Image& image, Image& reference) {
  if (holdsFloats(image) == holdsFloats(reference)) return;
  const bool isImage = holdsFloats(image);
  Image& floats = isImage ? image : reference;
  const Image& integers = isImage ? reference : image;
  std::cout << "compared as  " << truncation(integers) << ": the floats c of "
            << (isImage ? "IMAGE" : "REFERENCE") << " as a file like the other would hold them\n";
  floats = asWritten(floats, integers);
  floats.source.maxima = integers.source.maxima;
}

void printDifference(const Difference& difference, double flip) {
  const ChannelDifference& color = difference.color;
  std::cout << "differing    " << difference.differing << " of " << difference.pixels << " pixels\n"
            << "largest      " << color.largest * 255.0 << " / 255 at " << position(color.x, color.y) << '\n'
            << "RMSE         " << color.rmse << '\n'
            << "PSNR         " << color.psnr() << " dB\n"
            << "mean FLIP    " << flip << '\n';
}

void printAlpha(const Image& image, const Image& reference, const ChannelDifference& alpha) {
  if (image.alpha.empty() && reference.alpha.empty()) return;
  std::cout << "alpha        " << alpha.differing << " pixels differ, largest " << alpha.largest * 255.0
            << " / 255 at " << position(alpha.x, alpha.y) << ", RMSE " << alpha.rmse;
  if (image.alpha.empty()) std::cout << "; IMAGE has none, which is 1";
  if (reference.alpha.empty()) std::cout << "; REFERENCE has none, which is 1";
  std::cout << '\n';
}

void printNotFinite(const Difference& difference) {
  const std::size_t notFinite = difference.pixels - difference.finite;
  if (notFinite == 0) return;
  std::cout << "not finite   " << difference.unlike << " pixels differ by infinity or NaN";
  if (difference.unlike > 0)
    std::cout << ", the first at " << position(difference.unlikeX, difference.unlikeY);
  std::cout << "; " << notFinite - difference.unlike << " are the same in both\n"
            << "finite       " << difference.finite
            << " pixels in both images: largest, RMSE, PSNR, mean FLIP and alpha are over these\n";
}

ExitCode diff(const DiffOptions& options) {
  noteRead(options.image, "the image");
  noteRead(options.reference, "the image");
  const OutputName output{"--output", options.output};
  if (!options.output.empty()) checkOutputs({&output, 1});
  Image image = readImage(options.image);
  Image reference = readImage(options.reference);
  std::cout << "size         " << image.width << " x " << image.height << '\n';
  printNotes("IMAGE", image);
  printNotes("REFERENCE", reference);
  if (image.width != reference.width || image.height != reference.height) {
    std::cout << "reference    " << reference.width << " x " << reference.height << "\n";
    return ExitCode::kImagesDiffer;
  }
  std::optional<OutputFile> picture;  // opened before the work
  if (!options.output.empty()) picture.emplace(output);
  compareAsWritten(image, reference);
  // Each of the two quotients, rounded to a float, is off by at most 2^-24: so a difference of T levels stays
  // within T.
  const double tolerance = options.tolerance.value_or(0.0) / 255.0;
  const Difference difference = compare(image, reference, tolerance > 0.0 ? tolerance + 0x1p-23 : 0.0);
  const double flip = meanFlip(image, reference, hardwareThreads());
  printDifference(difference, flip);
  printAlpha(image, reference, difference.alpha);
  printNotFinite(difference);
  if (picture) {
    writeImage(differencePicture(image, reference), imageFormat(options.output).value(), picture->stream());
    picture->commit();
  }
  return withinLimits(options, difference, flip) ? ExitCode::kSuccess : ExitCode::kImagesDiffer;
}

std::string valuesText(const Image& image) {
  if (holdsFloats(image)) return "floats";
  const auto& maxima = image.source.maxima;
  std::string text = "0 to " + std::to_string(maxima[0]);
  for (std::size_t i = 1; i < 3; ++i) {
    if (maxima[0] != maxima[1] || maxima[0] != maxima[2]) text += ", 0 to " + std::to_string(maxima[i]);
  }
  return text;
}

ExitCode info(const std::string& file) {
  const Image image = readImage(file);
  const auto print = [](const std::string& name, const std::string& value) {
    std::cout << std::left << std::setw(18) << printable(name) << ' ' << printable(value) << '\n';
  };
  print("format", image.source.format);
  print("size", std::to_string(image.width) + " x " + std::to_string(image.height));
  print("values", valuesText(image));
  print("alpha", image.alpha.empty() ? "no" : "yes");
  for (const std::string& note : image.source.notes) print("note", note);
  for (const auto& [keyword, text] : image.source.texts) print(keyword, text);
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
