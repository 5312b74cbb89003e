#include <lavaray/image.h>
#include <sys/resource.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "command_line/program.hpp"
#include "command_line/progress.hpp"
#include "command_line/usage.hpp"
#include "command_line/version.hpp"

namespace lavaray {
namespace {

struct MergeOptions {
  std::vector<std::filesystem::path> parts;
  std::string output;
  std::optional<Rectangle> crop;
  bool normalize = false;
  bool half = false;
  bool check = false;
  bool quiet = false;
};

std::optional<MergeOptions> parseMergeOptions(int argc, const char* const* argv) {
  MergeOptions options;
  CLI::App app("Merges the parts of a picture that lavaray rendered with --output PART.film.",
               "lavaray-merge");
  app.set_version_flag("--version", std::string("lavaray-merge ") + kVersion);
  app.footer(
      "Exit codes: 0 fine, 2 usage, 3 parts that are damaged, foreign or missing, 5 output not written,\n"
      "6 not enough memory.");
  app.add_option("PARTS", options.parts, "Films of all of the picture, in any order")->required();
  CLI::Option* output =
      app.add_option("-o,--output", options.output,
                     "Image to write; its ending says the format: .bmp, .png, .ppm, .pfm, .exr")
          ->type_name("FILE")
          ->check(fileName());
  app.add_flag("--check", options.check, "Say of each part whether it is whole and complete; merge nothing")
      ->excludes(output);
  addCropOption(app, options.crop, "Only the pixels X0 <= x < X1, Y0 <= y < Y1, y from the top");
  app.add_flag("--normalize", options.normalize, "Stretch the values so that the largest is 1");
  app.add_flag("--half", options.half, "Write an EXR file in 16 bits a channel in place of 32");
  app.add_flag("-q,--quiet", options.quiet, "Print nothing but warnings and errors");
  if (!parseCommandLine(app, argc, argv)) return std::nullopt;
  if (!options.check && options.output.empty()) {
    throw Error(ErrorKind::kUsage, "--output is missing; lavaray-merge --help lists the options");
  }
  if (!options.check && !imageFormat(options.output)) {
    throw Error(ErrorKind::kUsage, "--output " + options.output +
                                       ": its ending says no image format; allowed are " + kImageFormatNames);
  }
  if (options.half && imageFormat(options.output) != ImageFormat::kExr) {
    throw Error(ErrorKind::kUsage, "--half is for EXR; give --output the ending .exr");
  }
  return options;
}

// Each part is a file that stays open, and there may be thousands of them.
void allowManyFiles() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

float largestValue(FilmMerge& merge, const Rectangle& area, std::vector<float>& row) {
  float largest = 0.0F;
  for (int y = area.y0; y < area.y1; ++y) {
    merge.readRow(y, area.x0, area.width(), row.data());
    largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  }
  return largest;
}

// Prints a line for each part: its name, and `complete` or what is wrong with it.
int checkParts(const MergeOptions& options) {
  int code = 0;
  for (const std::filesystem::path& part : options.parts) {
    try {
      const bool isComplete = readFilmInfo(part).isComplete;
      std::cout << part.string() << (isComplete ? ": complete\n" : ": is not complete\n");
      if (!isComplete) code = static_cast<int>(ErrorKind::kInput);
    } catch (const Error& error) {
      std::cout << error.what() << '\n';
      code = static_cast<int>(ErrorKind::kInput);
    }
  }
  return code;
}

int mergeParts(const MergeOptions& options) {
  allowManyFiles();
  for (const std::filesystem::path& part : options.parts) noteRead(part, "the film");
  OutputFile output({"--output", options.output});
  Progress progress(progressStyle(options.quiet));
  progress.begin("verifying the parts");
  FilmMerge merge(options.parts);
  const Rectangle area = cropWithin(options.crop, merge.size());
  merge.checkCoverage(area);
  progress.end();
  for (const std::string& warning : merge.warnings()) std::cerr << "warning: " << warning << '\n';

  const int width = area.width();
  const int height = area.height();
  std::vector<float> row(std::size_t{3} * width);
  const float largest = options.normalize ? largestValue(merge, area, row) : 1.0F;
  const TextEntries texts = {{"Software", std::string("lavaray-merge ") + kVersion},
                             {"Size", std::to_string(width) + " x " + std::to_string(height)},
                             {"Parts", std::to_string(options.parts.size())},
                             {"Device", merge.device()}};
  const ImageFormat format = options.half ? ImageFormat::kExrHalf : imageFormat(options.output).value();
  ImageWriter writer(output, format, {width, height}, texts);
  progress.begin("merging");
  for (int y = 0; y < height; ++y) {
    merge.readRow(area.y0 + y, area.x0, width, row.data());
    if (options.normalize && largest > 0.0F) {
      for (float& value : row) value /= largest;
    }
    writer.write(row.data());
    progress.update(static_cast<double>(y + 1) / height, "");
  }
  writer.finish();
  output.commit();
  return 0;
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray-merge", [&] {
    const auto options = lavaray::parseMergeOptions(argc, argv);
    if (!options) return 0;
    return options->check ? lavaray::checkParts(*options) : lavaray::mergeParts(*options);
  });
}
