#include "image/image_writer.hpp"

#include <span>

#include "image/row_writer.hpp"

namespace lavaray {

void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts) {
  RowWriter writer(format, image.width, image.height, stream, texts);
  const std::size_t rowSize = std::size_t{3} * image.width;
  for (std::size_t at = 0; at < image.rgb.size(); at += rowSize) {
    writer.write(std::span(image.rgb).subspan(at, rowSize));
  }
  writer.finish();
}

}  // namespace lavaray
