#include <lavaray/renderer.h>

#include "library/guarded.hpp"
#include "render/layer.hpp"
#include "render/render_statistics.hpp"
#include "render/view.hpp"
#include "sampling/pixel_filter.hpp"
#include "sampling/sampler.hpp"

namespace lavaray::v0 {

std::string name(View view) {
  return viewName(view);
}

std::string name(Layer layer) {
  return layerName(layer);
}

std::string name(PixelFilter filter) {
  return pixelFilterName(filter);
}

std::string name(Sampler sampler) {
  return samplerName(sampler);
}

std::string name(StopReason reason) {
  return stopReasonName(reason);
}

std::optional<View> viewNamed(const std::string& name) {
  return lavaray::viewNamed(name);
}

std::optional<PixelFilter> filterNamed(const std::string& name) {
  return pixelFilter(name);
}

std::optional<Sampler> samplerNamed(const std::string& name) {
  for (const Sampler sampler : {Sampler::kSobol, Sampler::kRandom}) {
    if (name == samplerName(sampler)) return sampler;
  }
  return std::nullopt;
}

std::vector<Layer> layersNamed(const std::string& names) {
  return guarded([&] { return lavaray::layersNamed(names); });
}

}  // namespace lavaray::v0
