#include "image/image.hpp"

#include <lavaray/image.h>

#include <algorithm>

#include "base/errors.hpp"
#include "image/exr_common.hpp"
#include "image/exr_writer.hpp"
#include "image/false_color.hpp"
#include "image/image_format.hpp"
#include "image/image_reader.hpp"
#include "image/image_writer.hpp"
#include "image/row_writer.hpp"
#include "library/check_image.hpp"
#include "library/crop.hpp"
#include "library/guarded.hpp"
#include "render/layer.hpp"

namespace lavaray {

void checkWithin(const Rectangle& part, const ImageSize& size) {
  const bool isWithin = part.x0 >= 0 && part.x0 < part.x1 && part.x1 <= size.width &&  //
                        part.y0 >= 0 && part.y0 < part.y1 && part.y1 <= size.height;
  if (isWithin) return;
  throw Error(ExitCode::kUsage, "--crop X0,Y0,X1,Y1 must have 0 <= X0 < X1 <= " + std::to_string(size.width) +
                                    " and 0 <= Y0 < Y1 <= " + std::to_string(size.height));
}

namespace {

ImageFormat formatOf(const std::filesystem::path& file) {
  const std::optional<ImageFormat> format = imageFormat(file);
  if (format) return *format;
  throw Error(ExitCode::kUsage,
              file.string() + ": its ending says no image format; allowed are " + v0::kImageFormatNames);
}

bool isDisplayable(float value) {
  return value >= 0.0F && value <= 1.0F;
}

// What 8 bits can say of the image; a NaN is black.
Image clamped(Image image) {
  for (float& value : image.rgb) {
    if (!isDisplayable(value)) value = value > 1.0F ? 1.0F : 0.0F;
  }
  return image;
}

bool hasBytes(ImageFormat format) {
  return format == ImageFormat::kBmp || format == ImageFormat::kPng || format == ImageFormat::kPpm;
}

// The file's owner gets the reason from commit().
void throwIfFailed(v0::OutputFile& file) {
  if (std::ferror(file.stream()) != 0) file.commit();
}

}  // namespace

namespace v0 {

Image readImage(const std::filesystem::path& file) {
  return guarded([&] { return lavaray::readImage(file); });
}

Image parseImage(std::string_view bytes, const std::filesystem::path& file) {
  return guarded([&] { return lavaray::parseImage(bytes, file); });
}

std::optional<ImageFormat> imageFormat(const std::filesystem::path& file) {
  return lavaray::imageFormat(file);
}

void writeImage(const Image& image, const std::filesystem::path& file, const TextEntries& texts) {
  guarded([&] {
    const ImageFormat format = formatOf(file);
    OutputFile output({"the image", file});
    writeImage(image, format, output, texts);
    output.commit();
  });
}

void writeImage(const Image& image, ImageFormat format, OutputFile& file, const TextEntries& texts) {
  guarded([&] {
    checkValues(image);
    const bool isAsShown = !hasBytes(format) || std::ranges::all_of(image.rgb, isDisplayable);
    lavaray::writeImage(isAsShown ? image : clamped(image), format, file.stream(), texts);
  });
}

struct ImageWriter::State {
  OutputFile& file;
  std::size_t rowValues;
  RowWriter rows;
};

ImageWriter::ImageWriter(OutputFile& file, ImageFormat format, const ImageSize& size,
                         const TextEntries& texts)
    : state_(guarded([&] {
        return std::unique_ptr<State>(
            new State{file, 3 * static_cast<std::size_t>(size.width),
                      RowWriter(format, size.width, size.height, file.stream(), texts)});
      })) {}
ImageWriter::~ImageWriter() = default;
ImageWriter::ImageWriter(ImageWriter&&) noexcept = default;
ImageWriter& ImageWriter::operator=(ImageWriter&&) noexcept = default;

void ImageWriter::write(const float* rgb) {
  guarded([&] {
    state_->rows.write({rgb, state_->rowValues});
    throwIfFailed(state_->file);
  });
}

void ImageWriter::finish(const TextEntries& texts) {
  guarded([&] { state_->rows.finish(texts); });
}

struct LayerWriter::State {
  State(OutputFile& file, Layer layer, const ImageSize& size, TextEntries texts)
      : exr(size.width, size.height, channelsOf(layer), ExrWriter::Precision::kFloat,
            (texts.emplace_back(kExrLayer, layerName(layer)), texts), file.stream()) {}
  ExrWriter exr;
};

LayerWriter::LayerWriter(OutputFile& file, Layer layer, const ImageSize& size, const TextEntries& texts)
    : state_(guarded([&] { return std::make_unique<State>(file, layer, size, texts); })) {}
LayerWriter::~LayerWriter() = default;
LayerWriter::LayerWriter(LayerWriter&&) noexcept = default;
LayerWriter& LayerWriter::operator=(LayerWriter&&) noexcept = default;

void LayerWriter::write(const float* values, std::size_t count) {
  guarded([&] { state_->exr.writeNumbers({values, count}); });
}

void LayerWriter::finish() {
  guarded([&] { state_->exr.finish(); });
}

void checkSize(ImageFormat format, const ImageSize& size) {
  guarded([&] {
    if (format == ImageFormat::kBmp) checkBmpSize(size.width, size.height);
  });
}

Rectangle cropWithin(const std::optional<Rectangle>& part, const ImageSize& size) {
  return guarded([&] {
    const Rectangle rectangle = part.value_or(Rectangle{0, 0, size.width, size.height});
    checkWithin(rectangle, size);
    return rectangle;
  });
}

float normalize(Image& image) {
  return lavaray::normalize(image);
}

Image crop(const Image& image, const Rectangle& part) {
  return guarded([&] {
    checkValues(image);
    checkWithin(part, {image.width, image.height});
    return lavaray::crop(image, part);
  });
}

void applyFalseColors(std::vector<float>& rgb) {
  lavaray::applyFalseColors(rgb);
}

}  // namespace v0
}  // namespace lavaray
