#include "experiment.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "bvh/flatten.hpp"
#include "bvh/primitives.hpp"
#include "device_tracer.hpp"
#include "peer.hpp"
#include "render/tracer.hpp"

namespace lavaray::bench {
namespace {

Batch cameraRays(const ImagePlane& plane, const ImageSize& size) {
  Batch batch{"camera", false, true, {}};
  const glm::vec2 half = plane.size / 2.0;
  const glm::vec2 pixelSize = plane.size / glm::dvec2(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const glm::vec2 position = (glm::vec2(x, y) + 0.5F) * pixelSize;
      const glm::vec3 direction(position.x - half.x, half.y - position.y,
                                -static_cast<float>(plane.distance));
      batch.rays.push_back({glm::vec3(0.0F), INFINITY, direction, 0xFFFFFFFFU});
    }
  }
  return batch;
}

// Distances may differ by how two ways to compute them are rounded, which is most for grazing rays.
bool agree(float a, float b, bool anyHit) {
  const bool hitA = std::isfinite(a);
  const bool hitB = std::isfinite(b);
  if (hitA != hitB) return false;
  return anyHit || !hitA || std::abs(a - b) <= 1e-4F * std::max(a, b);
}

BatchResult measureBatch(DeviceTracer& tracer, Peer* peer, const Batch& batch, int rounds) {
  tracer.load(batch);
  std::vector<float> distances(batch.rays.size());
  std::vector<Contestant> contestants{{"lavaray", [&] { tracer.trace(); }}};
  if (peer != nullptr) {
    for (const Peer::Variant& variant : peer->variants()) {
      contestants.push_back({variant.name, [&, variant] { peer->trace(variant, batch, distances); }});
    }
  }
  BatchResult result{batch.name, batch.rays.size(), 0, 0, {}, measure(contestants, rounds)};
  // Not a contestant: the part of lavaray's time that is reading rays and writing results.
  result.timings.push_back(
      measure({{"(lavaray, no tracing)", [&] { tracer.readAndWrite(); }}}, rounds).front());

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

PictureResult measurePicture(vulkan::Device& device, const GpuScene& gpuScene, Peer* peer,
                             const Options& options) {
  const ImageSize size = options.size;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  RenderSettings settings;
  settings.size = size;
  settings.crop = {0, 0, size.width, size.height};
  Tracer tracer(device, gpuScene, settings, settings.crop, pixels);
  std::vector<float> rgb(3 * pixels);
  std::vector<float> peerRgb(3 * pixels);
  const auto take = [&](std::uint64_t first, std::span<const gpu::WorkResult> results) {
    float* value = &rgb[3 * first];
    for (const gpu::WorkResult& result : results) value = std::copy_n(&result.sum.x, 3, value);
  };
  std::vector<Contestant> contestants{
      {"lavaray", [&] {
         tracer.run(uniformPass(pixels, {0, 1}), 0, take, [] { return false; });
       }}};
  if (peer != nullptr) {
    for (const Peer::Variant& variant : peer->variants()) {
      if (variant.usesPackets) continue;
      contestants.push_back({variant.name, [&, variant] { peer->render(variant, size, peerRgb); }});
    }
  }
  // In its first runs the renderer finds the size of its dispatches.
  for (int i = 0; i < 2; ++i) contestants.front().run();
  PictureResult result;
  result.timings = measure(contestants, options.rounds);
  if (peer != nullptr) {
    peer->render(peer->variants().front(), size, peerRgb);
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

}  // namespace

SceneResult measureScene(vulkan::Device& device, const BenchScene& scene, const Options& options,
                         const Progress& progress) {
  SceneResult result{scene.name, scene.what, scene.isSpheres, scene.primitives, 0, {}, {}, {}, {}};
  const auto tell = [&](const std::string& what) { progress(scene.name + ": " + what); };
  tell("building");
  const GpuScene gpuScene = flatten(scene.scene, options.threads);
  const std::unique_ptr<Peer> peer = openEmbree(scene.scene, options.threads);
  if (peer) result.peerBytes = peer->sceneBytes();
  {
    DeviceTracer tracer(device, gpuScene);
    result.bytes = tracer.sceneBytes();
    PictureBatches batches = tracer.follow(cameraRays(gpuScene.imagePlane, options.size));
    result.picture.rays = batches.camera.rays.size() + batches.shadow.rays.size();
    // From a sphere's own surface Embree sees the sphere's far side, lavaray does not: that is not the same
    // work.
    if (scene.isSpheres) batches.shadow.rays = batches.mirror.rays = {};
    for (const Batch* batch : {&batches.camera, &batches.shadow, &batches.mirror}) {
      tell(batch->name + " rays");
      if (!batch->rays.empty()) {
        result.batches.push_back(measureBatch(tracer, peer.get(), *batch, options.rounds));
      }
    }
  }
  tell("the picture");
  const std::size_t rays = result.picture.rays;
  result.picture = measurePicture(device, gpuScene, peer.get(), options);
  result.picture.rays = rays;
  tell("building, in turns");
  result.builds = measureBuilds(scene.scene, peer.get(), options);
  return result;
}

}  // namespace lavaray::bench
