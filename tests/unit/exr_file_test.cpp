// EXR files, as this program writes them and as others do.
#include "image/exr_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>

#include "base/errors.hpp"
#include "image/image_reader.hpp"
#include "image/image_writer.hpp"
#include "image/row_writer.hpp"
#include "support/input_files.hpp"

namespace lavaray {
namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 53;

std::filesystem::path written(const Image& image, ImageFormat format, const TextEntries& texts = {}) {
  const std::filesystem::path file = testFolder() / "image.exr";
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  writeImage(image, format, stream, texts);
  std::fclose(stream);
  return file;
}

// The decoding of IEC 61966-2-1.
double light(double color) {
  return color <= 0.04045 ? color / 12.92 : std::pow((color + 0.055) / 1.055, 2.4);
}

Image gradient() {
  Image image{kWidth, kHeight, {}};
  std::mt19937 random(1);
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
    image.rgb.push_back(static_cast<float>(random() % 65536) / 65535.0F);
  }
  return image;
}

std::string whyRefused(const std::filesystem::path& file) {
  try {
    readImage(file);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), ExitCode::kInput);
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
    return error.what();
  }
  return "not at all";
}

void expectRefused(const std::filesystem::path& file, const std::string& why) {
  EXPECT_NE(whyRefused(file).find(why), std::string::npos) << whyRefused(file);
}

// Every channel of such a file has this value in pixel (x, y).
float pattern(int x, int y) {
  return static_cast<float>(x + 40 * y) / 2400.0F;
}

Imf::FrameBuffer patternBuffer(std::vector<float>& values, const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  for (int y = window.min.y; y <= window.max.y; ++y) {
    for (int x = window.min.x; x <= window.max.x; ++x) values.push_back(pattern(x, y));
  }
  Imf::FrameBuffer frame;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    frame.insert(channel.name(), Imf::Slice::Make(Imf::FLOAT, values.data(), window));
  }
  return frame;
}

Imf::Header headerOf(const std::vector<std::string>& channels) {
  Imf::Header header(kWidth, kHeight);
  for (const std::string& name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  return header;
}

std::filesystem::path writtenByLibrary(const Imf::Header& header) {
  const std::filesystem::path file = testFolder() / "other.exr";
  std::vector<float> values;
  const Imf::FrameBuffer frame = patternBuffer(values, header);
  if (header.hasTileDescription()) {
    Imf::TiledOutputFile output(file.c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
  } else {
    Imf::OutputFile output(file.c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(kHeight);
  }
  return file;
}

void expectPattern(const std::filesystem::path& file, double tolerance) {
  const Image image = readImage(file);
  ASSERT_EQ(image.width, kWidth);
  ASSERT_EQ(image.height, kHeight);
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
    const double expected = double{pattern(i / 3 % kWidth, i / 3 / kWidth)};
    // Colours in the file are multiplied by alpha.
    const double alpha = image.alpha.empty() ? 1.0 : double{image.alpha[i / 3]};
    if (!image.alpha.empty()) {
      EXPECT_NEAR(alpha, expected, tolerance);
    }
    EXPECT_NEAR(light(double{image.rgb[i]}) * (alpha > 0.0 ? alpha : 1.0), expected, tolerance);
  }
}

TEST(ExrFile, ColorsComeBack) {
  const Image image = gradient();
  const Image back = readImage(written(image, ImageFormat::kExr));
  ASSERT_EQ(back.width, kWidth);
  ASSERT_EQ(back.height, kHeight);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) EXPECT_NEAR(back.rgb[i], image.rgb[i], 1e-7);
  const Image half = readImage(written(image, ImageFormat::kExrHalf));
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    // Half a unit in the last of 11 bits of the light.
    EXPECT_NEAR(light(double{half.rgb[i]}), light(double{image.rgb[i]}),
                std::max(0x1p-11 * light(double{image.rgb[i]}), 0x1p-25));
  }
}

TEST(ExrFile, LevelsComeBack) {
  Image image{256, 1, {}};
  for (int level = 0; level < 256; ++level) {
    image.rgb.insert(image.rgb.end(), 3, static_cast<float>(level) / 255.0F);
  }
  const Image back = readImage(written(image, ImageFormat::kExr));
  for (std::size_t i = 0; i < image.rgb.size(); ++i) EXPECT_EQ(toByte(back.rgb[i]), toByte(image.rgb[i]));
}

TEST(ExrFile, HoldsLinearLightInRgb) {
  const Image image = gradient();
  Imf::InputFile input(written(image, ImageFormat::kExr).c_str(), 0);
  EXPECT_EQ(input.header().compression(), Imf::ZIP_COMPRESSION);
  std::vector<float> values(image.rgb.size());
  Imf::FrameBuffer frame;
  for (int i = 0; i < 3; ++i) {
    const std::string name(1, "RGB"[i]);
    ASSERT_NE(input.header().channels().findChannel(name), nullptr);
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data() + i, input.header().dataWindow(),
                                        3 * sizeof(float)));
  }
  input.setFrameBuffer(frame);
  input.readPixels(0, kHeight - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], light(double{image.rgb[i]}), 1e-7);
  }
}

