// What samples tell of pixels' errors, and which pixels get more of them for an error of the image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sampling/convergence.hpp"
#include "sampling/discoveries.hpp"
#include "sampling/picture_evidence.hpp"
#include "sampling/picture_scale.hpp"
#include "sampling/sample_allocation.hpp"

namespace lavaray {
namespace {

PictureScale scaleOf(double seen, double suspected) {
  PictureScale scale{};
  scale.seen.fill(seen);
  scale.suspected.fill(suspected);
  return scale;
}
const PictureScale kAsTheyAre = scaleOf(1.0, 1.0);

TEST(PixelClass, KeepsWhatItIsMadeOf) {
  for (double squaredError = 0x1p-59; squaredError < 1.0; squaredError *= 1.07) {
    const PixelClass pixel(static_cast<float>(squaredError), 5, 7);
    EXPECT_NEAR(pixel.squaredError(), squaredError, 0.126 * squaredError);
    EXPECT_EQ(pixel.rateStep(), 5);
    EXPECT_EQ(pixel.sampleStep(), 7);
    EXPECT_EQ(PixelClass(pixel.index()).squaredError(), pixel.squaredError());
  }
  EXPECT_EQ(PixelClass(0.0F, 8, 23).squaredError(), 0.0);
  EXPECT_EQ(PixelClass(0x1p-70F, 8, 23).squaredError(), 0.0);
  EXPECT_LT(PixelClass::ofSuspected(1e9F, 23).index(), PixelClass::kCount);
  const PixelClass suspected = PixelClass::ofSuspected(0.01F, 4);
  EXPECT_TRUE(suspected.isSuspected());
  EXPECT_FALSE(PixelClass(0.01F, 8, 4).isSuspected());
  EXPECT_EQ(suspected.sampleStep(), 4);
  EXPECT_NEAR(suspected.squaredError(), 0.01, 0.00126);
}

double squaredErrorAfter(const PixelClass& pixel, int growth) {
  return pixel.squaredError() * std::exp2(-convergence::rateAt(pixel.rateStep()) * growth);
}

// Against all other plans for five pixels: none reaches the goal with fewer samples.
TEST(SampleAllocation, TakesTheFewestSamples) {
  constexpr int kMaxGrowth = 5;
  const std::vector<PixelClass> pixels = {PixelClass(0.05F, 2, 1), PixelClass(0.01F, 8, 1),
                                          PixelClass(0.02F, 0, 2), PixelClass(0.0005F, 2, 4),
                                          PixelClass(0.0F, 2, 1)};
  int plans = 0;
  for (double goal = 0.008; goal > 0.0005; goal *= 0.8) {
    const SampleAllocation plan(pixels, kAsTheyAre, goal, 20);
    double error = 0.0;
    double samples = 0.0;
    for (const PixelClass& pixel : pixels) {
      EXPECT_LE(plan.growth(pixel), kMaxGrowth);
      error += squaredErrorAfter(pixel, plan.growth(pixel)) / 5.0;
      samples += std::exp2(pixel.sampleStep() + plan.growth(pixel));
    }
    EXPECT_LE(error, goal);
    EXPECT_EQ(plan.samples(), samples);
    double fewest = samples;
    for (int code = 0; code < std::pow(kMaxGrowth + 1, 4); ++code) {
      double otherError = 0.0;
      double otherSamples = std::exp2(pixels[4].sampleStep());
      for (int i = 0, rest = code; i < 4; ++i, rest /= kMaxGrowth + 1) {
        otherError += squaredErrorAfter(pixels[i], rest % (kMaxGrowth + 1)) / 5.0;
        otherSamples += std::exp2(pixels[i].sampleStep() + rest % (kMaxGrowth + 1));
      }
      if (otherError <= goal) fewest = std::min(fewest, otherSamples);
    }
    // Doublings are taken whole and in the order of what they gain: the last one may be more than is needed.
    EXPECT_LE(samples, 2.0 * fewest);
    plans += samples == fewest ? 1 : 0;
  }
  EXPECT_GE(plans, 5);
}

TEST(SampleAllocation, ScalesWhatIsSeenAndWhatIsSuspected) {
  std::vector<PixelClass> pixels(10, PixelClass(0.01F, 2, 3));
  pixels.resize(20, PixelClass::ofSuspected(0.01F, 3));
  const double one = PixelClass(0.01F, 2, 3).squaredError();
  EXPECT_DOUBLE_EQ(SampleAllocation(pixels, scaleOf(3.0, 0.5), 1.0, 20).squaredError(), 1.75 * one);
  const SampleAllocation growing(pixels, scaleOf(3.0, 0.0), one, 20);
  EXPECT_GT(growing.growth(pixels.front()), 0);
  EXPECT_EQ(growing.growth(pixels.back()), 0);
}

TEST(SampleAllocation, DoesNothingAtItsGoalAndNoMoreThanAllowed) {
  const std::vector<PixelClass> pixels(10, PixelClass(0.01F, 2, 3));
  const SampleAllocation idle(pixels, kAsTheyAre, 0.02, 20);
  EXPECT_EQ(idle.growth(pixels[0]), 0);
  EXPECT_EQ(idle.samples(), 80.0);
  EXPECT_NEAR(idle.squaredError(), 0.01, 0.00126);
  EXPECT_EQ(SampleAllocation(pixels, kAsTheyAre, 1e-9, 5).growth(pixels[0]), 2);
  EXPECT_EQ(SampleAllocation(pixels, kAsTheyAre, 1e-9, 2).growth(pixels[0]), 0);
}

// The share is what was found, of what was suspected, over the pixels of 16 samples; of fewer samples nothing
// is known, and of more no better.
TEST(Discoveries, TellWhatSharesOfSuspicionsAreTrue) {
  EXPECT_EQ(Discoveries().shares()[4], Discoveries().shares()[1]);
  std::mt19937 random(5);
  std::bernoulli_distribution isThere(0.2);
  Discoveries discoveries;
  for (int i = 0; i < 5000; ++i) discoveries.add(4, 0.02, isThere(random) ? 0.75 * 0.02 : 0.0);
  EXPECT_NEAR(discoveries.shares()[4], 0.2, 0.02);
  EXPECT_EQ(discoveries.shares()[9], discoveries.shares()[4]);
  EXPECT_EQ(discoveries.shares()[1], Discoveries().shares()[1]);
  Discoveries restored;
  restored.restore(discoveries.state());
  EXPECT_EQ(restored.shares(), discoveries.shares());
}

// Pixels whose squared error falls by 0.4 with each doubling, whatever their classes say.
TEST(PictureEvidence, ScalesByWhatTheDifferencesLeave) {
  constexpr double kFall = 0.4;
  const PixelClass pixel(0.01F, 2, 6);
  const auto scaleFor = [&](double error) {
    PictureEvidence evidence;
    const double difference = error * (1.0 / kFall - 1.0);
    for (int i = 0; i < 10000; ++i) evidence.add(pixel, difference, difference / kFall);
    evidence.add(PixelClass::ofSuspected(1.0F, 6), 1.0, 0.0);  // not counted
    return evidence.scales()[6] * pixel.squaredError() / error;
  };
  EXPECT_NEAR(scaleFor(0.02), scaleFor(0.004), 0.02);
  EXPECT_NEAR(scaleFor(0.02), 1.0, 0.02);
  EXPECT_EQ(PictureEvidence().scales()[6], 1.0);
}

}  // namespace
}  // namespace lavaray
