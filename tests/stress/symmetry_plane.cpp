// Meshes that are symmetric about a plane through the camera: rays run within that plane, along its edges and
// in the sides' planes of the boxes that are split there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/render_scene.hpp"
#include "oracle/oracle.hpp"
#include "stress/report.hpp"
#include "support/scene_building.hpp"

namespace lavaray {
namespace {

// Equal to the bit on both sides of x = 0; a quarter of the columns from the first there are two in that
// plane.
Grid symmetricSphere(int rings, double bump, Random& random) {
  Grid grid = sphereGrid(rings, bump, random);
  for (auto& ring : grid) {
    for (int j = 0; j < rings; ++j) {
      const int mirrored = (rings / 2 - j + rings) % rings;
      ring[mirrored] = glm::dvec3(glm::vec3(-ring[j].x, ring[j].y, ring[j].z));
      ring[j] = glm::dvec3(glm::vec3(ring[j]));
      if (mirrored == j) ring[j].x = 0.0;
    }
  }
  return grid;
}

Scene symmetricScene(double bump, const ImageSize& size) {
  Random random(73);
  Scene scene;
  Grid grid = symmetricSphere(32, bump, random);
  for (auto& ring : grid) {
    for (glm::dvec3& point : ring) point.z -= 4.0;
  }
  addGrid(scene, grid, random);
  for (Material& material : scene.materials) material.ambient = glm::dvec3(1.0);
  const double fovDegrees = 45.0;
  const double focalLength = 0.5 * size.height / std::tan(fovDegrees * std::numbers::pi / 360.0);
  scene.camera = {glm::dvec3(0.0), fovDegrees, focalLength, static_cast<double>(size.width) / size.height};
  return scene;
}

// Inside is where the oracle sees the mesh in a pixel and in all that adjoin it.
std::vector<bool> insideTheSilhouette(const oracle::Result& image) {
  const auto shows = [&](int x, int y) { return image.pixels[y * image.width + x].color.r > 0.0; };
  std::vector<bool> inside(image.pixels.size());
  for (int y = 1; y + 1 < image.height; ++y) {
    for (int x = 1; x + 1 < image.width; ++x) {
      bool all = true;
      for (int v = y - 1; v <= y + 1; ++v) {
        for (int u = x - 1; u <= x + 1; ++u) all = all && shows(u, v);
      }
      inside[y * image.width + x] = all;
    }
  }
  return inside;
}

TEST(SymmetryPlane, NoPixelInsideTheSilhouetteIsBackground) {
  const int side = static_cast<int>(sized(161, 801));
  const ImageSize size{side, side};
  std::size_t pixels = 0;
  std::size_t center = 0;
  std::size_t holes = 0;
  for (const double bump : {0.0, 0.1}) {
    for (const double height : {0.0, 0.5, 1.7}) {
      Scene scene = symmetricScene(bump, size);
      scene.camera.position = {0.0, height, 0.0};
      ASSERT_EQ(imageSize(scene.camera), size);
      const std::vector<bool> inside = insideTheSilhouette(oracle::render(scene, {.probeOffset = 0.0}));
      const Image image = renderScene(scene).image;
      for (std::size_t i = 0; i < inside.size(); ++i) {
        if (!inside[i]) continue;
        ++pixels;
        if (static_cast<int>(i) % side == side / 2) ++center;
        if (image.rgb[3 * i] == 0.0F) ++holes;
      }
    }
  }
  EXPECT_EQ(holes, 0U);
  EXPECT_GT(center, static_cast<std::size_t>(side));
  report(grouped(holes) + " background pixels among " + grouped(pixels) + " inside silhouettes, " +
         grouped(center) + " of them in the plane of symmetry");
}

}  // namespace
}  // namespace lavaray
