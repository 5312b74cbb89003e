#include "render/layer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "base/errors.hpp"
#include "base/text_location.hpp"
#include "render/pixel_values.hpp"

namespace lavaray {
namespace {

constexpr std::array<std::pair<const char*, Layer>, 5> kNames = {{{"normal", Layer::kNormal},
                                                                  {"depth", Layer::kDepth},
                                                                  {"object", Layer::kObject},
                                                                  {"samples", Layer::kSamples},
                                                                  {"error", Layer::kError}}};

View viewOf(Layer layer) {
  if (layer == Layer::kNormal) return View::kNormal;
  return layer == Layer::kDepth ? View::kDepth : View::kObject;
}

Layer layerNamed(const std::string& name) {
  for (const auto& [known, layer] : kNames) {
    if (name == known) return layer;
  }
  throw Error(ExitCode::kUsage,
              "--layers: there is no layer " + lavaray::quoted(name) + ", allowed are " + kLayerNames);
}

float distance(const glm::vec3& sum, double scale) {
  const bool isHit = sum.y > 0.0F;
  return isHit ? static_cast<float>(sum.x / scale) : std::numeric_limits<float>::infinity();
}

}  // namespace

std::string layerName(Layer layer) {
  const auto& [name, named] = kNames[static_cast<std::size_t>(layer)];
  assert(named == layer);
  return name;
}

std::vector<Layer> layersNamed(const std::string& names) {
  std::vector<Layer> layers;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const Layer layer = layerNamed(names.substr(begin, end - begin));
    if (std::ranges::find(layers, layer) != layers.end()) {
      throw Error(ExitCode::kUsage, "--layers names " + layerName(layer) + " twice; once is allowed");
    }
    layers.push_back(layer);
    begin = end + 1;
  }
  return layers;
}

std::size_t channelsOf(Layer layer) {
  return layer == Layer::kNormal ? 3 : 1;
}

bool isTraced(Layer layer) {
  return layer != Layer::kSamples && layer != Layer::kError;
}

bool traceLayer(vulkan::Device& device, const GpuScene& scene, RenderSettings settings, Layer layer,
                const std::function<void(std::span<const float>)>& take,
                const std::function<bool(double)>& proceed) {
  assert(isTraced(layer));
  settings.view = viewOf(layer);
  settings.asData = true;
  std::vector<float> values;
  return tracePixels(
      device, scene, settings,
      [&](std::span<const gpu::WorkResult> results) {
        values.clear();
        for (const gpu::WorkResult& result : results) {
          if (layer == Layer::kDepth) {
            values.push_back(distance(result.sum, scene.scale));
          } else {
            values.insert(values.end(), &result.sum.x, &result.sum.x + channelsOf(layer));
          }
        }
        take(values);
      },
      proceed);
}

}  // namespace lavaray
