#include "image/encoded_image.hpp"

#include "base/errors.hpp"
#include "base/printable.hpp"

namespace lavaray {
namespace {

// With 16 bytes a pixel no product of sizes is beyond 64 bits.
constexpr std::int64_t kMostPixelsASide = 1'000'000;

}  // namespace

void ImageBytes::fail(const std::string& why) const {
  throw Error(ExitCode::kInput, printable(file.native()) + ": " + why);
}

void ImageBytes::failAsCutOff() const {
  fail("ends before all of its pixels");
}

std::uint32_t ImageBytes::little(std::size_t at, std::size_t count) const {
  if (at > bytes.size() || count > bytes.size() - at) fail("ends in the middle of its header");
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

void ImageBytes::checkSides(std::int64_t width, std::int64_t height) const {
  if (width >= 1 && height >= 1 && width <= kMostPixelsASide && height <= kMostPixelsASide) return;
  fail("has " + std::to_string(width) + " x " + std::to_string(height) +
       " pixels by its header; allowed are 1 to " + std::to_string(kMostPixelsASide) + " a side");
}

Image ImageBytes::blankImage(std::int64_t width, std::int64_t height) const {
  checkSides(width, height);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return image;
}

}  // namespace lavaray
