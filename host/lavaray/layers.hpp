#pragma once

#include <functional>
#include <list>
#include <memory>
#include <string>

#include "base/output_file.hpp"
#include "bvh/flatten.hpp"
#include "image/exr_writer.hpp"
#include "lavaray/options.hpp"
#include "render/layer.hpp"
#include "render/renderer.hpp"

namespace lavaray {

// The file beside the picture that has the layer: of out.exr it is out.normal.exr.
OutputName layerOutput(const Options& options, Layer layer);

// The files of --layers, each replaced as a whole. They are opened when this is made, before the rendering,
// and in their places at last by commit(). Without layers nothing happens.
class Layers {
 public:
  // Throws Error(kOutput) where one cannot be written.
  explicit Layers(const Options& options);

  // Those that rays through the pixels' centres make, of `part`. `proceed` is called with the share that is
  // done. Returns false where it was stopped by that.
  bool trace(vulkan::Device& device, const Scene& scene, const GpuScene& gpuScene, RenderSettings settings,
             const Rectangle& part, const std::function<bool(double)>& proceed);
  // Those that the picture's sampling makes: the part of what was rendered, settings.crop.
  void write(const Render& render, const RenderSettings& settings, const Rectangle& part,
             const std::string& device);
  // Throws Error(kOutput) where not everything could be written.
  void commit();

  [[nodiscard]] bool areTraced() const;  // whether trace() has anything to do

 private:
  struct File {
    File(Layer name, const OutputName& file) : layer(name), output(file) {}
    Layer layer;
    OutputFile output;
  };
  std::unique_ptr<ExrWriter> makeWriter(const File& file, const RenderSettings& settings,
                                        const Rectangle& part, const std::string& device) const;

  const Options& options_;
  std::list<File> files_;  // stay where they are
};

}  // namespace lavaray
