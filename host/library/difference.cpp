#include <lavaray/image.h>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/mean_flip.hpp"
#include "library/check_image.hpp"
#include "library/guarded.hpp"

namespace lavaray {
namespace {

std::string sizeText(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

}  // namespace

void checkValues(const Image& image) {
  const bool hasSides = image.width > 0 && image.height > 0;
  const std::size_t pixels = hasSides ? static_cast<std::size_t>(image.width) * image.height : 0;
  if (hasSides && image.rgb.size() == 3 * pixels && (image.alpha.empty() || image.alpha.size() == pixels))
    return;
  throw Error(ExitCode::kUsage, "an image of " + sizeText(image) + " pixels has " +
                                    std::to_string(image.rgb.size()) + " values of colour and " +
                                    std::to_string(image.alpha.size()) +
                                    " of alpha; allowed are three a pixel, and one or none");
}

void checkSameSize(const Image& image, const Image& reference) {
  checkValues(image);
  checkValues(reference);
  if (image.width == reference.width && image.height == reference.height) return;
  throw Error(ExitCode::kUsage, "the image has " + sizeText(image) + " pixels and the reference " +
                                    sizeText(reference) + "; allowed are images of the same size");
}

namespace v0 {

Difference compare(const Image& image, const Image& reference, double tolerance) {
  return guarded([&] {
    checkSameSize(image, reference);
    return lavaray::compare(image, reference, tolerance);
  });
}

double psnr(double rmse) {
  return lavaray::psnr(rmse);
}

Image differencePicture(const Image& image, const Image& reference) {
  return guarded([&] {
    checkSameSize(image, reference);
    return lavaray::differencePicture(image, reference);
  });
}

Image asWritten(const Image& floats, const Image& integers) {
  return guarded([&] {
    checkSameSize(floats, integers);
    return lavaray::asWritten(floats, integers);
  });
}

std::vector<float> flipMap(const Image& image, const Image& reference) {
  return guarded([&] {
    checkSameSize(image, reference);
    return lavaray::flipMap(image, reference, hardwareThreads());
  });
}

double meanFlip(const Image& image, const Image& reference) {
  return guarded([&] {
    checkSameSize(image, reference);
    return lavaray::meanFlip(image, reference, hardwareThreads());
  });
}

}  // namespace v0
}  // namespace lavaray
