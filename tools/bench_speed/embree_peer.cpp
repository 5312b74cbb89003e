#include <array>
#include <atomic>
#include <limits>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "bvh/frame.hpp"
#include "embree.hpp"
#include "embree_picture.hpp"
#include "peer.hpp"

namespace lavaray::bench {
namespace {

constexpr float kMiss = std::numeric_limits<float>::infinity();
constexpr std::size_t kBlock = 1024;  // rays that a thread takes at once

class Embree : public Peer {
 public:
  Embree(const Scene& scene, unsigned threads) : input_(scene), frame_(frameOf(scene)), threads_(threads) {
    device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (device_ == nullptr) throw Error(ExitCode::kInternalError, "Embree makes no device");
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* self, ssize_t bytes, bool) {
          static_cast<Embree*>(self)->bytes_ += bytes;
          return true;
        },
        this);
    geometry_ = scene.spheres.empty() ? triangles() : spheres();
    rtcCommitGeometry(geometry_);
    build();
    defaultBytes_ = bytes_;
    robust_ = commit(RTC_SCENE_FLAG_ROBUST);
  }
  ~Embree() override {
    rtcReleaseScene(default_);
    rtcReleaseScene(robust_);
    rtcReleaseGeometry(geometry_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  [[nodiscard]] std::vector<Variant> variants() const override {
    return {{"embree robust", true, false},
            {"embree default", false, false},
            {"embree packets of 8", false, true}};
  }

  void trace(const Variant& variant, const Batch& batch, std::span<float> distances) override {
    RTCScene scene = variant.isRobust ? robust_ : default_;
    const std::size_t count = batch.rays.size();
    parallelFor((count + kBlock - 1) / kBlock, threads_, [&](std::size_t block) {
      const std::size_t end = std::min(count, (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < end; variant.usesPackets ? i += 8 : ++i) {
        if (variant.usesPackets) {
          tracePacket(scene, batch, i, std::min<std::size_t>(8, end - i), distances);
        } else {
          distances[i] = traceOne(scene, batch.rays[i], batch.anyHit);
        }
      }
    });
  }

  void render(const Variant& variant, const ImageSize& size, std::span<float> rgb) override {
    renderWithEmbree(variant.isRobust ? robust_ : default_, input_, frame_, size, threads_, rgb);
  }

  void build() override {
    if (default_ != nullptr) rtcReleaseScene(default_);
    default_ = commit(RTC_SCENE_FLAG_NONE);
  }

  [[nodiscard]] std::size_t sceneBytes() const override { return defaultBytes_; }

 private:
  RTCGeometry triangles() {
    const Mesh& mesh = input_.meshes.front();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      vertices[i] = frame_.position(mesh.positions[i]);
    }
    using Indices = std::array<std::uint32_t, 3>;
    auto* indices = static_cast<Indices*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Indices), mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) indices[i] = mesh.triangles[i].positions;
    return geometry;
  }

  RTCGeometry spheres() {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* places = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), input_.spheres.size()));
    for (std::size_t i = 0; i < input_.spheres.size(); ++i) {
      const Sphere& sphere = input_.spheres[i];
      places[i] = glm::vec4(frame_.position(sphere.center), frame_.length(sphere.radius));
    }
    return geometry;
  }

  RTCScene commit(RTCSceneFlags flags) {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, flags);
    rtcAttachGeometry(scene, geometry_);
    rtcCommitScene(scene);
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE) {
      throw Error(ExitCode::kInternalError, "Embree fails with error " + std::to_string(error));
    }
    return scene;
  }

  static float traceOne(RTCScene scene, const gpu::BatchRay& ray, bool anyHit) {
    if (!isThere(ray)) return kMiss;
    EmbreeTracer tracer;
    if (anyHit) {
      RTCRay query = makeRay(ray.origin, ray.direction, ray.tMax);
      tracer.occluded(scene, &query);
      return query.tfar < 0.0F ? 0.0F : kMiss;
    }
    RTCRayHit query;
    query.ray = makeRay(ray.origin, ray.direction, ray.tMax);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    tracer.intersect(scene, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kMiss : query.ray.tfar;
  }

  static RTCRay makeRay(const glm::vec3& origin, const glm::vec3& direction, float tMax) {
    return {origin.x, origin.y, origin.z, 0.0F, direction.x, direction.y, direction.z, 0.0F, tMax, ~0U, 0, 0};
  }

  static void fillLane(auto& packet, int lane, const gpu::BatchRay& ray) {
    packet.org_x[lane] = ray.origin.x;
    packet.org_y[lane] = ray.origin.y;
    packet.org_z[lane] = ray.origin.z;
    packet.dir_x[lane] = ray.direction.x;
    packet.dir_y[lane] = ray.direction.y;
    packet.dir_z[lane] = ray.direction.z;
    packet.tnear[lane] = 0.0F;
    packet.tfar[lane] = ray.tMax;
    packet.time[lane] = 0.0F;
    packet.mask[lane] = ~0U;
    packet.flags[lane] = 0;
  }

  static void tracePacket(RTCScene scene, const Batch& batch, std::size_t first, std::size_t count,
                          std::span<float> distances) {
    EmbreeTracer tracer(batch.isCoherent);
    alignas(32) int valid[8];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      valid[lane] = lane < count && isThere(batch.rays[first + lane]) ? -1 : 0;
    }
    if (batch.anyHit) {
      RTCRay8 packet;
      for (std::size_t lane = 0; lane < 8; ++lane) {
        fillLane(packet, static_cast<int>(lane), batch.rays[first + std::min(lane, count - 1)]);
      }
      tracer.occluded(valid, scene, &packet);
      for (std::size_t lane = 0; lane < count; ++lane) {
        distances[first + lane] = valid[lane] != 0 && packet.tfar[lane] < 0.0F ? 0.0F : kMiss;
      }
      return;
    }
    RTCRayHit8 packet;
    for (std::size_t lane = 0; lane < 8; ++lane) {
      fillLane(packet.ray, static_cast<int>(lane), batch.rays[first + std::min(lane, count - 1)]);
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    tracer.intersect(valid, scene, &packet);
    for (std::size_t lane = 0; lane < count; ++lane) {
      distances[first + lane] =
          packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? kMiss : packet.ray.tfar[lane];
    }
  }

  const Scene& input_;
  Frame frame_;
  unsigned threads_;
  RTCDevice device_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  RTCScene default_ = nullptr;
  RTCScene robust_ = nullptr;
  std::atomic<std::ptrdiff_t> bytes_{0};
  std::size_t defaultBytes_ = 0;
};

}  // namespace

std::string embreeDescription() {
  RTCDevice device = rtcNewDevice(nullptr);
  const auto property = [&](RTCDeviceProperty name) { return rtcGetDeviceProperty(device, name); };
  std::string text = "Embree " + std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MAJOR)) + "." +
                     std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MINOR)) + "." +
                     std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_PATCH));
  const bool wide = property(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  rtcReleaseDevice(device);
  return text + (wide ? ", its 16-wide code" : ", its 8-wide code") + ", called by code built with " +
         LAVARAY_BENCH_FLAGS;
}

std::unique_ptr<Peer> openEmbree(const Scene& scene, unsigned threads) {
  return std::make_unique<Embree>(scene, threads);
}

}  // namespace lavaray::bench
