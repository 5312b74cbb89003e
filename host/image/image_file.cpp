#include "image/image_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#define cimg_display 0
#define cimg_verbosity 0
#include <CImg.h>

#include "core/errors.hpp"
#include "core/place.hpp"

namespace lavaray {
namespace {

using cimg_library::CImg;

// CImg keeps the channels one after the other.
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

// Bytes before the pixels of a PPM or PFM file that begins like this: four words, between which there may be
// comments, and one blank or line end. 0 where there is no such header.
std::size_t pnmHeaderBytes(std::string_view begin) {
  std::size_t at = 0;
  for (int word = 0; word < 4; ++word) {
    while (at < begin.size() &&
           (std::isspace(static_cast<unsigned char>(begin[at])) != 0 || begin[at] == '#')) {
      at = begin[at] == '#' ? std::min(begin.find('\n', at), begin.size()) : at + 1;
    }
    while (at < begin.size() && std::isspace(static_cast<unsigned char>(begin[at])) == 0) ++at;
  }
  return at < begin.size() ? at + 1 : 0;
}

// Whether the file holds fewer bytes than the pixels that CImg has read from it: the last of them are then
// whatever was in the memory. Of forms that the programs do not write (text, compressed) nothing is known.
bool endsEarly(const std::filesystem::path& file, ImageFormat format, const CImg<float>& image) {
  std::array<unsigned char, 1024> header{};
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  const std::size_t read = stream ? std::fread(header.data(), 1, header.size(), stream.get()) : 0;
  if (read == 0) return true;
  const auto number = [&](std::size_t at, int bytes) {
    std::uintmax_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uintmax_t{header[at + i]} << (8 * i);
    return value;
  };
  const std::uintmax_t values = image.size();
  const std::size_t pnmHeader = pnmHeaderBytes({reinterpret_cast<const char*>(header.data()), read});
  std::uintmax_t needed = 0;
  if (format == ImageFormat::kPfm) needed = pnmHeader + 4 * values;
  if (format == ImageFormat::kPpm && (header[1] == '5' || header[1] == '6')) needed = pnmHeader + values;
  if (format == ImageFormat::kBmp && number(30, 4) == 0) {
    const std::uintmax_t row = (image.width() * number(28, 2) + 31) / 32 * 4;
    needed = number(10, 4) + row * image.height();
  }
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  return !unknown && size < needed;
}

// The system's reason, which CImg does not tell; empty where the file can be read.
std::string whyUnreadable(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (stream) (void)std::fgetc(stream.get());  // where a folder is found out
  return stream && std::ferror(stream.get()) == 0 ? std::string() : std::strerror(errno);
}

}  // namespace

std::optional<ImageFormat> imageFormat(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".bmp") return ImageFormat::kBmp;
  if (ending == ".png") return ImageFormat::kPng;
  if (ending == ".ppm") return ImageFormat::kPpm;
  if (ending == ".pfm") return ImageFormat::kPfm;
  return std::nullopt;
}

void checkBmpSize(int width, int height) {
  const std::uint64_t row = (std::uint64_t{3} * width + 3) / 4 * 4;
  const std::uint64_t bytes = 54 + row * height;
  if (bytes <= 0xFFFFFFFFU) return;
  throw Error(ExitCode::kOutput, "a BMP file of " + std::to_string(width) + " x " + std::to_string(height) +
                                     " pixels would take " + std::to_string(bytes) +
                                     " bytes, at most 4294967295 are allowed; write .png, .ppm or .pfm");
}

std::string formatName(ImageFormat format) {
  switch (format) {
    case ImageFormat::kBmp:
      return "BMP";
    case ImageFormat::kPng:
      return "PNG";
    case ImageFormat::kPpm:
      return "PPM";
    case ImageFormat::kPfm:
      break;
  }
  return "PFM";
}

Image asDisplayed(const Image& image) {
  Image result = image;
  for (float& value : result.rgb) {
    if (!std::isnan(value)) value = static_cast<float>(toByte(std::clamp(value, 0.0F, 1.0F))) / 255.0F;
  }
  return result;
}

void writeImage(const Image& image, ImageFormat format, std::FILE* stream, const TextEntries& texts) {
  if (format == ImageFormat::kBmp) checkBmpSize(image.width, image.height);
  if (format == ImageFormat::kPng) {
    writePng(image, texts, stream);
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

Image readImage(const std::filesystem::path& file) {
  const auto fail = [&](const std::string& why) {
    return Error(ExitCode::kInput, printable(file.native()) + ": " + why);
  };
  const std::optional<ImageFormat> format = imageFormat(file);
  if (!format) throw fail(std::string("its ending says no image format; allowed are ") + kImageFormatNames);
  if (const std::string reason = whyUnreadable(file); !reason.empty())
    throw fail("cannot be read: " + reason);
  if (format == ImageFormat::kPng) return readPng(file);
  CImg<float> loaded;
  try {
    if (format == ImageFormat::kBmp) loaded.load_bmp(file.c_str());
    if (format == ImageFormat::kPpm) loaded.load_pnm(file.c_str());
    if (format == ImageFormat::kPfm) loaded.load_pfm(file.c_str());
  } catch (const cimg_library::CImgException&) {
    throw fail("is not the " + formatName(*format) +
               " image that its ending says, is damaged, or is too large for the memory");
  }
  if (endsEarly(file, *format, loaded)) throw fail("ends before all of its pixels");
  Image image{loaded.width(), loaded.height(), {}};
  const std::size_t pixels = std::size_t(image.width) * image.height;
  const float scale = format == ImageFormat::kPfm ? 1.0F : 255.0F;
  image.rgb.resize(3 * pixels);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    // A grey image has one channel, which stands for all three; a fourth is not looked at.
    const float* plane = loaded.data() + (loaded.spectrum() >= 3 ? channel : 0) * pixels;
    for (std::size_t i = 0; i < pixels; ++i) image.rgb[3 * i + channel] = plane[i] / scale;
  }
  return image;
}

}  // namespace lavaray
