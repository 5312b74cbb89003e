#include "image/encoded_image.hpp"

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "image/byte_order.hpp"

namespace lavaray {
namespace {

// With up to 16 bytes per pixel, no product of sizes exceeds 64 bits.
constexpr std::int64_t kMaxSide = 1'000'000;

}  // namespace

void EncodedImage::fail(const std::string& why) const {
  throw Error(ExitCode::kInput, printable(file.native()) + ": " + why, file.string());
}

void EncodedImage::failAsCutOff() const {
  fail("ends before all of its pixels");
}

std::uint32_t EncodedImage::littleEndian(std::size_t at, std::size_t count) const {
  if (at > bytes.size() || count > bytes.size() - at) fail("ends in the middle of its header");
  return fromLittleEndian(bytes.substr(at, count));
}

void EncodedImage::checkSides(std::int64_t width, std::int64_t height) const {
  if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide) return;
  fail("has " + std::to_string(width) + " x " + std::to_string(height) +
       " pixels by its header; allowed are 1 to " + std::to_string(kMaxSide) + " a side");
}

Image EncodedImage::blankImage(std::int64_t width, std::int64_t height) const {
  checkSides(width, height);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return image;
}

}  // namespace lavaray
