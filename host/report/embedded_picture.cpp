#include "report/embedded_picture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "image/png_writer.hpp"

namespace lavaray {
namespace {

// A file in memory.
class MemoryFile {
 public:
  MemoryFile() : stream_(open_memstream(&bytes_, &size_)) {
    if (stream_ == nullptr) throw std::bad_alloc();
  }
  ~MemoryFile() {
    std::fclose(stream_);
    std::free(bytes_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  [[nodiscard]] std::FILE* stream() const { return stream_; }
  [[nodiscard]] std::string_view bytes() const {
    if (std::fflush(stream_) != 0) throw std::bad_alloc();
    return {bytes_, size_};
  }

 private:
  char* bytes_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;
};

std::string base64(std::string_view bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

// A value that PngWriter writes as this byte.
float written(std::uint8_t byte) {
  return (static_cast<float>(byte) + 0.5F) / 255.0F;
}

// `byteAt(i)` is the i-th byte of the picture.
template <typename ByteAt>
std::string picture(int width, int height, const ByteAt& byteAt) {
  MemoryFile file;
  PngWriter writer(width, height, {}, file.stream());
  std::vector<float> row(std::size_t{3} * width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = written(byteAt(y * row.size() + i));
    writer.writeRow(row);
  }
  writer.finish({});
  return base64(file.bytes());
}

float chequered(int x, int y) {
  return ((x / 8 + y / 8) % 2 == 0) ? 0.4F : 0.6F;
}

std::uint8_t shownLevel(const Image& image, std::size_t i) {
  const std::size_t pixel = i / 3;
  const bool isNumber = std::none_of(&image.rgb[3 * pixel], &image.rgb[3 * pixel] + 3,
                                     [](float value) { return std::isnan(value); });
  if (!isNumber) return i % 3 == 1 ? 0 : 255;
  const float value = std::clamp(image.rgb[i], 0.0F, 1.0F);
  if (image.source.maxima[i % 3] == 255 && image.alpha.empty()) {
    return static_cast<std::uint8_t>(std::lround(255.0F * value));
  }
  if (image.alpha.empty()) return toByte(value);
  const float alpha = std::isnan(image.alpha[pixel]) ? 1.0F : std::clamp(image.alpha[pixel], 0.0F, 1.0F);
  const auto width = static_cast<std::size_t>(image.width);
  const float behind = chequered(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  return toByte(alpha * value + (1.0F - alpha) * behind);
}

std::uint8_t byteOf(float value, std::size_t k) {
  return static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(value) >> (8 * k));
}

}  // namespace

std::string shownPicture(const Image& image) {
  return picture(image.width, image.height, [&](std::size_t i) { return shownLevel(image, i); });
}

bool isShownExactly(const Image& image) {
  const auto& maxima = image.source.maxima;
  return image.alpha.empty() &&
         std::all_of(maxima.begin(), maxima.begin() + 3, [](auto m) { return m == 255; });
}

std::string valuesPicture(const Image& image) {
  const std::size_t size = image.rgb.size();
  const int copies = image.alpha.empty() ? 4 : 8;
  return picture(image.width, copies * image.height, [&](std::size_t i) {
    const std::size_t copy = i / size;
    return copy < 4 ? byteOf(image.rgb[i % size], copy) : byteOf(image.alpha[i % size / 3], copy - 4);
  });
}

std::string greyPicture(int width, int height, const std::vector<float>& values) {
  return picture(width, height, [&](std::size_t i) { return toByte(std::clamp(values[i / 3], 0.0F, 1.0F)); });
}

}  // namespace lavaray
