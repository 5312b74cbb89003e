#include "image/png_writer.hpp"

#include <png.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/errors.hpp"
#include "image/png_common.hpp"

namespace lavaray {
namespace {

void onWarning(png_structp /*png*/, png_const_charp /*message*/) {}

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
}

// The result points into the entries.
std::vector<png_text> pngTexts(const TextEntries& entries) {
  std::vector<png_text> texts;
  for (const auto& [keyword, text] : entries) {
    png_text entry{};
    entry.compression = isAscii(text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<png_charp>(keyword.c_str());  // libpng copies key and text
    entry.text = const_cast<png_charp>(text.c_str());
    texts.push_back(entry);
  }
  return texts;
}

}  // namespace

struct PngWriter::Library {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string message = "libpng cannot be started";
  ~Library() { png_destroy_write_struct(&png, &info); }

  // Errors of the stream itself are for its owner to report.
  template <typename Body>
  void run(std::FILE* stream, const Body& body) {
    if (!pngSucceeds(png, body) && std::ferror(stream) == 0) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(ExitCode::kOutput, "the image cannot be written: " + message);
  }
};

PngWriter::PngWriter(int width, int height, const TextEntries& entries, std::FILE* stream)
    : library_(std::make_unique<Library>()), stream_(stream), row_(std::size_t{3} * width) {
  Library& l = *library_;
  l.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &l.message, onPngError, onWarning);
  if (l.png != nullptr) l.info = png_create_info_struct(l.png);
  if (l.info == nullptr) l.fail();
  const std::vector<png_text> texts = pngTexts(entries);
  l.run(stream_, [&] {
    png_init_io(l.png, stream);
    png_set_IHDR(l.png, l.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_text(l.png, l.info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(l.png, l.info);
  });
}

PngWriter::~PngWriter() = default;

void PngWriter::writeRow(std::span<const float> rgb) {
  std::transform(rgb.begin(), rgb.end(), row_.begin(), toByte);
  library_->run(stream_, [&] { png_write_row(library_->png, row_.data()); });
}

void PngWriter::finish(const TextEntries& entries) {
  Library& l = *library_;
  const std::vector<png_text> texts = pngTexts(entries);
  l.run(stream_, [&] {
    png_set_text(l.png, l.info, texts.data(), static_cast<int>(texts.size()));
    png_write_end(l.png, l.info);
  });
}

}  // namespace lavaray
