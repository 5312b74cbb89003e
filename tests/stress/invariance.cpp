// What must not change a picture: the scene's scale, its place, and how it is turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "device/render_scene.hpp"
#include "stress/report.hpp"
#include "support/scene_files.hpp"

namespace lavaray {
namespace {

class EachScene : public testing::TestWithParam<std::string> {};

const auto kAllScenes = testing::ValuesIn(sceneNames());
const auto kSceneName = [](const auto& test) { return asIdentifier(test.param); };

// Applies `map` to every position, and `direct` to every direction.
template <typename Map, typename Direct>
Scene transformed(Scene scene, const Map& map, const Direct& direct) {
  scene.camera.position = map(scene.camera.position);
  for (Plane& plane : scene.planes) plane = {direct(plane.normal), map(plane.point), plane.object};
  for (Sphere& sphere : scene.spheres) sphere.center = map(sphere.center);
  for (Light& light : scene.lights) light.position = map(light.position);
  for (Triangle& triangle : scene.triangles) {
    for (glm::dvec3& vertex : triangle.vertices) vertex = map(vertex);
  }
  for (Mesh& mesh : scene.meshes) {
    for (glm::dvec3& position : mesh.positions) position = map(position);
    for (glm::dvec3& normal : mesh.normals) normal = direct(normal);
  }
  return scene;
}

Scene scaled(const Scene& scene, double scale) {
  const auto same = [](const glm::dvec3& v) { return v; };
  Scene result = transformed(
      scene, [&](const glm::dvec3& p) { return scale * p; }, same);
  for (Sphere& sphere : result.spheres) sphere.radius *= scale;
  for (Light& light : result.lights) light.radius *= scale;
  return result;
}

Scene moved(const Scene& scene, const glm::dvec3& by) {
  const auto same = [](const glm::dvec3& v) { return v; };
  return transformed(
      scene, [&](const glm::dvec3& p) { return p + by; }, same);
}

class AtAnyScale : public EachScene {};
INSTANTIATE_TEST_SUITE_P(, AtAnyScale, kAllScenes, kSceneName);

// A power of two changes no digit of any sum, product, quotient or root, so any difference is an absolute
// epsilon.
TEST_P(AtAnyScale, TheImageHasTheSameBits) {
  const Scene scene = readNamed(GetParam());
  const ImageSize size = reducedSize(scene.camera, 100);
  const Image image = renderScene(scene, size).image;
  std::size_t images = 0;
  std::size_t differing = 0;
  for (int exponent = -300; exponent <= 20; ++exponent) {
    const bool isFar = exponent < -20 && exponent % 35 != 0;
    const bool isQuick = std::abs(exponent) == 20 || exponent % 7 == 0;
    if (exponent == 0 || isFar || (!isFullSize() && !isQuick)) continue;
    const Scene other = scaled(scene, std::ldexp(1.0, exponent));
    const bool same = sameBits(image.rgb, renderScene(other, size).image.rgb);
    EXPECT_TRUE(same) << "times 2^" << exponent;
    ++images;
    if (!same) ++differing;
  }
  report(std::to_string(differing) + " of " + std::to_string(images) +
         " images scaled by 2^k, k = -300 to 20, differ in a bit");
}

// What is far beside a tiny scene, a sun, neither keeps it from being enlarged nor loses its own digits.
TEST(BesideASun, ATinySceneHasTheSameBits) {
  Scene scene = readNamed("spheres");
  const ImageSize size = reducedSize(scene.camera, 100);
  for (const double distance : {0x1p20, 0x1p40, 0x1p60}) {
    scene.lights.front().position = scene.camera.position + distance * glm::dvec3(0.5, 0.75, 0.25);
    const Image image = renderScene(scene, size).image;
    for (const int exponent : {-10, -40, -60, -100, -300}) {
      const Image tiny = renderScene(scaled(scene, std::ldexp(1.0, exponent)), size).image;
      EXPECT_TRUE(sameBits(image.rgb, tiny.rgb)) << distance << " away, times 2^" << exponent;
    }
  }
}

double rmse(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double{a[i]} - double{b[i]}, 2.0);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

class AtAnyPlace : public EachScene {};
INSTANTIATE_TEST_SUITE_P(, AtAnyPlace, kAllScenes, kSceneName);

TEST_P(AtAnyPlace, TheImageIsTheSame) {
  const Scene scene = readNamed(GetParam());
  const ImageSize size = reducedSize(scene.camera, 200);
  const Image image = renderScene(scene, size).image;
  std::string figures;
  for (const double distance : {1e3, 1e5, 1e9}) {
    const glm::dvec3 by = distance * glm::dvec3(1.0, -0.7, 0.3);
    const Image other = renderScene(moved(scene, by), size).image;
    const double error = rmse(image.rgb, other.rgb);
    EXPECT_LE(error, 1e-4) << "moved by " << distance;
    figures += (figures.empty() ? "" : ", ") + shortNumber(error) + " moved by " + shortNumber(distance);
  }
  report("RMSE " + figures);
}

// The camera looks down -z, so a quarter turn and a mirror about that axis turn and mirror the picture.
struct Symmetry {
  const char* name;
  std::array<double, 4> matrix;  // of x and y, row by row
};
constexpr std::array kSymmetries{
    Symmetry{"a quarter turn", {0, -1, 1, 0}},      Symmetry{"a half turn", {-1, 0, 0, -1}},
    Symmetry{"three quarter turns", {0, 1, -1, 0}}, Symmetry{"mirrored", {-1, 0, 0, 1}},
    Symmetry{"upside down", {1, 0, 0, -1}},         Symmetry{"x and y exchanged", {0, 1, 1, 0}},
    Symmetry{"x and -y exchanged", {0, -1, -1, 0}}};

class TurnedAboutTheAxis : public EachScene {};
INSTANTIATE_TEST_SUITE_P(, TurnedAboutTheAxis, kAllScenes, kSceneName);

TEST_P(TurnedAboutTheAxis, TheImageIsTurned) {
  Scene scene = readNamed(GetParam());
  // A sample of a spherical light is a random direction, and that is not turned.
  for (Light& light : scene.lights) light.radius = 0.0;
  // With the camera in the origin and pixels of size 1, exchanging coordinates and their signs rounds
  // nothing.
  scene = moved(scene, -scene.camera.position);
  const auto side = static_cast<int>(sized(200, 600));
  scene.camera.aspect = 1.0;
  scene.camera.focalLength = 0.5 * side / std::tan(scene.camera.fovDegrees * std::numbers::pi / 360.0);
  const ImageSize size{side, side};
  ASSERT_EQ(imageSize(scene.camera), size);
  const Image image = renderScene(scene, size).image;
  std::size_t maxDiffering = 0;
  double largest = 0.0;
  for (const Symmetry& symmetry : kSymmetries) {
    const auto& m = symmetry.matrix;
    const auto turn = [&](const glm::dvec3& p) {
      return glm::dvec3(m[0] * p.x + m[1] * p.y, m[2] * p.x + m[3] * p.y, p.z);
    };
    const Image turned = renderScene(transformed(scene, turn, turn), size).image;
    std::size_t differing = 0;
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const glm::dvec3 to = turn({column + 0.5 - side / 2.0, side / 2.0 - (row + 0.5), 0.0});
        const auto toColumn = static_cast<int>(to.x + side / 2.0);
        const auto toRow = static_cast<int>(side / 2.0 - to.y);
        double difference = 0.0;
        for (int channel = 0; channel < 3; ++channel) {
          difference = std::max(difference, std::abs(double{image.rgb[3 * (row * side + column) + channel]} -
                                                     turned.rgb[3 * (toRow * side + toColumn) + channel]));
        }
        if (difference > 1e-6) {
          ++differing;
        } else {
          largest = std::max(largest, difference);
        }
      }
    }
    EXPECT_LE(differing, side * side / 10'000) << symmetry.name;
    maxDiffering = std::max(maxDiffering, differing);
  }
  report("at most " + std::to_string(maxDiffering) + " of " + grouped(side * side) +
         " pixels differ by more than 1e-6; the others by " + shortNumber(largest) + " at most");
}

TEST(Determinism, TenRunsHaveTheSameBits) {
  Scene scene = readNamed("extensions");
  RenderSettings settings;
  settings.size = reducedSize(scene.camera, 120);
  settings.crop = {0, 0, settings.size.width, settings.size.height};
  settings.samples = 4;
  const Image first = renderScene(scene, settings).image;
  int differing = 0;
  for (int run = 1; run < 10; ++run) {
    if (!sameBits(first.rgb, renderScene(scene, settings).image.rgb)) ++differing;
  }
  EXPECT_EQ(differing, 0);
  report(std::to_string(differing) + " of 10 runs differ in a bit");
}

}  // namespace
}  // namespace lavaray
