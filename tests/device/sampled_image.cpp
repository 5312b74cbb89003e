#include "device/sampled_image.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>

#include "scene/scene_reader.hpp"

namespace lavaray {

Scene readNamed(const std::string& name) {
  return readScene(std::filesystem::path(LAVARAY_SCENES_DIR) / (name + ".txt"));
}

RenderSettings settingsFor(const ImageSize& size, std::uint32_t samples) {
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  settings.samples = samples;
  return settings;
}

std::uint32_t addObject(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void addParallelogram(Scene& scene, const Material& material, const glm::dvec3& a, const glm::dvec3& b,
                      const glm::dvec3& c) {
  scene.triangles.push_back({{a, b, c}, addObject(scene, material)});
  scene.triangles.push_back({{a, c, a + c - b}, addObject(scene, material)});
}

Material glow(const glm::dvec3& color) {
  Material material;
  material.ambient = color;
  return material;
}

bool sameBits(const Image& a, const Image& b) {
  return a.rgb.size() == b.rgb.size() &&
         std::memcmp(a.rgb.data(), b.rgb.data(), a.rgb.size() * sizeof(float)) == 0;
}

double rmse(const Image& image, const std::vector<double>& truth) {
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) squares += std::pow(double{image.rgb[i]} - truth[i], 2.0);
  return std::sqrt(squares / static_cast<double>(truth.size()));
}

double fittedSlope(const std::vector<double>& samples, const std::vector<double>& errors) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = std::log(samples[i]);
    const double y = std::log(errors[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const auto n = static_cast<double>(samples.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace lavaray
