#include "lavaray/layers.hpp"

#include <algorithm>
#include <exception>

#include "image/exr_common.hpp"
#include "lavaray/origin.hpp"

namespace lavaray {

OutputName layerOutput(const Options& options, Layer layer) {
  std::filesystem::path file = options.output;
  const std::string ending = file.extension().string();
  file.replace_extension(layerName(layer) + ending);
  return {"--layers " + layerName(layer), file};
}

Layers::Layers(const Options& options) : options_(options) {
  for (const Layer layer : options.layers) files_.emplace_back(layer, layerOutput(options, layer));
}

std::unique_ptr<ExrWriter> Layers::makeWriter(const File& file, const RenderSettings& settings,
                                              const Rectangle& part, const std::string& device) const {
  TextEntries texts = describeOrigin(options_, settings, device);
  texts.emplace_back(kExrLayer, layerName(file.layer));
  // Half floats end at 65504 and hold integers up to 2048, too little for depths and object numbers.
  return std::make_unique<ExrWriter>(part.width(), part.height(), channelsOf(file.layer),
                                     ExrWriter::Precision::kFloat, texts, file.output.stream());
}

bool Layers::areTraced() const {
  return std::ranges::any_of(files_, [](const File& file) { return isTraced(file.layer); });
}

bool Layers::trace(vulkan::Device& device, const GpuScene& gpuScene, RenderSettings settings,
                   const Rectangle& part, const std::function<bool(double)>& proceed) {
  settings.crop = part;
  const auto count = std::ranges::count_if(files_, [](const File& file) { return isTraced(file.layer); });
  double done = 0.0;
  for (const File& file : files_) {
    if (!isTraced(file.layer)) continue;
    const auto writer = makeWriter(file, settings, part, device.description().name);
    const bool isWhole = traceLayer(
        device, gpuScene, settings, file.layer,
        [&](std::span<const float> values) { writer->writeNumbers(values); },
        [&](double share) { return proceed((done + share) / static_cast<double>(count)); });
    if (!isWhole) return false;
    writer->finish();
    done += 1.0;
  }
  return true;
}

void Layers::write(const Render& render, const RenderSettings& settings, const Rectangle& part,
                   const std::string& device) {
  const Rectangle& whole = settings.crop;
  const auto width = static_cast<std::size_t>(whole.width());
  for (const File& file : files_) {
    if (isTraced(file.layer)) continue;
    const std::vector<float> values =
        file.layer == Layer::kSamples ? render.pixelSamples() : render.pixelErrors();
    const auto writer = makeWriter(file, settings, part, device);
    for (int y = part.y0; y < part.y1; ++y) {
      const std::size_t first = static_cast<std::size_t>(y - whole.y0) * width + (part.x0 - whole.x0);
      writer->writeNumbers(std::span(values).subspan(first, static_cast<std::size_t>(part.width())));
    }
    writer->finish();
  }
}

void Layers::commit() {
  std::exception_ptr first;
  for (File& file : files_) {
    try {
      file.output.commit();
    } catch (...) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace lavaray
