#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"

namespace lavaray {

// Images against the oracle. Pixels are RGB, row by row from the top, without padding.

// A float image, values clamped to [0, 1]. `wrong` must be 0: on a pixel that is certain no channel may be
// off by more than one 8-bit level. Not a number is wrong, too.
struct Comparison {
  int total = 0;
  int uncertain = 0;
  int wrong = 0;
  double maxDifference = 0.0;  // over certain pixels
  int maxX = 0, maxY = 0;      // its place
  [[nodiscard]] double uncertainShare() const { return static_cast<double>(uncertain) / total; }
};

// Throws std::invalid_argument where the image has another size.
Comparison compare(const std::vector<float>& rgb, const oracle::Result& expected);

std::string describe(const Comparison& comparison);

// Whether a pixel of a float image is off the oracle's because the device rounds a ray that passes through an
// edge to its other side, as it may for a whole row of pixels where that is how the edge lies. Then it has
// one of the colours that are there, which vary by less than half a level over the width of the oracle's
// probes, and no colour between them.
bool showsAlternative(const std::vector<float>& rgb, std::size_t index, const oracle::Pixel& expected);

// Two 8-bit images. `wrong` counts the pixels that differ by more than one level and are not at an edge,
// which is where the oracle is uncertain of the pixel itself or of one of its eight neighbours.
struct ByteComparison {
  int differing = 0;
  int maxDifference = 0;
  int wrong = 0;
};

// Throws std::invalid_argument where the images differ in size.
ByteComparison compareBytes(const std::vector<std::uint8_t>& actual,
                            const std::vector<std::uint8_t>& expected, const oracle::Result& oracle);

std::string describe(const ByteComparison& comparison);

// trunc(255 c), which is what an 8-bit file holds. With `stretch` the colours are first scaled so that the
// largest value of all channels is 1.
std::vector<std::uint8_t> truncatedBytes(const oracle::Result& image, bool stretch = false);

}  // namespace lavaray
