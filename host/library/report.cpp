#include <lavaray/image.h>

#include <utility>

#include "base/errors.hpp"
#include "library/guarded.hpp"
#include "library/version.hpp"
#include "report/page.hpp"
#include "report/pair.hpp"
#include "report/pair_json.hpp"

namespace lavaray::v0 {

struct ComparedPair::Details : lavaray::ComparedPair {};

ComparedPair comparePair(const ImagePair& pair) {
  return guarded([&] {
    const auto details =
        std::make_shared<ComparedPair::Details>(ComparedPair::Details{lavaray::comparePair(pair)});
    const auto found = [](const std::optional<Image>& image) { return image ? &*image : nullptr; };
    return ComparedPair{details->pair,         details->verdict,          details->problem,
                        found(details->image), found(details->reference), details->comparedAs,
                        details->difference,   details->seen.mean,        details};
  });
}

std::vector<ImagePair> pairsOfFolders(const std::filesystem::path& images,
                                      const std::filesystem::path& references) {
  return guarded([&] { return lavaray::pairsOfFolders(images, references); });
}

std::vector<ImagePair> readPairs(const std::filesystem::path& json) {
  return guarded([&] { return lavaray::readPairs(json); });
}

struct ReportWriter::State {
  std::optional<ReportPage> page;
  std::optional<PairsFile> json;
};

ReportWriter::ReportWriter(OutputFile& file, ReportFormat format, const std::string& title)
    : state_(guarded([&] {
        auto state = std::make_unique<State>();
        if (format == ReportFormat::kHtml) {
          state->page.emplace(file.stream(), title, std::string("lavaray ") + kVersion);
        } else {
          state->json.emplace(file.stream(), kVersion);
        }
        return state;
      })) {}
ReportWriter::~ReportWriter() = default;
ReportWriter::ReportWriter(ReportWriter&&) noexcept = default;
ReportWriter& ReportWriter::operator=(ReportWriter&&) noexcept = default;

void ReportWriter::add(const ComparedPair& compared) {
  guarded([&] {
    if (!compared.details)
      throw lavaray::Error(ExitCode::kUsage, "a report is of pairs that comparePair has compared");
    if (state_->page) state_->page->add(*compared.details);
    if (state_->json) state_->json->add(*compared.details);
  });
}

void ReportWriter::finish() {
  guarded([&] {
    if (state_->page) state_->page->finish();
    if (state_->json) state_->json->finish();
  });
}

}  // namespace lavaray::v0
