#include "image/png_reader.hpp"

#include <png.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.hpp"
#include "image/byte_order.hpp"
#include "image/png_common.hpp"

namespace lavaray {
namespace {

// libpng would allocate memory for a whole chunk before it found that the file ends within it.
void checkChunkLengths(const EncodedImage& file) {
  constexpr std::size_t kFraming = 12;  // length, kind and checksum
  const std::size_t size = file.bytes.size();
  std::size_t at = 8;
  while (at + kFraming <= size) {
    const std::uint32_t length = fromBigEndian(file.bytes.substr(at, 4));
    if (length > size - at - kFraming) file.failAsCutOff();
    if (file.bytes.substr(at + 4, 4) == "IEND") return;
    at += kFraming + length;
  }
}

// Reads one file with libpng.
class Reader {
 public:
  explicit Reader(const EncodedImage& file) : file_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, onPngError, onReadWarning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, this, onRead);
    // Damage to a transparency chunk must not yield an opaque image.
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Image read() {
    run([&] { png_read_info(png_, info_); });
    Image image;
    image.source.maxima = maxima();
    addNotes(image.source.notes);
    // Deflate expands one byte to at most 1032, and each row has one extra byte.
    const std::uint64_t rowBytes = png_get_rowbytes(png_, info_) + 1;
    if (rowBytes * png_get_image_height(png_, info_) / 1032 > file_.bytes.size()) file_.failAsCutOff();
    run([&] {
      if (isPalette()) {
        png_set_packing(png_);  // one index per byte: libpng would turn one beyond the palette into black
      } else {
        png_set_expand(png_);  // transparency to alpha, 1 to 4 bits to 8
        png_set_gray_to_rgb(png_);
      }
      (void)png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    readRows();
    image.source.texts = texts();
    ImageSource source = std::move(image.source);
    image = file_.blankImage(png_get_image_width(png_, info_), png_get_image_height(png_, info_));
    image.source = std::move(source);
    if (isPalette()) {
      fillFromPalette(image);
    } else {
      fill(image);
    }
    return image;
  }

 private:
  // Throws Error(kInput) if libpng finds an error.
  template <typename Body>
  void run(const Body& body) {
    if (!pngSucceeds(png_, body)) file_.fail("is no PNG image or is damaged: " + message_);
  }

  static void onRead(png_structp png, png_bytep to, std::size_t count) {
    auto& reader = *static_cast<Reader*>(png_get_io_ptr(png));
    if (reader.file_.bytes.size() - reader.at_ < count) png_error(png, "ends before all of its pixels");
    std::memcpy(to, reader.file_.bytes.data() + reader.at_, count);
    reader.at_ += count;
  }

  // libpng ignores such a chunk if it is bad, but that would change the image.
  static void onReadWarning(png_structp png, png_const_charp message) {
    const std::string_view text = message;
    if (text.starts_with("tRNS") || text.starts_with("PLTE")) png_error(png, message);
  }

  [[nodiscard]] std::array<std::uint32_t, 4> maxima() const {
    const std::uint32_t maximum = isPalette() ? 255U : (1U << png_get_bit_depth(png_, info_)) - 1U;
    const bool hasOneColor = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0 && !isPalette();
    return {maximum, maximum, maximum, hasOneColor ? 1U : maximum};
  }

  [[nodiscard]] TextEntries texts() const {
    png_textp texts = nullptr;
    const int count = png_get_text(png_, info_, &texts, nullptr);
    TextEntries entries;
    for (int i = 0; i < count; ++i) {
      entries.emplace_back(texts[i].key, texts[i].text == nullptr ? "" : texts[i].text);
    }
    return entries;
  }

  void addNotes(std::vector<std::string>& notes) const {
    constexpr double kOfSrgb = 0.45455;
    double gamma = kOfSrgb;
    const bool isSrgb = png_get_valid(png_, info_, PNG_INFO_sRGB) != 0;
    if (!isSrgb && png_get_valid(png_, info_, PNG_INFO_gAMA) != 0) (void)png_get_gAMA(png_, info_, &gamma);
    if (std::abs(gamma - kOfSrgb) > 0.001) {
      notes.push_back("its gamma of " + numberText(gamma) +
                      " (gAMA) is not applied; viewers that do show it otherwise");
    }
    if (png_get_valid(png_, info_, PNG_INFO_iCCP) != 0) {
      notes.emplace_back("its colour profile (iCCP) is not applied");
    }
  }

  void readRows() {
    const std::uint64_t rowBytes = png_get_rowbytes(png_, info_);
    const std::uint64_t height = png_get_image_height(png_, info_);
    pixels_.resize(rowBytes * height);
    rows_.resize(height);
    for (std::size_t y = 0; y < height; ++y) rows_[y] = pixels_.data() + y * rowBytes;
    run([&] {
      png_read_image(png_, rows_.data());
      png_read_end(png_, info_);
    });
  }

  void fill(Image& image) const {
    const std::size_t channels = png_get_channels(png_, info_);
    const std::size_t bytes = png_get_bit_depth(png_, info_) / 8U;
    if (channels == 4) image.alpha.resize(image.rgb.size() / 3);
    const png_byte* byte = pixels_.data();
    for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
      for (std::size_t channel = 0; channel < channels; ++channel, byte += bytes) {
        const std::uint32_t value = bytes == 2 ? std::uint32_t{byte[0]} << 8 | byte[1] : byte[0];
        float& to = channel < 3 ? image.rgb[3 * i + channel] : image.alpha[i];
        to = quotient(value, bytes == 2 ? 65535 : 255);
      }
    }
  }

  void fillFromPalette(Image& image) const {
    png_colorp palette = nullptr;
    png_bytep alphas = nullptr;
    int colorCount = 0;
    int alphaCount = 0;
    (void)png_get_PLTE(png_, info_, &palette, &colorCount);
    (void)png_get_tRNS(png_, info_, &alphas, &alphaCount, nullptr);
    if (alphaCount > 0) image.alpha.resize(image.rgb.size() / 3);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const int index = pixels_[i];
      if (index >= colorCount) file_.fail("is a damaged PNG image: a pixel's colour is beyond its palette");
      const png_color& color = palette[index];
      image.rgb[3 * i] = quotient(color.red, 255);
      image.rgb[3 * i + 1] = quotient(color.green, 255);
      image.rgb[3 * i + 2] = quotient(color.blue, 255);
      if (alphaCount > 0) image.alpha[i] = index < alphaCount ? quotient(alphas[index], 255) : 1.0F;
    }
  }

  [[nodiscard]] bool isPalette() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE; }

  const EncodedImage& file_;
  std::size_t at_ = 0;
  std::string message_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<png_byte> pixels_;
  std::vector<png_bytep> rows_;
};

}  // namespace

Image readPng(const EncodedImage& file) {
  checkChunkLengths(file);
  return Reader(file).read();
}

}  // namespace lavaray
