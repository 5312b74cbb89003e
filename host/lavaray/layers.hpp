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
#include "render/render.hpp"

namespace lavaray {

// The layer's file beside the picture: out.normal.exr beside out.exr.
OutputName layerOutput(const Options& options, Layer layer);

// The files of --layers, each replaced as a whole. They are opened by the constructor, before the render, and
// commit() moves them into place. Without layers nothing happens.
class Layers {
 public:
  // Throws Error(kOutput) if one cannot be written.
  explicit Layers(const Options& options);

  // Traces those layers of `part` that come from rays through the pixels' centres. `proceed` gets the share
  // that is done; returns false if that stopped it.
  bool trace(vulkan::Device& device, const GpuScene& gpuScene, RenderSettings settings, const Rectangle& part,
             const std::function<bool(double)>& proceed);
  // Writes those layers that come from the picture's own sampling: `part` of what was rendered,
  // settings.crop.
  void write(const Render& render, const RenderSettings& settings, const Rectangle& part,
             const std::string& device);
  // Throws Error(kOutput) if not everything could be written.
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
  std::list<File> files_;  // which cannot move
};

}  // namespace lavaray
