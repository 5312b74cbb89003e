#include "image/image_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <system_error>

#include "base/byte_reader.hpp"
#include "base/file_claims.hpp"
#include "image/bmp_reader.hpp"
#include "image/encoded_image.hpp"
#include "image/exr_reader.hpp"
#include "image/image_format.hpp"
#include "image/pfm_reader.hpp"
#include "image/png_reader.hpp"
#include "image/pnm_reader.hpp"

namespace lavaray {
namespace {

using namespace std::string_view_literals;

struct Format {
  const char* name;
  std::string_view magic;  // first bytes of a file
  std::string_view extensions;
  Image (*read)(const EncodedImage&);
};

constexpr std::string_view kPnmExtensions = ".ppm .pgm .pbm .pnm ";
constexpr std::array kFormats{
    Format{"PNG", "\x89PNG\r\n\x1A\n"sv, ".png ", readPng},
    Format{"BMP", "BM"sv, ".bmp .dib ", readBmp},
    Format{"PBM", "P1"sv, kPnmExtensions, readPnm},
    Format{"PGM", "P2"sv, kPnmExtensions, readPnm},
    Format{"PPM", "P3"sv, kPnmExtensions, readPnm},
    Format{"PBM", "P4"sv, kPnmExtensions, readPnm},
    Format{"PGM", "P5"sv, kPnmExtensions, readPnm},
    Format{"PPM", "P6"sv, kPnmExtensions, readPnm},
    Format{"PFM", "PF"sv, ".pfm ", readPfm},
    Format{"PFM", "Pf"sv, ".pfm ", readPfm},
    Format{"EXR", "\x76\x2F\x31\x01"sv, ".exr ", readExr},
};
constexpr const char* kAllowed = "allowed are BMP, PNG, PPM, PGM, PBM, PFM and EXR";

// Other kinds of files, which are refused by name.
struct OtherKind {
  const char* name;
  std::string_view magic;
  std::size_t at = 0;
};
constexpr std::array kOtherKinds{
    OtherKind{"a JPEG image", "\xFF\xD8\xFF"sv},
    OtherKind{"a JPEG XL image", "\xFF\x0A"sv},
    OtherKind{"a JPEG XL image", "\0\0\0\x0CJXL "sv},
    OtherKind{"a JPEG 2000 image", "\0\0\0\x0CjP  "sv},
    OtherKind{"a GIF image", "GIF8"sv},
    OtherKind{"a TIFF image", "II*\0"sv},
    OtherKind{"a TIFF image", "MM\0*"sv},
    OtherKind{"a TIFF image", "II+\0"sv},
    OtherKind{"a WebP image", "WEBP"sv, 8},
    OtherKind{"an AVIF or HEIF image", "ftyp"sv, 4},
    OtherKind{"a Radiance image", "#?R"sv},
    OtherKind{"a PAM image", "P7"sv},
    OtherKind{"an OS/2 array of bitmaps", "BA"sv},
    OtherKind{"a Windows icon", "\0\0\x01\0"sv},
    OtherKind{"a Photoshop image", "8BPS"sv},
    OtherKind{"a compressed file", "\x1F\x8B"sv},
    OtherKind{"a compressed file", "BZh"sv},
    OtherKind{"a compressed file",
              "\xFD"
              "7zXZ"sv},
};

constexpr std::size_t kBeginning = 64;  // enough to tell the kind

// In netpbm's formats, white space or a comment follows the two letters. Requiring it keeps text that begins
// with such letters, and PF4 files, from being taken for them.
bool isOf(const Format& format, std::string_view bytes) {
  if (!bytes.starts_with(format.magic)) return false;
  if (format.magic[0] != 'P') return true;
  return bytes.size() > 2 && (std::isspace(static_cast<unsigned char>(bytes[2])) != 0 || bytes[2] == '#');
}

const Format& formatOf(const EncodedImage& file) {
  if (file.bytes.empty()) file.fail("is empty; " + std::string(kAllowed));
  for (const Format& format : kFormats) {
    if (isOf(format, file.bytes)) return format;
  }
  for (const OtherKind& kind : kOtherKinds) {
    if (file.bytes.size() >= kind.at && file.bytes.substr(kind.at).starts_with(kind.magic)) {
      file.fail(std::string("is ") + kind.name + ", which is not read; " + kAllowed);
    }
  }
  file.fail("is no image that can be read; " + std::string(kAllowed));
}

// An extension that belongs to another format than the file's bytes is not an error, but worth a note.
void noteWrongExtension(const std::filesystem::path& file, const Format& format, ImageSource& source) {
  const std::string extension = lowerCaseExtension(file) + " ";
  if (format.extensions.find(extension) != std::string_view::npos) return;
  for (const Format& other : kFormats) {
    if (extension.size() > 1 && other.extensions.find(extension) != std::string_view::npos) {
      source.notes.push_back(std::string("is read as the ") + format.name +
                             " image that it is, not as its ending says");
      return;
    }
  }
}

// Reads a file only if it begins like an image; any other may never end.
std::string readBytes(const std::filesystem::path& file) {
  noteRead(file, "the image");
  try {
    ByteReader reader(file);
    std::string bytes(kBeginning, '\0');
    bytes.resize(reader.read(bytes));
    (void)formatOf({bytes, file});
    return bytes.size() < kBeginning ? bytes : readAll(reader, bytes, expectedSize(file));
  } catch (const std::system_error& error) {
    failUnreadable(file, error);
  }
}

}  // namespace

Image parseImage(std::string_view bytes, const std::filesystem::path& file) {
  const EncodedImage encoded{bytes, file};
  const Format& format = formatOf(encoded);
  Image image = format.read(encoded);
  image.source.format = format.name;
  noteWrongExtension(file, format, image.source);
  return image;
}

bool hasImageExtension(const std::filesystem::path& file) {
  const std::string extension = lowerCaseExtension(file) + " ";
  return extension.size() > 1 && std::any_of(kFormats.begin(), kFormats.end(), [&](const Format& format) {
           return format.extensions.find(extension) != std::string_view::npos;
         });
}

Image readImage(const std::filesystem::path& file) {
  return parseImage(readBytes(file), file);
}

}  // namespace lavaray
