#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "film/film_file.hpp"

namespace lavaray {

// The parts of one picture, merged row by row, so that the picture need not fit into memory. Since a pixel's
// samples are summed without rounding, the values are bit for bit those of one render of the whole. Only with
// a target error the samples of a part are its own: there each part has an error of at most the target, and
// so the whole.
class Merge {
 public:
  // Opens and verifies all parts. Throws Error(kInput) that names each part that is damaged, not complete, of
  // another picture than the first.
  explicit Merge(const std::vector<std::filesystem::path>& parts);

  // Throws Error(kInput) where a pixel of the area lacks samples or has some twice, saying which pixels,
  // which samples and, of the latter, which parts.
  void checkCoverage(const Rectangle& area) const;

  // The values of row y of the picture, from column x0 on; `rgb` is three times as long as there are columns.
  void readRow(int y, int x0, std::span<float> rgb);

  [[nodiscard]] ImageSize size() const { return first().size; }  // of the whole picture
  [[nodiscard]] const FilmHeader& first() const { return parts_.front()->header(); }
  // Names what may make the picture differ in the last bits from that of one render; empty where nothing
  // does.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  std::vector<std::unique_ptr<FilmReader>> parts_;
  std::vector<std::byte> bytes_;  // of a row of a part
};

}  // namespace lavaray
