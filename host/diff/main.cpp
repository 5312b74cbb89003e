// lavaray-diff: compares images.
#include <lavaray/image.h>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

#include "command_line/program.hpp"
#include "command_line/shown.hpp"
#include "diff/options.hpp"
#include "diff/text_report.hpp"

namespace lavaray {
namespace {

// The files to write, opened before the work.
class Outputs {
 public:
  explicit Outputs(const DiffOptions& options) {
    const OutputName picture{"--output", options.output};
    const OutputName report{"--report", options.report};
    const OutputName json{"--json", options.json};
    std::vector<OutputName> names;
    for (const OutputName& name : {picture, report, json}) {
      if (!name.file.empty()) names.push_back(name);
    }
    checkOutputs(names);
    if (!picture.file.empty()) {
      picture_.emplace(picture);
      format_ = imageFormat(options.output).value();
    }
    if (!report.file.empty()) {
      reportFile_.emplace(report);
      const std::string title =
          options.from.empty() && !options.name.empty() ? options.name : "Picture comparison";
      page_.emplace(*reportFile_, ReportFormat::kHtml, title);
    }
    if (!json.file.empty()) {
      jsonFile_.emplace(json);
      pairs_.emplace(*jsonFile_, ReportFormat::kJson);
    }
  }

  void add(const ComparedPair& compared) {
    if (page_) page_->add(compared);
    if (pairs_) pairs_->add(compared);
    if (!picture_ || !isCompared(compared)) return;
    writeImage(differencePicture(*compared.image, *compared.reference), format_, *picture_);
    picture_->commit();
  }

  void finish() {
    if (page_) page_->finish();
    if (pairs_) pairs_->finish();
    if (reportFile_) reportFile_->commit();
    if (jsonFile_) jsonFile_->commit();
  }

 private:
  std::optional<OutputFile> picture_;
  ImageFormat format_{};
  std::optional<OutputFile> reportFile_;
  std::optional<OutputFile> jsonFile_;
  std::optional<ReportWriter> page_;
  std::optional<ReportWriter> pairs_;
};

std::vector<ImagePair> pairsOf(const DiffOptions& options) {
  std::vector<ImagePair> pairs;
  for (const std::string& file : options.from) {
    const std::vector<ImagePair> more = readPairs(file);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  if (!options.from.empty()) return pairs;
  if (std::filesystem::is_directory(options.image)) {
    pairs = pairsOfFolders(options.image, options.reference);
    if (pairs.empty()) {
      throw Error(ErrorKind::kInput, shown(options.image) + " and " + shown(options.reference) +
                                         " hold no images that can be read");
    }
  } else {
    const std::string own = std::filesystem::path(options.image).filename();
    pairs.push_back({options.name.empty() ? own : options.name, options.image, options.reference, {}, {}});
  }
  for (ImagePair& pair : pairs) {
    pair.driver = options.driver;
    pair.limits = options.limits;
  }
  return pairs;
}

// Besides those of errors.
constexpr int kImagesDiffer = 10;

int exitCode(const std::vector<Verdict>& verdicts) {
  const auto has = [&](Verdict verdict) { return std::count(verdicts.begin(), verdicts.end(), verdict) > 0; };
  if (has(Verdict::kUnreadable)) return static_cast<int>(ErrorKind::kInput);
  const auto alike = std::count(verdicts.begin(), verdicts.end(), Verdict::kAlike);
  return static_cast<std::size_t>(alike) == verdicts.size() ? 0 : kImagesDiffer;
}

int diff(const DiffOptions& options) {
  const std::vector<ImagePair> pairs = pairsOf(options);
  const bool areMany = !options.from.empty() || std::filesystem::is_directory(options.image);
  for (const ImagePair& pair : pairs) {
    for (const std::filesystem::path& file : {pair.image, pair.reference}) {
      if (!file.empty()) noteRead(file, "the image");
    }
  }
  Outputs outputs(options);
  std::vector<Verdict> verdicts;
  std::string problem;
  for (const ImagePair& pair : pairs) {
    const ComparedPair compared = comparePair(pair);
    verdicts.push_back(compared.verdict);
    problem = compared.problem;
    areMany ? printLine(compared) : printPair(compared);
    outputs.add(compared);
  }
  outputs.finish();
  if (areMany) printSummary(verdicts);
  if (!areMany && !problem.empty()) throw Error(ErrorKind::kInput, problem);
  return exitCode(verdicts);
}

std::string valuesText(const Image& image) {
  const auto& maxima = image.source.maxima;
  if (maxima[0] == 0) return "floats";
  std::string text = "0 to " + std::to_string(maxima[0]);
  for (std::size_t i = 1; i < 3; ++i) {
    if (maxima[0] != maxima[1] || maxima[0] != maxima[2]) text += ", 0 to " + std::to_string(maxima[i]);
  }
  return text;
}

int info(const std::string& file) {
  const Image image = readImage(file);
  const auto print = [](const std::string& name, const std::string& value) {
    std::cout << std::left << std::setw(18) << shown(name) << ' ' << shown(value) << '\n';
  };
  print("format", image.source.format);
  print("size", std::to_string(image.width) + " x " + std::to_string(image.height));
  print("values", valuesText(image));
  print("alpha", image.alpha.empty() ? "no" : "yes");
  for (const std::string& note : image.source.notes) print("note", note);
  for (const auto& [keyword, text] : image.source.texts) print(keyword, text);
  return 0;
}

}  // namespace
}  // namespace lavaray

int main(int argc, char** argv) {
  return lavaray::runProgram("lavaray-diff", [&] {
    const auto options = lavaray::parseDiffOptions(argc, argv);
    if (!options) return 0;
    return options->info ? lavaray::info(options->image) : lavaray::diff(*options);
  });
}
