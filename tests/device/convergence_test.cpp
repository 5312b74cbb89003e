// How the error of sampled images falls with the samples, where the pixels' true values are known.
//
// Targets: a scrambled net's error falls as n^-3/4 where pixels have an edge and faster than 1/n where they
// are smooth (Mitchell, "Consequences of Stratified Sampling in Graphics", 1996); independent samples' as
// n^-1/2.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "device/lit_walls.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "support/closed_forms.hpp"

namespace lavaray {
namespace {

constexpr std::array<std::uint32_t, 5> kCounts = {4, 16, 64, 256, 1024};

// A pixel that has the feature that is looked at.
struct FeaturePixel {
  std::size_t index;
  double truth;
  double contrast;  // of what the pixel's samples may show
};

// Errors in units of the contrast, over pixels, images and seeds.
class Convergence {
 public:
  void add(const Scene& scene, const ImageSize& size, const std::vector<FeaturePixel>& pixels,
           std::uint32_t seeds) {
    for (std::size_t i = 0; i < kCounts.size(); ++i) {
      for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        RenderSettings settings = settingsFor(size, kCounts[i]);
        settings.seed = seed;
        const Image image = renderScene(scene, settings).image;
        for (const FeaturePixel& pixel : pixels) {
          squares_[i] += std::pow((double{image.rgb[3 * pixel.index]} - pixel.truth) / pixel.contrast, 2.0);
        }
      }
    }
    pixels_ += seeds * pixels.size();
  }

  void expect(double highestSlope, double highestErrorOf16) const {
    std::vector<double> errors;
    for (const double sum : squares_) errors.push_back(std::sqrt(sum / static_cast<double>(pixels_)));
    const double slope = fittedSlope({kCounts.begin(), kCounts.end()}, errors);
    EXPECT_LE(slope, highestSlope);
    EXPECT_LE(errors[1], highestErrorOf16);
    std::cout << "slope " << slope << ", RMSE in " << pixels_ << " pixels:";
    for (std::size_t i = 0; i < kCounts.size(); ++i) std::cout << ' ' << kCounts[i] << ": " << errors[i];
    std::cout << '\n';
  }

 private:
  std::array<double, kCounts.size()> squares_{};
  std::size_t pixels_ = 0;
};

// A dark image with a bright half-plane: each pixel's truth is the share of it that the half-plane covers.
TEST(Convergence, OnEdgesIsThatOfScrambledNets) {
  const ImageSize size{16, 16};
  Convergence convergence;
  for (const double rise : {0.3, 0.0625, 0.75, -1.75}) {
    Scene scene;
    scene.camera = {{0, 0, 0}, 90.0, 8.0, 1.0};
    // Its edge runs through (0, 0) with that slope on the image plane; the other two are out of sight.
    scene.triangles = {{{{{-10, -10 * rise, -1}, {10, 10 * rise, -1}, {-30 * rise, 30, -1}}},
                        addObject(scene, glow(glm::dvec3(1.0)))}};
    std::vector<FeaturePixel> pixels;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const double covered = halfPlaneCoverage(x - 8.0, y - 8.0, -rise, -1.0, 0.0);
        const std::size_t index = static_cast<std::size_t>(y) * size.width + x;
        if (covered > 1e-9 && covered < 1.0 - 1e-9) pixels.push_back({index, covered, 1.0});
      }
    }
    convergence.add(scene, size, pixels, 5);
  }
  convergence.expect(-0.70, 0.045);
}

// A pixel's contrast is what its shading spans, and the error is measured in that; pixels about the brightest
// point, which span next to nothing, are left out.
TEST(Convergence, OfSmoothShadingIsFasterThanOfEdges) {
  const MatteWall wall = matteWall(16);
  std::vector<FeaturePixel> pixels;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const auto corners = std::minmax(
          {wall.shading(x, y), wall.shading(x + 1, y), wall.shading(x, y + 1), wall.shading(x + 1, y + 1)});
      const double contrast = corners.second - corners.first;
      if (contrast < 0.03) continue;
      pixels.push_back({static_cast<std::size_t>(y) * 16 + x, meanOverSquare(x, y, wall.shading), contrast});
    }
  }
  EXPECT_GT(pixels.size(), 100U);
  Convergence convergence;
  convergence.add(wall.scene, {16, 16}, pixels, 4);
  convergence.expect(-0.95, 0.012);
}

// The shadow of a straight edge in the light of a sphere, where the light is neither all hidden nor all seen.
Convergence inPenumbrae(const std::vector<ImageSize>& sizes, std::uint32_t seeds) {
  Convergence convergence;
  for (const ImageSize& size : sizes) {
    for (const double radius : {0.5, 0.05}) {
      const Penumbra penumbra = halfPlanePenumbra(radius, size);
      std::vector<FeaturePixel> pixels;
      for (int y = 0; y < penumbra.size.height; ++y) {
        for (int x = 0; x < penumbra.size.width; ++x) {
          const double visible = penumbra.expected(x, y);
          if (visible < 1e-6 || visible > 1.0 - 1e-6) continue;
          pixels.push_back({static_cast<std::size_t>(y) * penumbra.size.width + x, penumbra.color(visible),
                            penumbra.color(1.0) - penumbra.color(0.0)});
        }
      }
      EXPECT_GT(seeds * pixels.size(), 50U);
      convergence.add(penumbra.scene, penumbra.size, pixels, seeds);
    }
  }
  return convergence;
}

TEST(Convergence, InPenumbraeIsThatOfEdges) {
  inPenumbrae({{40, 40}}, 1).expect(-0.70, 0.055);
}

// Penumbrae 2 to 8 pixels wide: a step in four dimensions, as the position in the pixel matters as well. The
// error of a scrambled net in d dimensions falls there as n^(-1/2 - 1/2d) (He and Owen, "Extensible Grids:
// Uniform Sampling on a Space Filling Curve", 2016); where the position and the direction are stratified each
// by itself, towards n^-1/2.
TEST(Convergence, InNarrowPenumbraeIsThatOfStepsInFourDimensions) {
  inPenumbrae({{3, 3}, {5, 5}, {10, 10}}, 6).expect(-0.625, 0.055);
}

}  // namespace
}  // namespace lavaray
