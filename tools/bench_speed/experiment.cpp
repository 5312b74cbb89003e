#include "experiment.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "bvh/flatten.hpp"
#include "bvh/primitives.hpp"
#include "device_tracer.hpp"
#include "peer.hpp"
#include "render/tracer.hpp"

namespace lavaray::bench {
namespace {

bool measures(const Options& options, const char* part) {
  return std::ranges::find(options.parts, part) != options.parts.end();
}

// Distances may differ by how two ways to compute them are rounded, which is most for grazing rays.
bool agree(float a, float b, bool anyHit) {
  const bool hitA = std::isfinite(a);
  const bool hitB = std::isfinite(b);
  if (hitA != hitB) return false;
  return anyHit || !hitA || std::abs(a - b) <= 1e-4F * std::max(a, b);
}

BatchResult measureBatch(DeviceTracer& tracer, Peer* peer, const Batch& batch, const Options& options) {
  tracer.load(batch);
  std::vector<float> distances(batch.rays.size());
  std::vector<Contestant> contestants{{contestant(tracer.raysPerLane()), [&] { tracer.trace(); }}};
  if (peer != nullptr) {
    for (const Peer::Variant& variant : peer->variants()) {
      contestants.push_back({variant.name, [&, variant] { peer->trace(variant, batch, distances); }});
    }
  }
  BatchResult result{batch.name, tracer.raysPerLane(), rayCount(batch), 0, 0, {}, {}};
  result.timings = measure(contestants, options.rounds);
  // Not a contestant: the part of lavaray's time that is reading rays and writing results.
  result.timings.push_back(
      measure({{"(lavaray, no tracing)", [&] { tracer.readAndWrite(); }}}, options.rounds).front());

  tracer.trace();
  const std::span<const float> found = tracer.distances();
  result.hits = std::count_if(found.begin(), found.end(), [](float t) { return std::isfinite(t); });
  result.unfinished = std::count_if(found.begin(), found.end(), [](float t) { return std::isnan(t); });
  if (peer != nullptr) {
    peer->trace(peer->variants().front(), batch, distances);
    std::size_t disagreements = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      if (!agree(found[i], distances[i], batch.anyHit)) ++disagreements;
    }
    result.disagreements = disagreements;
  }
  return result;
}

std::size_t differingPixels(const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    float largest = 0.0F;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      largest = std::max(largest, std::abs(a[i + channel] - b[i + channel]));
    }
    if (largest > 1.0F / 255.0F) ++differing;
  }
  return differing;
}

// The renderer, tracing a picture without keeping it anywhere but in `rgb`.
class PictureTracer {
 public:
  PictureTracer(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings)
      : pixels_(settings.crop.pixels()), tracer_(device, scene, settings, settings.crop, pixels_) {
    // In its first runs the renderer finds the size of its dispatches.
    std::vector<float> rgb(3 * pixels_);
    for (int i = 0; i < 2; ++i) trace(rgb);
  }
  void trace(std::vector<float>& rgb) {
    const auto take = [&](std::uint64_t first, std::span<const gpu::WorkResult> results) {
      float* value = &rgb[3 * first];
      for (const gpu::WorkResult& result : results) value = std::copy_n(&result.sum.x, 3, value);
    };
    tracer_.run(uniformPass(pixels_, {0, 1}), 0, take, [] { return false; });
  }

 private:
  std::uint64_t pixels_;
  Tracer tracer_;
};

PictureResult measurePicture(vulkan::Device& device, const GpuScene& gpuScene, Peer* peer,
                             const Options& options) {
  RenderSettings settings;
  settings.size = options.size;
  settings.crop = {0, 0, options.size.width, options.size.height};
  std::vector<float> rgb(3 * settings.crop.pixels());
  std::vector<float> peerRgb(rgb.size());
  std::deque<PictureTracer> tracers;
  std::vector<Contestant> contestants;
  for (const unsigned rays : options.raysPerLane) {
    settings.raysPerLane = rays;
    PictureTracer& tracer = tracers.emplace_back(device, gpuScene, settings);
    contestants.push_back({contestant(rays), [&] { tracer.trace(rgb); }});
  }
  if (peer != nullptr) {
    for (const Peer::Variant& variant : peer->variants()) {
      if (variant.usesPackets) continue;
      contestants.push_back({variant.name, [&, variant] { peer->render(variant, options.size, peerRgb); }});
    }
  }
  PictureResult result;
  result.timings = measure(contestants, options.rounds);
  if (peer != nullptr) {
    peer->render(peer->variants().front(), options.size, peerRgb);
    result.differingPixels = differingPixels(rgb, peerRgb);
  }
  return result;
}

std::vector<Timing> measureBuilds(const Scene& scene, Peer* peer, const Options& options) {
  const Primitives primitives(scene);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < primitives.size(); ++i) boxes.push_back(primitives.box(i));
  std::vector<Contestant> contestants{
      {"lavaray hierarchy", [&] { buildBvh(boxes, options.threads); }},
      {"lavaray all arrays", [&] { flatten(scene, options.threads); }},
  };
  if (peer != nullptr) contestants.push_back({"embree default commit", [&] { peer->build(); }});
  return measure(contestants, options.rounds);
}

// Measures the rays, in the order for each number of rays a lane. Returns how many a picture has.
std::size_t measureRays(vulkan::Device& device, const GpuScene& gpuScene, Peer* peer, const Options& options,
                        SceneResult& result, const Progress& tell) {
  std::size_t ofPicture = 0;
  for (const unsigned raysPerLane : options.raysPerLane) {
    DeviceTracer tracer(device, gpuScene, raysPerLane);
    result.bytes = tracer.sceneBytes();
    const PictureBatches batches = tracer.pictureRays(gpuScene.imagePlane, options.size);
    ofPicture = rayCount(batches.camera) + rayCount(batches.shadow);
    if (!measures(options, "rays")) break;
    for (const Batch* batch : {&batches.camera, &batches.shadow, &batches.mirror}) {
      // From a sphere's own surface Embree sees the sphere's far side, lavaray does not: that is not the same
      // work.
      if (result.isSpheres && batch != &batches.camera) continue;
      tell(batch->name + " rays, " + std::to_string(raysPerLane) + " a lane");
      result.batches.push_back(measureBatch(tracer, peer, *batch, options));
    }
  }
  return ofPicture;
}

}  // namespace

SceneResult measureScene(vulkan::Device& device, const BenchScene& scene, const Options& options,
                         const Progress& progress) {
  SceneResult result{scene.name, scene.what, scene.isSpheres, scene.primitives, 0, {}, {}, {}, {}};
  const auto tell = [&](const std::string& what) { progress(scene.name + ": " + what); };
  tell("building");
  const GpuScene gpuScene = flatten(scene.scene, options.threads);
  const std::unique_ptr<Peer> peer = openEmbree(scene.scene, options.threads);
  if (peer) result.peerBytes = peer->sceneBytes();
  const std::size_t rays = measureRays(device, gpuScene, peer.get(), options, result, tell);
  if (measures(options, "pictures")) {
    tell("the picture");
    result.picture = measurePicture(device, gpuScene, peer.get(), options);
  }
  result.picture.rays = rays;
  if (measures(options, "builds")) {
    tell("building, in turns");
    result.builds = measureBuilds(scene.scene, peer.get(), options);
  }
  return result;
}

}  // namespace lavaray::bench
