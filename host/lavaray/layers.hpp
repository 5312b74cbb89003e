#pragma once

#include <lavaray/renderer.h>

#include <functional>
#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// The layer's file beside the picture: out.normal.exr beside out.exr.
OutputName layerOutput(const Options& options, Layer layer);

// The files of --layers, each replaced as a whole. They are opened by the constructor, before the render, and
// commit() moves them into place. Without layers nothing happens.
class Layers {
 public:
  // Throws Error(kOutput) if one cannot be written.
  explicit Layers(const Options& options);

  [[nodiscard]] bool areTraced() const;  // whether trace() has anything to do
  // Traces those layers that come from rays through the pixels' centres. `origin` is what their files say of
  // themselves. `proceed` gets the share that is done; returns false if that stopped it.
  bool trace(RenderJob& job, const TextEntries& origin, const OnProgress& proceed);
  // Writes those layers that come from the picture's own sampling.
  void write(RenderJob& job, const TextEntries& origin);
  // Throws Error(kOutput) if not everything could be written.
  void commit();

 private:
  struct File {
    Layer layer;
    OutputFile output;
  };

  std::vector<File> files_;
};

}  // namespace lavaray
