#include "lavaray/layers.hpp"

#include <algorithm>
#include <exception>

namespace lavaray {
namespace {

// Returns false if `proceed` stopped it.
bool writeLayer(RenderJob& job, Layer layer, OutputFile& file, const TextEntries& origin,
                const OnProgress& proceed) {
  LayerWriter writer(file, layer, {job.part().width(), job.part().height()}, origin);
  const bool isWhole = job.takeLayer(
      layer, [&](const float* values, std::size_t count) { writer.write(values, count); }, proceed);
  if (isWhole) writer.finish();
  return isWhole;
}

}  // namespace

OutputName layerOutput(const Options& options, Layer layer) {
  std::filesystem::path file = options.output;
  const std::string ending = file.extension().string();
  file.replace_extension(name(layer) + ending);
  return {"--layers " + name(layer), file};
}

Layers::Layers(const Options& options) {
  for (const Layer layer : options.layers) files_.push_back({layer, OutputFile(layerOutput(options, layer))});
}

bool Layers::areTraced() const {
  return std::ranges::any_of(files_, RenderJob::isTraced, &File::layer);
}

bool Layers::trace(RenderJob& job, const TextEntries& origin, const OnProgress& proceed) {
  const auto count = std::ranges::count_if(files_, RenderJob::isTraced, &File::layer);
  double done = 0.0;
  for (File& file : files_) {
    if (!RenderJob::isTraced(file.layer)) continue;
    const auto proceedWithAll = [&](double share) {
      return proceed((done + share) / static_cast<double>(count));
    };
    if (!writeLayer(job, file.layer, file.output, origin, proceedWithAll)) return false;
    done += 1.0;
  }
  return true;
}

void Layers::write(RenderJob& job, const TextEntries& origin) {
  for (File& file : files_) {
    if (!RenderJob::isTraced(file.layer)) writeLayer(job, file.layer, file.output, origin, {});
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
