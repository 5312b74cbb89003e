// The images of another driver than lavapipe against lavapipe's own. Sums, differences and products are the
// same on each (host/shader_compiler/exact_spirv.hpp); quotients, roots, powers, sines and cosines have
// Vulkan's tolerances. So where these decide what a ray hits, a pixel may show what is on the other side of
// an edge, and elsewhere be off by less than a level of a channel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "device/render_scene.hpp"
#include "device/test_device.hpp"
#include "image/image.hpp"
#include "oracle/oracle.hpp"
#include "scene/scene_reader.hpp"
#include "stress/report.hpp"
#include "support/image_compare.hpp"
#include "support/scene_files.hpp"

namespace lavaray {
namespace {

namespace fs = std::filesystem;

// The project's scenes and, where they are, the course's. (Its sample of the format names a mesh that is not
// there.)
std::vector<std::string> sceneFiles() {
  std::vector<std::string> files;
  for (const fs::path& folder : {fs::path(LAVARAY_SCENES_DIR), fs::path(LAVARAY_SHARED_DIR) / "course"}) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".txt" && file.stem() != "handout_sample") files.push_back(file.string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

class DriverImage : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(, DriverImage, testing::ValuesIn(sceneFiles()), [](const auto& test) {
  const fs::path file(test.param);
  const std::string prefix = file.parent_path().filename() == "course" ? "course_" : "";
  return prefix + asIdentifier(file.stem().string());
});

struct Differences {
  std::size_t bits = 0;       // pixels with any other value
  std::size_t bytes = 0;      // pixels with another byte
  std::size_t edges = 0;      // pixels off by more than a level where rounding may decide,
  std::size_t otherwise = 0;  // and those of them that show what is on the other side
  std::size_t elsewhere = 0;  // pixels off by more than a level anywhere else
  double largest = 0.0;       // of all values there, in levels
};

Differences compareImages(const Image& image, const Image& reference, const oracle::Result& oracle) {
  Differences differences;
  for (std::size_t i = 0; i < oracle.pixels.size(); ++i) {
    double value = 0.0;
    int byte = 0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
      const double difference = 255.0 * std::abs(double{image.rgb[k]} - double{reference.rgb[k]});
      value = std::isnan(difference) ? HUGE_VAL : std::max(value, difference);
      byte = std::max(byte, std::abs(toByte(image.rgb[k]) - toByte(reference.rgb[k])));
    }
    if (value > 0.0) ++differences.bits;
    if (byte > 0) ++differences.bytes;
    const bool isOff = byte > 1 || value > 1.0;
    if (oracle.pixels[i].uncertain) {
      if (isOff) ++differences.edges;
      if (isOff && showsAlternative(image.rgb, i, oracle.pixels[i])) ++differences.otherwise;
    } else {
      if (isOff) ++differences.elsewhere;
      differences.largest = std::max(differences.largest, value);
    }
  }
  return differences;
}

TEST_P(DriverImage, DiffersFromLavapipesAtEdgesOnly) {
  vulkan::Device* lavapipe = openDevice("llvmpipe");
  if (lavapipe == nullptr) GTEST_SKIP() << "lavapipe is not there";
  if (testDevice().description().name == lavapipe->description().name) GTEST_SKIP() << "this is lavapipe";
  Scene scene = readScene(GetParam());
  // Only a point has an answer that the oracle can say whether rounding decides it.
  for (Light& light : scene.lights) light.radius = 0.0;
  RenderSettings settings;
  settings.size = reducedSize(scene.camera, static_cast<int>(sized(300, 600)));
  settings.crop = {0, 0, settings.size.width, settings.size.height};
  const Image image = renderScene(scene, settings).image;
  const Image reference = renderScene(*lavapipe, scene, settings).image;
  const oracle::Result oracle = oracle::render(scene, {.size = settings.size});
  const Differences differences = compareImages(image, reference, oracle);
  EXPECT_EQ(differences.elsewhere, 0U);
  const auto pixels = static_cast<double>(oracle.pixels.size());
  EXPECT_LE(static_cast<double>(differences.edges - differences.otherwise), 1e-4 * pixels);
  report(grouped(differences.bits) + " of " + grouped(oracle.pixels.size()) + " pixels differ in bits, " +
         grouped(differences.bytes) + " in bytes, by more than a level " + grouped(differences.edges) +
         " at edges, " + grouped(differences.otherwise) + " of which show the other side, and " +
         grouped(differences.elsewhere) + " elsewhere, where the largest difference is " +
         shortNumber(differences.largest) + " of a level");
}

}  // namespace
}  // namespace lavaray
