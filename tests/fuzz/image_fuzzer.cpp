// Any bytes as an image file: it is refused with a message or it is an image.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "base/errors.hpp"
#include "fuzz/checks.hpp"
#include "image/image_reader.hpp"

namespace lavaray::fuzz {
namespace {

bool isQuotient(float value) {
  return value >= 0.0F && value <= 1.0F;
}

void checkImage(const Image& image) {
  const std::size_t pixels = std::size_t(image.width) * image.height;
  require(image.width > 0 && image.height > 0 && image.rgb.size() == 3 * pixels, "an image has pixels");
  require(image.alpha.empty() || image.alpha.size() == pixels, "each pixel has an alpha, or none");
  require(!image.source.format.empty(), "an image has a format");
  if (image.source.maxima[0] == 0) {
    require(image.source.format == "PFM" && image.source.maxima[1] == 0 && image.source.maxima[2] == 0,
            "only PFM holds floats");
    return;
  }
  require(image.source.maxima[1] > 0 && image.source.maxima[2] > 0, "each colour has a maximum");
  require(std::ranges::all_of(image.rgb, isQuotient) && std::ranges::all_of(image.alpha, isQuotient),
          "a quotient is from 0 to 1");
}

void checkRefusal(const Error& error) {
  const std::string_view message = error.what();
  require(error.exitCode() == ExitCode::kInput && message.starts_with("image: ") && message.size() > 10,
          "a complaint is about the file");
  require(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7F; }),
          "a complaint can be printed");
}

}  // namespace
}  // namespace lavaray::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lavaray;
  static const std::filesystem::path file = "image";
  try {
    fuzz::checkImage(parseImage({reinterpret_cast<const char*>(data), size}, file));
  } catch (const Error& error) {
    fuzz::checkRefusal(error);
  }
  return 0;
}
