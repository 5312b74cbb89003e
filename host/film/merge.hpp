#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "film/film_file.hpp"

namespace lavaray {

// The parts of one picture, merged row by row, so that the picture need not fit into memory. Since a pixel's
// samples are summed without rounding, the values are bit for bit those of one render of the whole. A render
// to a target error is the exception, since each part chooses its own samples: there the error of each part,
// and so of the whole, is at most the target.
class Merge {
 public:
  // Opens and verifies all parts. Throws Error(kInput) naming each part that is damaged, incomplete, or of a
  // different picture from the first.
  explicit Merge(const std::vector<std::filesystem::path>& parts);

  // Throws Error(kInput) if a pixel of the area lacks samples or has some twice, saying which pixels and
  // samples, and which parts overlap.
  void checkCoverage(const Rectangle& area) const;

  // The values of row y of the picture, from column x0 on; `rgb` is three times as long as there are columns.
  void readRow(int y, int x0, std::span<float> rgb);

  [[nodiscard]] ImageSize size() const { return first().size; }  // of the whole picture
  [[nodiscard]] const FilmHeader& first() const { return parts_.front()->header(); }
  // What may make the picture differ from that of one render in the last bits; empty if nothing does.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  std::vector<std::unique_ptr<FilmReader>> parts_;
  std::vector<std::byte> bytes_;  // of a row of a part
};

}  // namespace lavaray
