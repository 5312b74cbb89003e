#include "report/pair.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "image/image_reader.hpp"

namespace lavaray {
namespace {

bool holdsFloats(const Image& image) {
  return image.source.maxima[0] == 0;
}

// trunc(255 c), or several of these if the channels have different maxima.
std::string truncation(const Image& integers) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string one = "trunc(" + std::to_string(integers.source.maxima[i]) + " c)";
    if (text.find(one) == std::string::npos) text += (text.empty() ? "" : ", ") + one;
  }
  return text;
}

// Returns how in words. Does nothing unless one image has floats and the other integers.
std::string compareAsWritten(Image& image, Image& reference) {
  if (holdsFloats(image) == holdsFloats(reference)) return {};
  const bool isImage = holdsFloats(image);
  Image& floats = isImage ? image : reference;
  const Image& integers = isImage ? reference : image;
  floats = asWritten(floats, integers);
  floats.source.maxima = integers.source.maxima;
  return truncation(integers) + ": the floats c of " + (isImage ? "IMAGE" : "REFERENCE") +
         " as a file like the other would hold them";
}

// Infinity or NaN in just one of the images exceeds every limit.
bool isWithin(const Limits& limits, const Difference& difference, double flip) {
  if (difference.unlike > 0) return false;
  const bool pixelsCount = limits.tolerance || limits.maxDiffering || !(limits.maxRmse || limits.maxFlip);
  if (pixelsCount && difference.differing > limits.maxDiffering.value_or(0)) return false;
  const double rmse = std::max(difference.color.rmse, difference.alpha.rmse);
  if (limits.maxRmse && !(rmse <= *limits.maxRmse)) return false;
  return !limits.maxFlip || flip <= *limits.maxFlip;
}

// Why not, if the file cannot be read.
std::string read(const std::filesystem::path& file, std::optional<Image>& image) {
  if (file.empty()) return {};
  try {
    image = readImage(file);
  } catch (const Error& error) {
    if (error.exitCode() != ExitCode::kInput) throw;
    return error.what();
  }
  return {};
}

}  // namespace

ComparedPair comparePair(const Pair& pair) {
  ComparedPair result;
  result.pair = pair;
  result.problem = read(pair.image, result.image);
  const std::string other = read(pair.reference, result.reference);
  if (result.problem.empty()) result.problem = other;
  if (!result.problem.empty()) return result;
  if (pair.image.empty() || pair.reference.empty()) {
    result.verdict = pair.image.empty() ? Verdict::kImageMissing : Verdict::kReferenceMissing;
    return result;
  }
  Image& image = *result.image;
  Image& reference = *result.reference;
  if (image.width != reference.width || image.height != reference.height) {
    result.verdict = Verdict::kSizesDiffer;
    return result;
  }
  result.comparedAs = compareAsWritten(image, reference);
  result.difference = compare(image, reference, toleranceOf(pair.limits.tolerance.value_or(0.0)));
  result.histogram = differenceHistogram(image, reference);
  result.seen = seenDifference(image, reference, hardwareThreads());
  result.verdict =
      isWithin(pair.limits, result.difference, result.seen.mean) ? Verdict::kAlike : Verdict::kDiffers;
  return result;
}

}  // namespace lavaray
