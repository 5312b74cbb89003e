#include <lavaray/files.h>

#include "base/errors.hpp"
#include "film/merge.hpp"
#include "library/crop.hpp"
#include "library/guarded.hpp"

namespace lavaray::v0 {

FilmInfo readFilmInfo(const std::filesystem::path& film) {
  return guarded([&] {
    const FilmReader reader(film);
    const FilmHeader& header = reader.header();
    return FilmInfo{header.device, header.size, header.crop, header.range, header.samples, header.isComplete};
  });
}

struct FilmMerge::State {
  explicit State(const std::vector<std::filesystem::path>& films) : merge(films) {}
  Merge merge;
};

FilmMerge::FilmMerge(const std::vector<std::filesystem::path>& films)
    : state_(guarded([&] {
        if (films.empty()) throw lavaray::Error(ExitCode::kUsage, "there are no films to merge");
        return std::make_unique<State>(films);
      })) {}
FilmMerge::~FilmMerge() = default;
FilmMerge::FilmMerge(FilmMerge&&) noexcept = default;
FilmMerge& FilmMerge::operator=(FilmMerge&&) noexcept = default;

ImageSize FilmMerge::size() const {
  return state_->merge.size();
}

const std::string& FilmMerge::device() const {
  return state_->merge.first().device;
}

std::vector<std::string> FilmMerge::warnings() const {
  return guarded([&] { return state_->merge.warnings(); });
}

void FilmMerge::checkCoverage(const Rectangle& area) const {
  guarded([&] { state_->merge.checkCoverage(area); });
}

void FilmMerge::readRow(int y, int x0, int columns, float* rgb) {
  guarded([&] { state_->merge.readRow(y, x0, {rgb, 3 * static_cast<std::size_t>(columns)}); });
}

Image FilmMerge::image(const Rectangle& area) {
  return guarded([&] {
    checkWithin(area, size());
    state_->merge.checkCoverage(area);
    const std::size_t rowValues = 3 * static_cast<std::size_t>(area.width());
    Image image{area.width(), area.height(), std::vector<float>(rowValues * area.height())};
    for (int y = area.y0; y < area.y1; ++y)
      state_->merge.readRow(y, area.x0, {&image.rgb[rowValues * (y - area.y0)], rowValues});
    return image;
  });
}

}  // namespace lavaray::v0
