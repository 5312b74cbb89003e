#include "image/image_format.hpp"

#include <algorithm>
#include <cctype>

#include "base/errors.hpp"

namespace lavaray {

std::string lowerCaseExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::optional<ImageFormat> imageFormat(const std::filesystem::path& file) {
  const std::string extension = lowerCaseExtension(file);
  if (extension == ".bmp") return ImageFormat::kBmp;
  if (extension == ".png") return ImageFormat::kPng;
  if (extension == ".ppm") return ImageFormat::kPpm;
  if (extension == ".pfm") return ImageFormat::kPfm;
  if (extension == ".exr") return ImageFormat::kExr;
  return std::nullopt;
}

void checkBmpSize(int width, int height) {
  const std::uint64_t row = (std::uint64_t{3} * width + 3) / 4 * 4;
  const std::uint64_t bytes = 54 + row * height;
  if (bytes <= 0xFFFFFFFFU) return;
  throw Error(ExitCode::kOutput,
              "a BMP file of " + std::to_string(width) + " x " + std::to_string(height) +
                  " pixels would take " + std::to_string(bytes) +
                  " bytes, at most 4294967295 are allowed; write .png, .ppm, .pfm or .exr");
}

std::string formatName(ImageFormat format) {
  switch (format) {
    case ImageFormat::kBmp:
      return "BMP";
    case ImageFormat::kPng:
      return "PNG";
    case ImageFormat::kPpm:
      return "PPM";
    case ImageFormat::kExr:
    case ImageFormat::kExrHalf:
      return "EXR";
    case ImageFormat::kPfm:
      break;
  }
  return "PFM";
}

}  // namespace lavaray
