#pragma once

#include <array>
#include <span>

#include "sampling/discoveries.hpp"
#include "sampling/sample_allocation.hpp"

namespace lavaray {

// By how much the squared errors of pixels' classes are to be multiplied, as the whole picture's samples
// tell.
struct PictureScale {
  Discoveries::Sums seen;
  Discoveries::Sums suspected;

  [[nodiscard]] double squaredError(PixelClass pixel) const {
    const auto step = static_cast<std::size_t>(pixel.sampleStep());
    return pixel.squaredError() * (pixel.isSuspected() ? suspected : seen)[step];
  }
};

}  // namespace lavaray
