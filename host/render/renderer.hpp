#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "core/flatten.hpp"
#include "image/image.hpp"
#include "vulkan/compute.hpp"

namespace lavaray {

struct RenderSettings {
  ImageSize size;  // of the whole image
  Rectangle crop;  // the part of it to render
  bool countRays = false;
};

struct RenderResult {
  Image image;  // of the crop's size; black where the render was stopped before
  bool complete = true;
  std::uint64_t dispatches = 0;
  std::uint64_t cameraRays = 0;
  std::uint64_t shadowRays = 0;  // counted where the settings ask for it
};

// A scene on a device, with the pipeline for what the scene has.
class Renderer {
 public:
  Renderer(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
           const RenderSettings& settings);

  // Renders piece by piece and looks at `stop` after each, which takes about a tenth of a second.
  // Throws Error(kDevice) where the device fails or cannot finish a ray.
  RenderResult render(const std::atomic<bool>& stop);

  // Bytes of the scene's arrays and of the pixels on the device.
  [[nodiscard]] std::size_t deviceBytes() const;

 private:
  void renderPiece(std::uint64_t firstPixel, std::uint32_t pixelCount, RenderResult& result);

  vulkan::Device& device_;
  RenderSettings settings_;
  gpu::DispatchConstants constants_{};
  std::uint32_t capacity_;                       // pixels of the largest piece
  std::vector<vulkan::Buffer> buffers_;          // by binding
  std::optional<vulkan::ComputeShader> shader_;  // made when the buffers are
};

}  // namespace lavaray
