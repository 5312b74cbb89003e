#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string>

#include "core/errors.hpp"
#include "renderSpirv.spv.h"

namespace lavaray {
namespace {

// A piece never has more pixels, so that the pixel buffer stays small whatever the image's size.
constexpr std::uint64_t kMaxPiecePixels = std::uint64_t{1} << 20U;
constexpr std::uint32_t kFirstPiecePixels = 1U << 14U;
constexpr double kPieceSeconds = 0.1;

template <typename Element>
std::span<const std::byte> bytesOf(const std::vector<Element>& elements) {
  return std::as_bytes(std::span(elements));
}

std::uint64_t pixelsOf(const Rectangle& area) {
  return static_cast<std::uint64_t>(area.x1 - area.x0) * static_cast<std::uint64_t>(area.y1 - area.y0);
}

gpu::DispatchConstants dispatchConstants(const Camera& camera, const RenderSettings& settings,
                                         const GpuScene& scene) {
  const ImageSize plane = imageSize(camera).value();
  gpu::DispatchConstants constants{};
  constants.pixelSize = glm::dvec2(plane.width, plane.height) / glm::dvec2(settings.size.width, settings.size.height);
  constants.halfImage = glm::dvec2(plane.width, plane.height) / 2.0;
  constants.focalLength = static_cast<float>(camera.focalLength);
  constants.cropX = static_cast<gpu::uint>(settings.crop.x0);
  constants.cropY = static_cast<gpu::uint>(settings.crop.y0);
  constants.cropWidth = static_cast<gpu::uint>(settings.crop.x1 - settings.crop.x0);
  constants.rootReference = scene.rootReference;
  return constants;
}

std::vector<std::uint32_t> specialization(const GpuScene& scene, const RenderSettings& settings) {
  std::vector<std::uint32_t> values(gpu::kSpecCount);
  values[gpu::kSpecHasSpheres] = scene.hasSpheres ? 1 : 0;
  values[gpu::kSpecHasTriangles] = scene.hasTriangles ? 1 : 0;
  values[gpu::kSpecHasCornerNormals] = scene.hasCornerNormals ? 1 : 0;
  values[gpu::kSpecPlaneCount] = static_cast<std::uint32_t>(scene.planes.size());
  values[gpu::kSpecLightCount] = static_cast<std::uint32_t>(scene.lights.size());
  values[gpu::kSpecCountRays] = settings.countRays ? 1 : 0;
  return values;
}

}  // namespace

Renderer::Renderer(vulkan::Device& device, const GpuScene& scene, const Camera& camera,
                   const RenderSettings& settings)
    : device_(device), settings_(settings), constants_(dispatchConstants(camera, settings, scene)) {
  const std::uint64_t reachable = std::min<std::uint64_t>(
      device.limits().storageBufferRange / sizeof(gpu::Pixel),
      std::uint64_t{device.limits().workGroupsX} * gpu::kWorkGroupSize);
  capacity_ = static_cast<std::uint32_t>(std::min({kMaxPiecePixels, reachable, pixelsOf(settings.crop)}));
  uploadScene(scene);
  std::vector<const vulkan::Buffer*> bound;
  for (const vulkan::Buffer& buffer : buffers_) bound.push_back(&buffer);
  shader_.emplace(device_, renderSpirv, specialization(scene, settings), bound, sizeof constants_);
}

// The buffers in the order of their bindings.
void Renderer::uploadScene(const GpuScene& scene) {
  const auto upload = [&](const char* name, vulkan::BufferUse use, std::span<const std::byte> content) {
    // Vulkan knows no empty buffer; the pipeline of a scene without such things never reads this one.
    static constexpr std::array<std::byte, 64> kNothing{};
    buffers_.push_back(vulkan::Buffer::uploaded(device_, name, use, content.empty() ? kNothing : content));
  };
  using enum vulkan::BufferUse;
  upload("BVH nodes", kTexels, bytesOf(scene.nodes));
  upload("primitives", kTexels, bytesOf(scene.primitives));
  upload("triangle planes", kTexels, bytesOf(scene.trianglePlanes));
  upload("corner normals", kTexels, bytesOf(scene.cornerNormals));
  upload("planes", kStorage, bytesOf(scene.planes));
  upload("lights", kStorage, bytesOf(scene.lights));
  upload("materials", kStorage, bytesOf(scene.materials));
  buffers_.push_back(vulkan::Buffer::shared(device_, "pixels", capacity_ * sizeof(gpu::Pixel)));
  buffers_.push_back(vulkan::Buffer::shared(device_, "dispatch status", sizeof(gpu::DispatchStatus)));
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
  for (std::uint32_t i = 0; i < pixelCount; ++i) std::memcpy(rgb + 3 * i, &pixels[i].color, 3 * sizeof(float));
  result.cameraRays += pixelCount;
}

}  // namespace lavaray
