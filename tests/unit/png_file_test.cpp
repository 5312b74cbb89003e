// PNG files as other programs write them.
#include <gtest/gtest.h>

#include <png.h>

#include <array>
#include <filesystem>
#include <vector>

#include "image/image_reader.hpp"
#include "image/png_writer.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

// Of 3 x 2 pixels with these channels each, 8 or 16 bits, written by libpng.
std::filesystem::path writePixels(png_uint_32 format, const void* pixels, const void* colormap = nullptr,
                                  png_uint_32 colors = 0) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 3;
  image.height = 2;
  image.format = format;
  image.colormap_entries = colors;
  const std::filesystem::path file = testFolder() / "image.png";
  EXPECT_NE(png_image_write_to_file(&image, file.c_str(), 0, pixels, 0, colormap), 0) << image.message;
  return file;
}

constexpr std::array<std::array<int, 3>, 6> kColors{
    {{0, 0, 0}, {255, 0, 0}, {0, 255, 0}, {1, 2, 3}, {128, 127, 126}, {255, 255, 255}}};

void expectColors(const Image& image, bool isGrey) {
  ASSERT_EQ(image.width, 3);
  ASSERT_EQ(image.height, 2);
  ASSERT_EQ(image.rgb.size(), 18U);
  for (std::size_t i = 0; i < 18; ++i) {
    const int value = kColors[i / 3][isGrey ? 0 : i % 3];
    EXPECT_EQ(image.rgb[i], static_cast<float>(value) / 255.0F) << "value " << i;
  }
}

template <typename Value>
std::vector<Value> pixelsOf(std::size_t channels, bool hasAlpha) {
  std::vector<Value> pixels;
  for (const auto& color : kColors) {
    for (std::size_t i = 0; i < channels; ++i) {
      const bool isAlpha = hasAlpha && i + 1 == channels;
      pixels.push_back(static_cast<Value>(isAlpha ? 200 : color[i]));
    }
  }
  return pixels;
}

TEST(PngFile, IsReadInColorAndGreyWithAlphaAndWithout) {
  expectColors(readImage(writePixels(PNG_FORMAT_RGB, pixelsOf<png_byte>(3, false).data())), false);
  expectColors(readImage(writePixels(PNG_FORMAT_RGBA, pixelsOf<png_byte>(4, true).data())), false);
  expectColors(readImage(writePixels(PNG_FORMAT_GRAY, pixelsOf<png_byte>(1, false).data())), true);
  expectColors(readImage(writePixels(PNG_FORMAT_GA, pixelsOf<png_byte>(2, true).data())), true);
}

TEST(PngFile, IsReadWithAPalette) {
  const std::vector<png_byte> palette = pixelsOf<png_byte>(3, false);
  const std::array<png_byte, 6> indices{0, 1, 2, 3, 4, 5};
  expectColors(readImage(writePixels(PNG_FORMAT_RGB_COLORMAP, indices.data(), palette.data(), 6)), false);
}

TEST(PngFile, IsReadWith16Bits) {
  std::vector<png_uint_16> pixels = pixelsOf<png_uint_16>(3, false);
  for (png_uint_16& value : pixels) value = static_cast<png_uint_16>(257 * value);
  expectColors(readImage(writePixels(PNG_FORMAT_LINEAR_RGB, pixels.data())), false);
}

TEST(PngFile, IsRefusedWhereItEndsEarly) {
  const std::filesystem::path file = writePixels(PNG_FORMAT_RGB, pixelsOf<png_byte>(3, false).data());
  const auto size = std::filesystem::file_size(file);
  for (std::uintmax_t left = size - 13; left > 0; --left) {  // the last chunk's 12 bytes hold nothing
    std::filesystem::resize_file(file, left);
    EXPECT_NE(inputError([&] { readImage(file); }).find("image.png: "), std::string::npos) << left;
  }
}

TEST(PngFile, HasTextsBeforeAndBehindThePixels) {
  const std::filesystem::path file = testFolder() / "image.png";
  std::FILE* const stream = std::fopen(file.c_str(), "wb");
  PngWriter writer(2, 1, {{"Scene", "a"}}, stream);
  writer.writeRow(std::vector<float>(6, 0.5F));
  writer.finish({{"Seconds", "1.5"}, {"Stopped", "\xC3\xA4"}});
  std::fclose(stream);
  const TextEntries expected = {{"Scene", "a"}, {"Seconds", "1.5"}, {"Stopped", "\xC3\xA4"}};
  EXPECT_EQ(readImage(file).source.texts, expected);
  EXPECT_EQ(readImage(file).rgb, std::vector<float>(6, 127.0F / 255.0F));
}

}  // namespace
}  // namespace lavaray
