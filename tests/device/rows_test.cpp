// A render that keeps no picture hands over the rows of the very image that one makes that does.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "bvh/flatten.hpp"
#include "device/render_scene.hpp"
#include "device/sampled_image.hpp"
#include "device/test_device.hpp"
#include "support/scene_files.hpp"

namespace lavaray {
namespace {

struct Rows {
  std::vector<float> whileRendering;
  std::vector<float> all;
  std::uint64_t samples;
};

// Stops before batch number `batches`.
Rows rowsOf(const Scene& scene, RenderSettings settings, int batches) {
  settings.keepsPicture = false;
  const GpuScene gpuScene = flatten(scene, 2);
  Render render(testDevice(), gpuScene, settings);
  Rows rows;
  const TakeRow take = [&](std::span<const float> row) {
    rows.all.insert(rows.all.end(), row.begin(), row.end());
  };
  render.run([&] { return batches-- > 0; }, take);
  rows.whileRendering = rows.all;
  rows.samples = render.statistics().counts.samples;
  render.handOverRows(take);
  return rows;
}

TEST(Rows, AreThoseOfTheImage) {
  // star has a small part that anything can be seen in, the first row of which is not the picture's.
  for (const char* name : {"extensions", "star", "handout"}) {
    const Scene scene = readNamed(name);
    const ImageSize size = reducedSize(scene.camera, 300);
    for (const Rectangle& part : {Rectangle{0, 0, size.width, size.height}, Rectangle{31, 17, 164, 90},
                                  Rectangle{0, 0, 1, 1}, Rectangle{0, 60, size.width, 61}}) {
      RenderSettings settings = settingsFor(size, 1);
      settings.crop = part;
      const RenderResult expected = renderScene(scene, settings);
      const Rows rows = rowsOf(scene, settings, 1 << 20);
      EXPECT_TRUE(sameBits(expected.image.rgb, rows.all)) << name;
      // What is below the part in which anything can be seen is left for the end.
      EXPECT_TRUE(expected.skippedPixels > 0 || rows.whileRendering.size() == rows.all.size()) << name;
    }
  }
}

TEST(Rows, AreBlackWhereARenderWasStopped) {
  const Scene scene = readNamed("extensions");
  const RenderSettings settings = settingsFor(reducedSize(scene.camera, 300), 1);
  const Image image = renderScene(scene, settings).image;
  const auto width = static_cast<std::size_t>(image.width);
  for (const int batches : {0, 1, 2}) {
    const Rows rows = rowsOf(scene, settings, batches);
    ASSERT_EQ(rows.all.size(), image.rgb.size());
    ASSERT_LT(3 * rows.samples, image.rgb.size());
    EXPECT_EQ(rows.samples > 0, batches > 0);
    EXPECT_EQ(rows.whileRendering.size(), rows.samples / width * 3 * width);
    std::vector<float> expected(image.rgb.size());
    std::copy_n(image.rgb.begin(), 3 * rows.samples, expected.begin());
    EXPECT_TRUE(sameBits(expected, rows.all)) << rows.samples << " samples";
    std::cout << rows.samples << " of " << image.rgb.size() / 3 << " pixels\n";
  }
}

}  // namespace
}  // namespace lavaray
