#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "image/image.hpp"

namespace lavaray {

// Takes the next row of a picture, from the top, three values per pixel.
using TakeRow = std::function<void(std::span<const float> rgb)>;

// Makes the rows of a picture from the values of a part of it, which come pixel by pixel in the same order.
// Everything else is black.
class PictureRows {
 public:
  PictureRows(const Rectangle& picture, const Rectangle& part)
      : picture_(picture),
        part_(part),
        x_(part.x0),
        y_(picture.y0),
        row_(3 * static_cast<std::size_t>(picture.width())) {}

  // Adds the next value. A row that it completes is taken, after those above the part.
  void add(const glm::vec3& value, const TakeRow& take) {
    while (y_ < part_.y0) endRow(take);
    std::copy_n(&value.x, 3, &row_[3 * static_cast<std::size_t>(x_ - picture_.x0)]);
    if (++x_ == part_.x1) endRow(take);
  }
  // No more values will come: what is left of the rows is black.
  void finish(const TakeRow& take) {
    while (y_ < picture_.y1) endRow(take);
  }

 private:
  void endRow(const TakeRow& take) {
    take(row_);
    std::fill(row_.begin(), row_.end(), 0.0F);
    x_ = part_.x0;
    ++y_;
  }

  Rectangle picture_;
  Rectangle part_;
  int x_;  // of the next value
  int y_;  // of the next row
  std::vector<float> row_;
};

}  // namespace lavaray
