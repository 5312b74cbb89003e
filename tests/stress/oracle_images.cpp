// Whole images against the double-precision oracle, far below the difference that an eye or a byte shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "device/render_scene.hpp"
#include "device/test_device.hpp"
#include "image/image.hpp"
#include "oracle/oracle.hpp"
#include "stress/report.hpp"
#include "support/image_compare.hpp"
#include "support/scene_files.hpp"

namespace lavaray {
namespace {

class OracleImage : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(, OracleImage, testing::ValuesIn(sceneNames()),
                         [](const auto& test) { return asIdentifier(test.param); });

struct Outcome {
  std::size_t pixels = 0;
  std::size_t uncertain = 0;      // float32 may decide otherwise: silhouettes, shadow edges, ...
  std::size_t beyond = 0;         // farther off than the tolerance
  std::size_t otherwise = 0;      // of these, those that show what is seen on the other side of an edge
  std::size_t beyondCertain = 0;  // of these, the ones that are not uncertain
  double largestCertain = 0.0;    // in units of the tolerance
  std::size_t otherBytes = 0;     // pixels that differ as bytes, but for the ones on the other side
  int largestByte = 0;            // where that is certain
};

Outcome compareClosely(const Image& image, const oracle::Result& expected) {
  Outcome outcome;
  outcome.pixels = expected.pixels.size();
  for (std::size_t i = 0; i < outcome.pixels; ++i) {
    const oracle::Pixel& pixel = expected.pixels[i];
    double largest = 0.0;
    int byte = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const double exact = pixel.color[channel];
      const float actual = image.rgb[3 * i + channel];
      largest = std::max(largest, std::abs(double{actual} - exact) / (2e-5 + 2e-5 * exact));
      byte = std::max(byte, std::abs(toByte(actual) - static_cast<int>(255.0 * exact)));
    }
    const bool isBeyond = !(largest <= 1.0);
    const bool isOtherwise = isBeyond && showsAlternative(image.rgb, i, pixel);
    if (pixel.uncertain) ++outcome.uncertain;
    if (isBeyond) ++outcome.beyond;
    if (isOtherwise) ++outcome.otherwise;
    if (isBeyond && !pixel.uncertain) ++outcome.beyondCertain;
    if (byte > 0 && !isOtherwise) ++outcome.otherBytes;
    if (pixel.uncertain) continue;
    outcome.largestCertain = std::max(outcome.largestCertain, largest);
    outcome.largestByte = std::max(outcome.largestByte, byte);
  }
  return outcome;
}

TEST_P(OracleImage, DiffersByLessThanAnyoneSees) {
  Scene scene = readNamed(GetParam());
  // One sample of a spherical light is a guess; with points for lights the pixel's centre has an exact
  // answer.
  for (Light& light : scene.lights) light.radius = 0.0;
  const ImageSize size = reducedSize(scene.camera, static_cast<int>(sized(200, 400)));
  const Outcome outcome =
      compareClosely(renderScene(scene, size).image, oracle::render(scene, {.size = size}));
  const auto pixels = static_cast<double>(outcome.pixels);
  EXPECT_LE(static_cast<double>(outcome.beyond - outcome.otherwise), 1e-4 * pixels);
  // On lavapipe, whose roots and quotients are rounded correctly, rays and edges in round numbers meet as in
  // the oracle.
  if (isLavapipe()) {
    EXPECT_LE(static_cast<double>(outcome.beyond), 1e-4 * pixels);
  }
  EXPECT_EQ(outcome.beyondCertain, 0U);
  EXPECT_LE(static_cast<double>(outcome.otherBytes), 1e-3 * pixels);
  EXPECT_LE(outcome.largestByte, 1);
  EXPECT_LT(static_cast<double>(outcome.uncertain), 0.5 * pixels);
  report(grouped(outcome.beyond) + " of " + grouped(outcome.pixels) + " pixels beyond " + "2e-5 + 2e-5 c, " +
         grouped(outcome.otherwise) + " of them on the other side of an edge, " +
         grouped(outcome.beyondCertain) + " certain; largest where certain " +
         shortNumber(outcome.largestCertain) + " of that; " + grouped(outcome.otherBytes) + " other bytes; " +
         grouped(outcome.uncertain) + " pixels at edges");
}

}  // namespace
}  // namespace lavaray
