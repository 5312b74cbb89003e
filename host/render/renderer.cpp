#include "render/renderer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string>

#include "core/errors.hpp"
#include "render/scene_buffers.hpp"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

// A piece never has more pixels, so that the pixel buffer stays small whatever the image's size.
constexpr std::uint64_t kMaxPiecePixels = std::uint64_t{1} << 20U;
constexpr std::uint32_t kFirstPiecePixels = 1U << 14U;
constexpr double kPieceSeconds = 0.1;

std::uint64_t pixelsOf(const Rectangle& area) {
  return static_cast<std::uint64_t>(area.x1 - area.x0) * static_cast<std::uint64_t>(area.y1 - area.y0);
}

gpu::DispatchConstants dispatchConstants(const Camera& camera, const RenderSettings& settings,
                                         const GpuScene& scene) {
  const ImageSize plane = imageSize(camera).value();
  gpu::DispatchConstants constants{};
  constants.pixelSize =
      glm::dvec2(plane.width, plane.height) / glm::dvec2(settings.size.width, settings.size.height);
  constants.halfImage = glm::dvec2(plane.width, plane.height) / 2.0;
  constants.focalLength = static_cast<float>(camera.focalLength);
  constants.cropX = static_cast<gpu::uint>(settings.crop.x0);
  constants.cropY = static_cast<gpu::uint>(settings.crop.y0);
  constants.cropWidth = static_cast<gpu::uint>(settings.crop.x1 - settings.crop.x0);
  constants.rootReference = scene.rootReference;
  return constants;
}

}  // namespace

Renderer::Renderer(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                   const RenderSettings& settings)
    : device_(device), settings_(settings), constants_(dispatchConstants(camera, settings, scene)) {
  const std::uint64_t reachable =
      std::min<std::uint64_t>(device.limits().storageBufferRange / sizeof(gpu::Pixel),
                              std::uint64_t{device.limits().workGroupsX} * gpu::kWorkGroupSize);
  capacity_ = static_cast<std::uint32_t>(std::min({kMaxPiecePixels, reachable, pixelsOf(settings.crop)}));
  buffers_ = uploadScene(device, scene);
  buffers_.push_back(vulkan::Buffer::shared(device, "pixels", capacity_ * sizeof(gpu::Pixel)));
  buffers_.push_back(vulkan::Buffer::shared(device, "dispatch status", sizeof(gpu::DispatchStatus)));
  shader_.emplace(device, renderSpirv, specializationFor(scene, settings.countRays), buffers_,
                  sizeof constants_);
}

std::size_t Renderer::deviceBytes() const {
  std::size_t bytes = 0;
  for (const vulkan::Buffer& buffer : buffers_) bytes += buffer.size();
  return bytes;
}

RenderResult Renderer::render(const std::atomic<bool>& stop) {
  using Clock = std::chrono::steady_clock;
  RenderResult result;
  result.image.width = settings_.crop.x1 - settings_.crop.x0;
  result.image.height = settings_.crop.y1 - settings_.crop.y0;
  const std::uint64_t total = pixelsOf(settings_.crop);
  result.image.rgb.resize(3 * total);

  double piece = kFirstPiecePixels;
  for (std::uint64_t first = 0; first < total;) {
    if (stop) {
      result.complete = false;
      break;
    }
    const auto count = static_cast<std::uint32_t>(
        std::min({static_cast<std::uint64_t>(piece), std::uint64_t{capacity_}, total - first}));
    const Clock::time_point start = Clock::now();
    renderPiece(first, count, result);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // The first piece's time says nothing: drivers compile the shader in it.
    const double factor = first == 0 ? 4.0 : std::clamp(kPieceSeconds / seconds, 0.25, 4.0);
    piece = std::clamp(piece * factor, double{gpu::kWorkGroupSize}, static_cast<double>(kMaxPiecePixels));
    first += count;
  }
  return result;
}

// Dispatches until every pixel of the piece is finished, and takes their colours.
void Renderer::renderPiece(std::uint64_t firstPixel, std::uint32_t pixelCount, RenderResult& result) {
  const vulkan::Buffer& pixelBuffer = buffers_[gpu::kBindingPixels];
  auto* status = reinterpret_cast<gpu::DispatchStatus*>(buffers_[gpu::kBindingStatus].bytes());
  constants_.firstPixel = static_cast<gpu::uint>(firstPixel);
  constants_.pixelCount = pixelCount;
  constants_.resume = 0;
  std::uint32_t unfinishedBefore = pixelCount + 1;
  do {
    *status = {};
    shader_->dispatch((pixelCount + gpu::kWorkGroupSize - 1) / gpu::kWorkGroupSize,
                      std::as_bytes(std::span(&constants_, 1)));
    ++result.dispatches;
    result.shadowRays += status->shadowRays;
    const bool nothingMoved = status->stuck == status->unfinished && status->unfinished == unfinishedBefore;
    if (status->unfinished > 0 && nothingMoved) {
      throw Error(ExitCode::kDevice, device_.description().name + " ends a shader's loops before " +
                                         std::to_string(status->stuck) +
                                         " rays are through: too many surfaces overlap there");
    }
    unfinishedBefore = status->unfinished;
    constants_.resume = 1;
  } while (status->unfinished > 0);

  const auto* pixels = reinterpret_cast<const gpu::Pixel*>(pixelBuffer.bytes());
  float* rgb = result.image.rgb.data() + 3 * firstPixel;
  for (std::uint32_t i = 0; i < pixelCount; ++i)
    std::memcpy(rgb + 3 * i, &pixels[i].color, 3 * sizeof(float));
  result.cameraRays += pixelCount;
}

}  // namespace lavaray