TEST(ExrFile, NumbersAndTextsComeBack) {
  const std::filesystem::path file = testFolder() / "layer.exr";
  const TextEntries texts = {{"Layer", "depth"}, {"Scene", "zwölf.txt"}, {"Samples per pixel", ""}};
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> numbers = {0.0F, -1.0F, 1e30F, infinity, 16777215.0F, 0.1F};
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  ExrWriter writer(3, 2, 1, ExrWriter::Precision::kFloat, texts, stream);
  writer.writeNumbers(std::span(numbers).first(4));
  writer.writeNumbers(std::span(numbers).subspan(4));
  writer.finish();
  std::fclose(stream);
  const Image image = readImage(file);
  ASSERT_EQ(image.rgb.size(), 18U);
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(image.rgb[i], numbers[i / 3]);
  EXPECT_EQ(image.source.format, "EXR");
  ASSERT_EQ(image.source.notes.size(), 1U);
  EXPECT_NE(image.source.notes[0].find("layer"), std::string::npos) << image.source.notes[0];
  EXPECT_NE(image.source.notes[0].find("Y is grey"), std::string::npos) << image.source.notes[0];
  EXPECT_EQ(image.source.texts, TextEntries({texts[0], texts[2], texts[1]}));  // sorted by OpenEXR
}

TEST(ExrFile, OfOtherProgramsIsRead) {
  for (const Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    for (const std::vector<std::string>& channels :
         {std::vector<std::string>{"R", "G", "B"}, {"R", "G", "B", "A", "Z", "Y"}, {"Y"}, {"Y", "A"}}) {
      Imf::Header header = headerOf(channels);
      header.compression() = compression;
      expectPattern(writtenByLibrary(header), 2e-5);  // PXR24 leaves out 8 bits
      header.lineOrder() = Imf::DECREASING_Y;
      if (compression == Imf::ZIP_COMPRESSION) {
        header.setTileDescription({16, 16, Imf::ONE_LEVEL, Imf::ROUND_DOWN});
        header.lineOrder() = Imf::INCREASING_Y;
        expectPattern(writtenByLibrary(header), 1e-6);
      }
    }
  }
}

TEST(ExrFile, OfAnotherKindIsRefusedByName) {
  expectRefused(writtenByLibrary(headerOf({"Z"})), "its channels are Z; only");
  expectRefused(writtenByLibrary(headerOf({"view.R", "view.G", "view.B"})),
                "its channels are view.B, view.G");
  expectRefused(writtenByLibrary(headerOf({"Y", "RY", "BY"})), "its channels are BY, RY, Y; only");
  Imf::Header header = headerOf({"R", "G", "B"});
  header.displayWindow().max.x = 99;
  expectRefused(writtenByLibrary(header), "data window and display window differ");

  const std::filesystem::path file = testFolder() / "kind.exr";
  {
    Imf::Header parts[2] = {headerOf({"R", "G", "B"}), headerOf({"R", "G", "B"})};
    for (Imf::Header& part : parts) part.setType(Imf::SCANLINEIMAGE);
    parts[0].setName("left");
    parts[1].setName("right");
    Imf::MultiPartOutputFile(file.c_str(), parts, 2);
  }
  expectRefused(file, "an EXR image of several parts");
  {
    Imf::Header deep = headerOf({"R", "G", "B"});
    deep.setType(Imf::DEEPSCANLINE);
    deep.compression() = Imf::ZIPS_COMPRESSION;
    Imf::DeepScanLineOutputFile(file.c_str(), deep);
  }
  expectRefused(file, "a deep EXR image");
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path fileOf(const std::string& bytes) {
  const std::filesystem::path file = testFolder() / "damaged.exr";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

TEST(ExrFile, ThatIsNoneOrTooLargeIsRefused) {
  expectRefused(fileOf(""), "is empty");
  expectRefused(fileOf("\x76\x2F\x31\x01"), "is no EXR image");
  expectRefused(writtenByLibrary(headerOf({"R", "G"})), "only EXR images of R, G, B or of Y");
  const std::string good =
      bytesOf(written(Image{kWidth, kHeight, std::vector<float>(3 * kWidth * kHeight)}, ImageFormat::kExr));
  expectRefused(fileOf(good.substr(0, good.size() - 1)), "is damaged");
  const auto enlarged = [&](std::int32_t x, std::int32_t y) {
    std::string huge = good;
    for (const char* window : {"dataWindow", "displayWindow"}) {
      const std::string beginning = std::string(window) + '\0' + "box2i" + '\0';
      // Behind it are the number of bytes, the smallest x and y, and these, of four bytes each.
      const std::size_t at = huge.find(beginning) + beginning.size() + 12;
      for (int i = 0; i < 8; ++i) huge[at + i] = static_cast<char>((i < 4 ? x : y) >> (8 * (i % 4)));
    }
    return fileOf(huge);
  };
  EXPECT_EQ(readImage(enlarged(kWidth - 1, kHeight - 1)).width, kWidth);
  expectRefused(enlarged(60000, kHeight - 1), "bytes cannot hold 3180053 pixels");
  expectRefused(enlarged(70000, kHeight - 1), "is damaged");
  expectRefused(enlarged(0x7FFFFFFE, 0x7FFFFFFE), "is damaged");
}

// Whatever bytes are wrong, the file is read or refused.
TEST(ExrFile, DamageDoesNoHarm) {
  std::mt19937 random(2);
  int refused = 0;
  for (const ImageFormat format : {ImageFormat::kExr, ImageFormat::kExrHalf}) {
    const std::string good = bytesOf(written(gradient(), format));
    for (int i = 0; i < 500; ++i) {
      std::string bad = good;
      // The header is where most is to be misunderstood.
      const std::size_t end = i % 3 == 0 ? bad.size() : 800;
      for (int change = 0; change < 1 + i % 4; ++change) bad[random() % end] = static_cast<char>(random());
      if (i % 7 == 0) bad.resize(random() % bad.size());
      refused += whyRefused(fileOf(bad)) == "not at all" ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace lavaray
