#ifndef LAVARAY_TYPES_H
#define LAVARAY_TYPES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <lavaray/error.h>

// Plain data of which several headers speak. The library itself works with these types, too.
namespace lavaray::v0 {

struct ImageSize {
  int width = 0;  // in pixels
  int height = 0;
  bool operator==(const ImageSize& other) const { return width == other.width && height == other.height; }
};

// The pixels x0 <= x < x1, y0 <= y < y1 of an image; y counts from the top.
struct Rectangle {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  bool operator==(const Rectangle& other) const {
    return x0 == other.x0 && y0 == other.y0 && x1 == other.x1 && y1 == other.y1;
  }

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width()) * static_cast<std::uint64_t>(height());
  }
};

// Keywords and texts, such as a PNG file carries. A keyword has 1 to 79 ASCII characters.
using TextEntries = std::vector<std::pair<std::string, std::string>>;

// What the file that an image was read from says apart from its pixels.
struct ImageSource {
  std::string format;  // "PNG", say; empty for an image that was not read
  // The integers of red, green, blue and alpha that stand for 1 in the file; 0 if it holds floats.
  std::array<std::uint32_t, 4> maxima{};
  // For the user: what programs treat in different ways, and what was done here.
  std::vector<std::string> notes;
  TextEntries texts;
};

// Colours in [0, 1], three floats per pixel, row by row from the top. From a file of floats they may be
// anything.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  std::vector<float> alpha{};  // one per pixel; empty if the image has none, and so is opaque
  ImageSource source{};
};

// The formats that images are written in.
enum class ImageFormat {
  kBmp,      // 8 bits a channel: trunc(255 c)
  kPng,      // likewise
  kPpm,      // likewise
  kPfm,      // the float values as they are
  kExr,      // the linear light of the values, which are taken to be sRGB-encoded
  kExrHalf,  // likewise, 16 bits a channel; no file extension stands for this one
};
inline constexpr const char* kImageFormatNames = ".bmp, .png, .ppm, .pfm, .exr";

// What a picture shows.
enum class View {
  kColor,
  kNormal,   // n / 2 + 1/2 for the unit normal n used for shading
  kDepth,    // distance from the camera, relative to the largest
  kObject,   // a colour for each object
  kShadow,   // share of the lights that are not blocked
  kCost,     // nodes and primitives that rays are tested against, relative to the largest number
  kSamples,  // samples of each pixel, relative to the largest number
  kError,    // estimated error of each pixel, in units of a colour; needs a target error
};
inline constexpr const char* kViewNames = "color, normal, depth, object, shadow, cost, samples, error";

// Numbers for each pixel that go with a picture, for compositing programs. What is seen is seen by the ray
// through the pixel's centre, whatever the picture's samples: the mean of two depths or objects would be
// neither of them.
enum class Layer {
  kNormal,   // the unit normal used for shading, on the side that is seen; 0 0 0 where there is nothing
  kDepth,    // distance from the camera along the ray, in the scene's units; infinite where there is nothing
  kObject,   // number among the file's objects with a material, from 1; 0 where there is nothing
  kSamples,  // samples of the picture's pixel
  kError,    // its estimated error, in units of a colour; needs a target error
};
inline constexpr const char* kLayerNames = "normal, depth, object, samples, error";

// Reconstruction filters, separable; sampled by importance, so that every sample has the same weight.
enum class PixelFilter {
  kBox,             // the pixel itself
  kTent,            // to 1 pixel from the centre
  kGaussian,        // standard deviation 1/2 pixel, to 1.5 pixels
  kBlackmanHarris,  // to 1.5 pixels
};
inline constexpr const char* kPixelFilterNames = "box, tent, gaussian, blackman-harris";

// How samples are placed in a pixel and on a light.
enum class Sampler {
  kSobol,   // Owen-scrambled Sobol points
  kRandom,  // independent random numbers; for comparison
};
inline constexpr const char* kSamplerNames = "sobol, random";

// Samples first <= i < end of each pixel's sequence.
struct SampleRange {
  std::uint32_t first;
  std::uint32_t end;
  bool operator==(const SampleRange& other) const { return first == other.first && end == other.end; }
};

// Which rays a picture is made of.
struct SamplingOptions {
  View view = View::kColor;
  std::uint32_t maxDepth = 8;  // mirror bounces, at most 1000
  std::uint32_t samples = 1;   // a pixel, 1 to 2^22; 1 is its centre
  // Only these of them, for a film; their bounds are multiples of 4, or all samples.
  std::optional<SampleRange> range;
  Sampler sampler = Sampler::kSobol;
  PixelFilter filter = PixelFilter::kBox;
  std::uint32_t seed = 0;
  // In place of `samples`: sample until the picture's RMSE is estimated to be at most this, from 1e-6 to 1,
  // with at most maxSamples, 2 to 2^22, a pixel. For the views color, samples and error.
  std::optional<double> targetError;
  std::uint32_t maxSamples = 65536;
  std::optional<double> timeLimitSeconds;
};

// Why a render has ended.
enum class StopReason {
  kFinished,    // all samples are taken, or the target error is reached
  kMaxSamples,  // every pixel that wants more samples has as many as allowed
  kTimeLimit,
  kInterrupted,
};

}  // namespace lavaray::v0

#endif
