#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "device_tracer.hpp"
#include "scenes.hpp"

namespace lavaray::bench {

// Another ray tracer in this process. It has the scene's shapes in float32, in the scene's Frame and order:
// the very numbers that lavaray has.
class Peer {
 public:
  virtual ~Peer() = default;

  // Its ways to trace. lavaray's hits must agree with those of the first.
  struct Variant {
    std::string name;
    bool isRobust;
    bool usesPackets;
  };
  [[nodiscard]] virtual std::vector<Variant> variants() const = 0;

  // As DeviceTracer::distances; any finite distance for an any-hit.
  virtual void trace(const Variant& variant, const Batch& batch, std::span<float> distances) = 0;
  // The whole picture, one sample at each pixel's centre, shaded as by lavaray: row by row, three channels.
  virtual void render(const Variant& variant, const ImageSize& size, std::span<float> rgb) = 0;
  // Rebuilds the hierarchy of the default variant.
  virtual void build() = 0;
  [[nodiscard]] virtual std::size_t sceneBytes() const = 0;  // of the default variant, shapes included
};

// Embree's version and how it is used, or why it is missing.
std::string embreeDescription();

// Null if the program is built without Embree.
std::unique_ptr<Peer> openEmbree(const Scene& scene, unsigned threads);

}  // namespace lavaray::bench
