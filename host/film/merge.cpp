#include "film/merge.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "base/errors.hpp"

namespace lavaray {
namespace {

// A message names at most this many of the things that are wrong with the parts.
constexpr std::size_t kMaxNamed = 12;

class Complaints {
 public:
  void add(const std::string& complaint) {
    if (count_ < kMaxNamed) text_ += (count_ > 0 ? "\n" : "") + complaint;
    ++count_;
  }
  void throwIfAny() const {
    if (count_ == 0) return;
    const std::string rest =
        count_ > kMaxNamed ? "\nand " + std::to_string(count_ - kMaxNamed) + " more" : "";
    throw Error(ExitCode::kInput, text_ + rest);
  }

 private:
  std::size_t count_ = 0;
  std::string text_;
};

// The positions from `first` to `last` at which something begins or ends, each once.
std::vector<int> cuts(std::vector<int> positions, int first, int last) {
  positions.insert(positions.end(), {first, last});
  std::erase_if(positions, [&](int position) { return position < first || position > last; });
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

bool contains(const Rectangle& outer, const Rectangle& inner) {
  return outer.x0 <= inner.x0 && inner.x1 <= outer.x1 && outer.y0 <= inner.y0 && inner.y1 <= outer.y1;
}

std::string describe(const Rectangle& cell, std::uint32_t first, std::uint32_t end) {
  return "pixels " + std::to_string(cell.x0) + ',' + std::to_string(cell.y0) + " to " +
         std::to_string(cell.x1) + ',' + std::to_string(cell.y1) + ", samples " + std::to_string(first) +
         ':' + std::to_string(end);
}

// Checks the samples of a cell, of which each part has either all or none.
void checkCell(const Rectangle& cell, std::vector<const FilmReader*> parts, std::uint32_t samples,
               Complaints& complaints) {
  std::sort(parts.begin(), parts.end(), [](const FilmReader* a, const FilmReader* b) {
    return a->header().range.first < b->header().range.first;
  });
  std::uint32_t covered = 0;
  const FilmReader* last = nullptr;
  for (const FilmReader* part : parts) {
    const auto [first, end] = part->header().range;
    if (first > covered) complaints.add(describe(cell, covered, first) + " are in no part");
    if (first < covered) {
      complaints.add(describe(cell, first, std::min(covered, end)) + " are in both " + last->file().string() +
                     " and " + part->file().string());
    }
    if (end >= covered) last = part;
    covered = std::max(covered, end);
  }
  if (covered < samples) complaints.add(describe(cell, covered, samples) + " are in no part");
}

// The record that a pixel's bytes hold.
template <typename Record>
Record recordAt(std::span<const std::byte> bytes, std::size_t index) {
  Record record;
  std::memcpy(&record, &bytes[index * sizeof record], sizeof record);
  return record;
}

PixelSum sumAt(SumKind kind, std::span<const std::byte> bytes, std::size_t index) {
  if (kind == SumKind::kMean) return recordAt<PixelSum>(bytes, index);
  const auto pixel = recordAt<HalfSums>(bytes, index);
  PixelSum sum = pixel.halves[0];
  sum.add(pixel.halves[1]);
  return sum;
}

}  // namespace

Merge::Merge(const std::vector<std::filesystem::path>& files) {
  Complaints complaints;
  for (const std::filesystem::path& file : files) {
    try {
      parts_.push_back(std::make_unique<FilmReader>(file));
    } catch (const Error& error) {
      complaints.add(error.what());
      continue;
    }
    const FilmReader& part = *parts_.back();
    if (!part.header().isComplete) complaints.add(file.string() + ": is not complete; resume and finish it");
    const std::string difference = describeDifference(first().identity, part.header().identity);
    if (!difference.empty()) {
      complaints.add(file.string() + ": is of another picture than " + parts_.front()->file().string() +
                     ": " + difference);
    }
  }
  complaints.throwIfAny();
}

std::vector<std::string> Merge::warnings() const {
  std::vector<std::string> result;
  for (const auto& part : parts_) {
    if (part->header().device == first().device) continue;
    result.push_back(part->file().string() + " was rendered on " + part->header().device + ", " +
                     parts_.front()->file().string() + " on " + first().device +
                     "; their pixels may differ in the last bits");
  }
  if (first().kind == SumKind::kHalves && parts_.size() > 1) {
    result.push_back(
        "with --target-error each part has samples of its own: the picture has the error that was "
        "asked for, but not the bits of one render of the whole");
  }
  return result;
}

void Merge::checkCoverage(const Rectangle& area) const {
  std::vector<int> columns;
  std::vector<int> rows;
  for (const auto& part : parts_) {
    const Rectangle& crop = part->header().crop;
    columns.insert(columns.end(), {crop.x0, crop.x1});
    rows.insert(rows.end(), {crop.y0, crop.y1});
  }
  columns = cuts(std::move(columns), area.x0, area.x1);
  rows = cuts(std::move(rows), area.y0, area.y1);
  Complaints complaints;
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
      const Rectangle cell{columns[column], rows[row], columns[column + 1], rows[row + 1]};
      std::vector<const FilmReader*> parts;
      for (const auto& part : parts_) {
        if (contains(part->header().crop, cell)) parts.push_back(part.get());
      }
      checkCell(cell, std::move(parts), first().samples, complaints);
    }
  }
  complaints.throwIfAny();
}

void Merge::readRow(int y, int x0, std::span<float> rgb) {
  const int x1 = x0 + static_cast<int>(rgb.size() / 3);
  const SumKind kind = first().kind;
  std::fill(rgb.begin(), rgb.end(), 0.0F);
  std::vector<PixelSum> sums(kind == SumKind::kCenter ? 0 : rgb.size() / 3);
  for (const auto& part : parts_) {
    const auto& [crop, traced, range] =
        std::tie(part->header().crop, part->header().traced, part->header().range);
    if (y < crop.y0 || y >= crop.y1) continue;
    const bool isTraced = traced.y0 <= y && y < traced.y1 && traced.x0 < traced.x1;
    if (isTraced) {
      bytes_.resize(static_cast<std::size_t>(traced.width()) * bytesPerPixel(kind));
      part->readRow(y - traced.y0, bytes_);
    }
    for (int x = std::max(x0, crop.x0); x < std::min(x1, crop.x1); ++x) {
      const std::size_t pixel = static_cast<std::size_t>(x - x0);
      const bool isBlack = !isTraced || x < traced.x0 || x >= traced.x1;
      const auto index = static_cast<std::size_t>(x - traced.x0);
      if (isBlack) {
        if (!sums.empty()) sums[pixel].add(glm::vec3(0.0F), range.end - range.first);
      } else if (kind == SumKind::kCenter) {
        const auto value = recordAt<glm::vec3>(bytes_, index);
        for (int channel = 0; channel < 3; ++channel) rgb[3 * pixel + channel] = value[channel];
      } else {
        sums[pixel].add(sumAt(kind, bytes_, index));
      }
    }
  }
  for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
    const glm::vec3 mean(sums[pixel].mean());
    for (int channel = 0; channel < 3; ++channel) rgb[3 * pixel + channel] = mean[channel];
  }
}

}  // namespace lavaray
