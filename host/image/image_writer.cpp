#include "image/image_writer.hpp"

#include <span>

#define cimg_display 0
#define cimg_verbosity 0
#include <CImg.h>

#include "base/errors.hpp"
#include "image/row_writer.hpp"

namespace lavaray {
namespace {

using cimg_library::CImg;

// CImg stores the channels one after another.
template <typename Value, typename Convert>
CImg<Value> planar(const Image& image, const Convert& convert) {
  CImg<Value> result(image.width, image.height, 1, 3);
  const std::size_t pixels = std::size_t(image.width) * image.height;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Value* plane = result.data() + channel * pixels;
    for (std::size_t i = 0; i < pixels; ++i) plane[i] = convert(image.rgb[3 * i + channel]);
  }
  return result;
}

}  // namespace

void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts) {
  if (format == ImageFormat::kBmp) checkBmpSize(image.width, image.height);
  if (format == ImageFormat::kPng) {
    writePng(image, texts, stream);
    return;
  }
  if (format == ImageFormat::kExr || format == ImageFormat::kExrHalf) {
    RowWriter writer(format, image.width, image.height, stream, texts);
    const std::size_t rowSize = std::size_t{3} * image.width;
    for (std::size_t at = 0; at < image.rgb.size(); at += rowSize) {
      writer.write(std::span(image.rgb).subspan(at, rowSize));
    }
    writer.finish();
    return;
  }
  try {
    if (format == ImageFormat::kPfm) {
      planar<float>(image, [](float value) { return value; }).save_pfm(stream);
      return;
    }
    const CImg<std::uint8_t> bytes = planar<std::uint8_t>(image, toByte);
    if (format == ImageFormat::kBmp) bytes.save_bmp(stream);
    if (format == ImageFormat::kPpm) bytes.save_pnm(stream, 1);
  } catch (const cimg_library::CImgException&) {
    throw Error(ExitCode::kOutput, "the image cannot be written: there is not enough memory");
  }
}

}  // namespace lavaray
