#include "sampling/sample_allocation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "sampling/picture_scale.hpp"

namespace lavaray {
namespace {

using convergence::kRateSteps;
using convergence::kSampleSteps;
using convergence::rateAt;

// Squared errors are kept as a float's exponent and two bits of its mantissa, counted up from 2^-60.
constexpr unsigned kDroppedBits = 21;
constexpr std::uint32_t kMinErrorStep = (127U - 60U) << 2U;
constexpr std::uint32_t kCodes = kRateSteps + 1;  // the last one is of what is suspected
constexpr std::uint32_t kErrorSteps = PixelClass::kCount / (kCodes * kSampleSteps);

}  // namespace

PixelClass::PixelClass(float squaredError, int rateStep, int sampleStep) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(squaredError) >> kDroppedBits;
  const std::uint32_t errorStep =
      std::clamp(bits, kMinErrorStep, kMinErrorStep + kErrorSteps - 1U) - kMinErrorStep;
  index_ =
      static_cast<std::uint16_t>((errorStep * kCodes + static_cast<std::uint32_t>(rateStep)) * kSampleSteps +
                                 static_cast<std::uint32_t>(sampleStep));
}

double PixelClass::squaredError() const {
  const std::uint32_t errorStep = index_ / (kCodes * kSampleSteps);
  if (errorStep == 0) return 0.0;
  constexpr std::uint32_t kMiddle = 1U << (kDroppedBits - 1U);
  return double{std::bit_cast<float>(((errorStep + kMinErrorStep) << kDroppedBits) + kMiddle)};
}

SampleAllocation::SampleAllocation(std::span<const PixelClass> pixels, const PictureScale& scale, double goal,
                                   int maxSampleStep)
    : growth_(PixelClass::kCount) {
  std::vector<std::uint32_t> counts(PixelClass::kCount);
  for (const PixelClass& pixel : pixels) ++counts[pixel.index()];

  std::vector<Offer> offers;
  double minGain = std::numeric_limits<double>::max();
  double maxGain = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const PixelClass pixel(i);
    const double count = counts[i];
    const double squaredError = scale.squaredError(pixel);
    samples_ += count * std::exp2(pixel.sampleStep());
    if (squaredError == 0.0) continue;
    squaredError_ += count * squaredError / static_cast<double>(pixels.size());
    const double gain =
        std::log2(squaredError * (1.0 - std::exp2(-rateAt(pixel.rateStep())))) - pixel.sampleStep();
    offers.push_back({pixel, count, squaredError, gain});
    minGain = std::min(minGain, gain);
    maxGain = std::max(maxGain, gain);
  }
  if (squaredError_ <= goal) return;

  // Finds the highest price per sample, and so the fewest samples, at which the error reaches the goal. Each
  // doubling takes at most four from the logarithm of the gain, so the lowest price is low enough for any
  // growth.
  double low = minGain - 4.0 * kSampleSteps;
  double high = maxGain;
  while (high - low > 0.02) {
    const double price = (low + high) / 2.0;
    double sum = 0.0;
    for (const Offer& offer : offers) {
      const int growth = growthAt(offer, price, maxSampleStep);
      sum += offer.pixels * offer.squaredError * std::exp2(-rateAt(offer.pixel.rateStep()) * growth);
    }
    (sum <= goal * static_cast<double>(pixels.size()) ? low : high) = price;
  }
  for (const Offer& offer : offers) {
    const int growth = growthAt(offer, low, maxSampleStep);
    const int now = offer.pixel.sampleStep();
    growth_[offer.pixel.index()] = static_cast<std::uint8_t>(growth);
    samples_ += offer.pixels * (std::exp2(now + growth) - std::exp2(now));
  }
}

// Samples are doubled as long as each of them lowers the squared error by more than its price. A doubling
// gains 2^-(rate + 1) times as much per sample as the one before.
int SampleAllocation::growthAt(const Offer& offer, double logPrice, int maxSampleStep) {
  const int room = std::max(0, maxSampleStep - offer.pixel.sampleStep());
  const double doublings = (offer.doublingGain - logPrice) / (rateAt(offer.pixel.rateStep()) + 1.0);
  return std::clamp(static_cast<int>(std::ceil(doublings)), 0, room);
}

}  // namespace lavaray
