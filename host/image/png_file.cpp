#include "image/png_file.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <new>

#include "core/errors.hpp"
#include "core/place.hpp"
#include "image/image_file.hpp"

namespace lavaray {
namespace {

void onWarning(png_structp /*png*/, png_const_charp /*message*/) {}

void onError(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

// Returns false where libpng found an error, which leaves `body` by longjmp: nothing that has a destructor
// may live in it.
template <typename Body>
bool succeeds(png_structp png, const Body& body) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
}

// Points into the entries.
std::vector<png_text> pngTexts(const TextEntries& entries) {
  std::vector<png_text> texts;
  for (const auto& [keyword, text] : entries) {
    png_text entry{};
    entry.compression = isAscii(text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<png_charp>(keyword.c_str());  // libpng copies both
    entry.text = const_cast<png_charp>(text.c_str());
    texts.push_back(entry);
  }
  return texts;
}

// A file that is read as PNG.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {
    stream_.reset(std::fopen(file.c_str(), "rb"));
    if (!stream_) fail(std::string("cannot be read: ") + std::strerror(errno));
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, onError, onWarning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }

  // Throws Error(kInput) where libpng finds an error.
  template <typename Body>
  void run(const Body& body) {
    const bool isRead = succeeds(png_, [&] {
      png_init_io(png_, stream_.get());
      body(png_, info_);
    });
    if (!isRead) fail("is no PNG image or is damaged: " + message_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(ExitCode::kInput, printable(file_.native()) + ": " + why);
  }

  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  const std::filesystem::path& file_;
  std::unique_ptr<std::FILE, Close> stream_;
  std::string message_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

struct PngWriter::Library {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string message = "libpng cannot be started";
  ~Library() { png_destroy_write_struct(&png, &info); }

  // What goes wrong in the stream itself is for its owner to tell.
  template <typename Body>
  void run(std::FILE* stream, const Body& body) {
    if (!succeeds(png, body) && std::ferror(stream) == 0) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(ExitCode::kOutput, "the image cannot be written: " + message);
  }
};

PngWriter::PngWriter(int width, int height, const TextEntries& entries, std::FILE* stream)
    : library_(std::make_unique<Library>()), stream_(stream), row_(std::size_t{3} * width) {
  Library& l = *library_;
  l.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &l.message, onError, onWarning);
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

void writePng(const Image& image, const TextEntries& entries, std::FILE* stream) {
  PngWriter png(image.width, image.height, entries, stream);
  const std::size_t rowSize = std::size_t{3} * image.width;
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    png.writeRow(std::span(image.rgb).subspan(y * rowSize, rowSize));
  }
  png.finish({});
}

TextEntries readPngTexts(const std::filesystem::path& file) {
  Reader reader(file);
  std::vector<png_byte> row;
  reader.run([&](png_structp png, png_infop info) {
    png_read_info(png, info);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    row.resize(png_get_rowbytes(png, info));
    const png_uint_32 rows = static_cast<png_uint_32>(passes) * png_get_image_height(png, info);
    for (png_uint_32 y = 0; y < rows; ++y) png_read_row(png, row.data(), nullptr);
    png_read_end(png, info);
  });
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png(), reader.info(), &texts, nullptr);
  TextEntries entries;
  for (int i = 0; i < count; ++i) {
    entries.emplace_back(texts[i].key, texts[i].text == nullptr ? "" : texts[i].text);
  }
  return entries;
}

Image readPng(const std::filesystem::path& file) {
  Reader reader(file);
  reader.run([](png_structp png, png_infop info) {
    png_read_png(
        png, info,
        PNG_TRANSFORM_EXPAND | PNG_TRANSFORM_GRAY_TO_RGB | PNG_TRANSFORM_SCALE_16 | PNG_TRANSFORM_STRIP_ALPHA,
        nullptr);
  });
  Image image{static_cast<int>(png_get_image_width(reader.png(), reader.info())),
              static_cast<int>(png_get_image_height(reader.png(), reader.info())),
              {}};
  const png_bytepp rows = png_get_rows(reader.png(), reader.info());
  const std::size_t rowSize = std::size_t{3} * image.width;
  image.rgb.reserve(rowSize * image.height);
  for (int y = 0; y < image.height; ++y) {
    std::transform(rows[y], rows[y] + rowSize, std::back_inserter(image.rgb),
                   [](png_byte byte) { return static_cast<float>(byte) / 255.0F; });
  }
  return image;
}

}  // namespace lavaray
