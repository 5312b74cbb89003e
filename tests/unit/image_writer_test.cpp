// Image files as others write them: CImg the formats that hold plain pixels; libpng is asked what is in a
// PNG.
#include "image/image_writer.hpp"

#include <gtest/gtest.h>

#define cimg_display 0
#define cimg_verbosity 0
#include <CImg.h>

#include <filesystem>
#include <random>

#include "base/byte_reader.hpp"
#include "image/image_reader.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

using cimg_library::CImg;

Image randomImage(int width, int height) {
  Image image{width, height, {}};
  std::mt19937 random(static_cast<unsigned>(width));
  std::uniform_real_distribution<float> value(0.0F, 1.0F);
  image.rgb.resize(std::size_t{3} * width * height);
  for (float& next : image.rgb) next = value(random);
  return image;
}

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

std::string writtenByCImg(const Image& image, ImageFormat format) {
  const std::filesystem::path file = testFolder() / "by-cimg";
  if (format == ImageFormat::kPfm) {
    planar<float>(image, [](float value) { return value; }).save_pfm(file.c_str());
  } else {
    const CImg<std::uint8_t> bytes = planar<std::uint8_t>(image, toByte);
    format == ImageFormat::kBmp ? bytes.save_bmp(file.c_str()) : bytes.save_pnm(file.c_str(), 1);
  }
  return readFile(file);
}

std::filesystem::path written(const Image& image, ImageFormat format) {
  const std::filesystem::path file = testFolder() / "by-lavaray";
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  writeImage(image, format, stream, {{"Scene", "a"}});
  std::fclose(stream);
  return file;
}

// Rows of every remainder by four bytes, some of which fill several blocks and a part of one, and a row
// larger than a block.
constexpr ImageSize kSizes[] = {{1, 1}, {5, 4}, {6, 4}, {7, 4}, {8, 1}, {301, 700}, {30000, 3}};

TEST(WriteImage, MakesTheFilesThatCImgMakes) {
  for (const auto& [width, height] : kSizes) {
    const Image image = randomImage(width, height);
    for (const ImageFormat format : {ImageFormat::kBmp, ImageFormat::kPpm, ImageFormat::kPfm}) {
      EXPECT_TRUE(readFile(written(image, format)) == writtenByCImg(image, format))
          << formatName(format) << ' ' << width << " x " << height;
    }
  }
}

TEST(WriteImage, KeepsThe8BitLevelsInAPng) {
  for (const auto& [width, height] : kSizes) {
    const Image image = randomImage(width, height);
    const Image back = readImage(written(image, ImageFormat::kPng));
    ASSERT_EQ(back.rgb.size(), image.rgb.size());
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      ASSERT_EQ(back.rgb[i], static_cast<float>(toByte(image.rgb[i])) / 255.0F) << "value " << i;
    }
  }
}

}  // namespace
}  // namespace lavaray
