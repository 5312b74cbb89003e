#ifndef LAVARAY_IMAGE_H
#define LAVARAY_IMAGE_H

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lavaray/files.h>
#include <lavaray/statistics.h>
#include <lavaray/types.h>

// Pictures as arrays, in files, and how two of them differ.
namespace lavaray::v0 {

// Reads BMP, PNG, PPM, PGM, PBM, PFM and EXR files in full depth; the bytes decide which format it is,
// whatever the file's extension. An integer v of a file becomes v / maximum, rounded once. Throws
// Error(kInput).
LAVARAY_API Image readImage(const std::filesystem::path& file);
// The same from the file's bytes; `file` is its name for messages.
LAVARAY_API Image parseImage(std::string_view bytes, const std::filesystem::path& file);

// By the file's extension, in upper or lower case; empty for any other extension.
LAVARAY_API std::optional<ImageFormat> imageFormat(const std::filesystem::path& file);

// Writes the image in the format that the file's extension says, its alpha left out. The file appears whole
// or not at all. Only PNG and EXR files hold the texts. In formats of 8 bits values are clamped to [0, 1],
// and a NaN is 0. Throws Error(kOutput), and Error(kUsage) for other extensions.
LAVARAY_API void writeImage(const Image& image, const std::filesystem::path& file,
                            const TextEntries& texts = {});

// Writes it to a file that is to be committed afterwards.
LAVARAY_API void writeImage(const Image& image, ImageFormat format, OutputFile& file,
                            const TextEntries& texts = {});

// Writes an image row by row from the top, so that it need not be in memory as a whole.
class LAVARAY_API ImageWriter {
 public:
  // The file must outlive it, and is to be committed after finish(). BMP, PFM and EXR need one that is not a
  // pipe. Throws Error(kOutput) if the image is too large for the format.
  ImageWriter(OutputFile& file, ImageFormat format, const ImageSize& size, const TextEntries& texts = {});
  ~ImageWriter();
  ImageWriter(ImageWriter&&) noexcept;
  ImageWriter& operator=(ImageWriter&&) noexcept;

  // The next row, of 3 * width values in [0, 1]. Throws Error(kOutput) as soon as something could not be
  // written.
  void write(const float* rgb);
  // After the last row, with texts that were not known before it, for which EXR has no place.
  void finish(const TextEntries& texts = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The same for an EXR file of numbers as they are, `channels` (1 or 3) for each pixel, in 32 bits.
class LAVARAY_API LayerWriter {
 public:
  LayerWriter(OutputFile& file, Layer layer, const ImageSize& size, const TextEntries& texts = {});
  ~LayerWriter();
  LayerWriter(LayerWriter&&) noexcept;
  LayerWriter& operator=(LayerWriter&&) noexcept;

  // The next values, row by row, `count` of them.
  void write(const float* values, std::size_t count);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Throws Error(kOutput) if a file of that format cannot hold an image of that size.
LAVARAY_API void checkSize(ImageFormat format, const ImageSize& size);

// Scales the values so that the largest becomes 1; a black image stays black. Returns the former largest
// value, or 0.
LAVARAY_API float normalize(Image& image);
// The part inside the rectangle. Throws Error(kUsage) if that does not lie within the image.
LAVARAY_API Image crop(const Image& image, const Rectangle& part);
// The rectangle, or without one all of an image of `size`. Throws Error(kUsage) if it does not lie within
// that.
LAVARAY_API Rectangle cropWithin(const std::optional<Rectangle>& part, const ImageSize& size);
// Replaces pixels whose channels are equal by colours for their values: black, blue, crimson, orange, yellow,
// white.
LAVARAY_API void applyFalseColors(std::vector<float>& rgb);
// The 8-bit level of a value in [0, 1].
inline std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(255.0 * static_cast<double>(value));
}

// These throw Error(kUsage) if the images differ in size.
// Channels that are off by no more than `tolerance` do not differ.
LAVARAY_API Difference compare(const Image& image, const Image& reference, double tolerance = 0.0);
// The peak signal-to-noise ratio in dB, for a peak of 1; infinite for an error of 0.
LAVARAY_API double psnr(double rmse);
// |image - reference|, scaled so that the largest difference is 1. A difference of alpha shows as grey where
// it is larger than those of the colours. Magenta marks infinities and NaNs that are not in both images.
LAVARAY_API Image differencePicture(const Image& image, const Image& reference);
// An image of floats as it would be in a file like the one that the other image, of integers, was read from:
// a value c becomes trunc(maximum c) / maximum. Values that equal the other image's, and values that are not
// finite, stay.
LAVARAY_API Image asWritten(const Image& floats, const Image& integers);

// FLIP of each pixel, from 0 (they look the same) to 1, row by row from the top: how different two images
// look to someone who alternates between them, on a display 0.7 m wide with 3840 pixels, from 0.7 m. The
// values are taken to be sRGB-encoded and in [0, 1]. Within about ten pixels of a NaN the result is NaN too.
LAVARAY_API std::vector<float> flipMap(const Image& image, const Image& reference);
// The mean of the two as a display shows them, over the pixels that are finite in both. Two images of floats
// are first quantised as in an 8-bit file. Images with alpha are composited over black and over white; the
// larger mean counts.
LAVARAY_API double meanFlip(const Image& image, const Image& reference);

struct ComparedPair {
  ImagePair pair;
  Verdict verdict = Verdict::kUnreadable;
  std::string problem;           // why a file cannot be read
  const Image* image = nullptr;  // these two: null if it could not be read
  const Image* reference = nullptr;
  std::string comparedAs;  // if one has floats and the other integers, how, in words
  Difference difference;   // these two: if they are alike or differ
  double flip = 0.0;       // mean
  struct Details;
  std::shared_ptr<const Details> details;  // owns the images
};

// Reads and compares the two. What is wrong with a file becomes `problem`.
LAVARAY_API ComparedPair comparePair(const ImagePair& pair);
// The images in two folders, and in those inside of them, whose names are the same or, where there is no such
// partner, differ in the extension only; and those without a partner. Throws Error(kInput).
LAVARAY_API std::vector<ImagePair> pairsOfFolders(const std::filesystem::path& images,
                                                  const std::filesystem::path& references);
// The pairs in a report in JSON. Throws Error(kInput).
LAVARAY_API std::vector<ImagePair> readPairs(const std::filesystem::path& json);

}  // namespace lavaray::v0

#endif
