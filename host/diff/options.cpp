#include "diff/options.hpp"

#include <lavaray/image.h>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "command_line/usage.hpp"
#include "command_line/version.hpp"

namespace lavaray {
namespace {

void addLimits(CLI::App& app, DifferenceLimits& limits) {
  app.add_option("--tolerance", limits.tolerance, "A channel off by at most T/255 does not differ")
      ->type_name("T")
      ->check(numberFrom(0.0));
  app.add_option("--max-differing", limits.maxDiffering, "Allow N differing pixels")
      ->type_name("N")
      ->check(integerFrom(0));
  app.add_option("--max-rmse", limits.maxRmse,
                 "Allow a root-mean-square error of E (colours in 0..1), of alpha, too")
      ->type_name("E")
      ->check(numberFrom(0.0));
  app.add_option("--max-flip", limits.maxFlip, "Allow a mean FLIP (perceived difference, 0..1) of F")
      ->type_name("F")
      ->check(numberFrom(0.0));
}

void addOutputs(CLI::App& app, DiffOptions& options) {
  app.add_option("-o,--output", options.output,
                 "Picture of the difference to write (.bmp, .png, .ppm, .pfm, .exr), the largest as 1, "
                 "alpha's as grey")
      ->type_name("FILE")
      ->check(fileName());
  app.add_option("--report", options.report,
                 "Page to write that shows the pictures, their difference and FLIP in any browser (.html)")
      ->type_name("FILE")
      ->check(fileName());
  app.add_option("--json", options.json, "Write what is found as JSON")->type_name("FILE")->check(fileName());
  app.add_option("--name", options.name, "What the pair is called there; default: IMAGE's name")
      ->type_name("TEXT");
  app.add_option("--driver", options.driver,
                 "What rendered IMAGE, to be told there; default: what its file says")
      ->type_name("TEXT");
  app.add_option("--from", options.from,
                 "Compare anew the pairs in files that --json wrote, each with its limits")
      ->type_name("FILE")
      ->check(fileName());
}

[[noreturn]] void failUsage(const std::string& why) {
  throw Error(ErrorKind::kUsage, why);
}

void check(const DiffOptions& options) {
  const auto missing = [](const std::string& name) {
    failUsage(name + " is missing; lavaray-diff --help lists the options");
  };
  if (options.from.empty() && options.image.empty()) missing("IMAGE");
  if (options.from.empty() && options.reference.empty() && !options.info) missing("REFERENCE");
  if (!options.output.empty() && !imageFormat(options.output)) {
    failUsage("--output " + options.output + ": its ending says no image format; allowed are " +
              kImageFormatNames);
  }
  const bool areFolders = std::filesystem::is_directory(options.image);
  if (options.info || !options.from.empty()) return;
  if (areFolders != std::filesystem::is_directory(options.reference)) {
    failUsage("IMAGE and REFERENCE must both be images or both be folders; only " +
              (areFolders ? options.image : options.reference) + " is a folder");
  }
  if (areFolders && !(options.output.empty() && options.name.empty())) {
    failUsage((options.output.empty() ? "--name" : "--output") +
              std::string(" is for two images, not for folders"));
  }
}

}  // namespace

std::optional<DiffOptions> parseDiffOptions(int argc, const char* const* argv) {
  DiffOptions options;
  CLI::App app("Compares two images or two folders of images, or says what an image is.", "lavaray-diff");
  app.set_version_flag("--version", std::string("lavaray-diff ") + kVersion);
  app.footer(
      "An image is what its bytes say, whatever its ending. An image without alpha is opaque; FLIP sees\n"
      "alpha over black and over white, and the larger counts. Where one image has floats c and the\n"
      "other integers up to M, they are compared as trunc(M c), which is what lavaray writes. Infinity\n"
      "or NaN in one image alone is beyond every limit and magenta in the picture; the same in both is\n"
      "equal. Figures are over the pixels that are finite in both. Images in two folders, and in those\n"
      "inside of them, are pairs if their names are the same, or differ in the ending alone; an image\n"
      "without a partner differs.\n"
      "\n"
      "Without a limit, images that differ at all exit with 10. Exit codes: 0 alike, 1 internal error,\n"
      "2 usage, 3 an image cannot be read, 5 output not written, 6 not enough memory, 10 the images differ.");
  app.add_option("IMAGE", options.image,
                 "Image to look at (.bmp, .png, .ppm, .pgm, .pbm, .pfm, .exr), or a folder of such");
  app.add_option("REFERENCE", options.reference, "Image, or folder, to compare it with");
  addLimits(app, options.limits);
  addOutputs(app, options);
  CLI::Option* info = app.add_flag("--info", options.info, "Print size, format and texts of IMAGE alone");
  const auto exclude = [&app](CLI::Option* option, std::initializer_list<const char*> others) {
    for (const char* other : others) option->excludes(app.get_option(other));
  };
  exclude(info, {"REFERENCE", "--tolerance", "--max-differing", "--max-rmse", "--max-flip", "--output",
                 "--report", "--json", "--name", "--driver", "--from"});
  exclude(app.get_option("--from"), {"IMAGE", "--tolerance", "--max-differing", "--max-rmse", "--max-flip",
                                     "--output", "--name", "--driver"});
  if (!parseCommandLine(app, argc, argv)) return std::nullopt;
  check(options);
  return options;
}

}  // namespace lavaray
