#include "embree_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "base/parallel.hpp"

namespace lavaray::bench {
namespace {

struct FloatLight {
  glm::vec3 position;
  glm::vec3 ambient;
  glm::vec3 diffuse;
  glm::vec3 specular;
};

struct FloatMaterial {
  glm::vec3 ambient;
  glm::vec3 diffuse;
  glm::vec3 specular;
  float shininess;
};

RTCRay makeRay(const glm::vec3& origin, const glm::vec3& direction, float tMax) {
  return {origin.x, origin.y, origin.z, 0.0F, direction.x, direction.y, direction.z, 0.0F, tMax, ~0U, 0, 0};
}

class Picture {
 public:
  Picture(RTCScene embree, const Scene& scene, const Frame& frame, const ImageSize& size)
      : embree_(embree), size_(size), focalLength_(static_cast<float>(scene.camera.focalLength)) {
    for (const Light& light : scene.lights) {
      lights_.push_back({frame.position(light.position), light.ambient, light.diffuse, light.specular});
    }
    // All shapes of a benchmark's scene share a material.
    const Material& m = scene.materials.front();
    material_ = {m.ambient, m.diffuse, m.specular, static_cast<float>(m.shininess)};
  }

  glm::vec3 pixel(int x, int y) {
    const glm::vec2 half = 0.5F * glm::vec2(size_.width, size_.height);
    const glm::vec3 direction(static_cast<float>(x) + 0.5F - half.x, half.y - (static_cast<float>(y) + 0.5F),
                              -focalLength_);
    RTCRayHit query;
    query.ray = makeRay(glm::vec3(0.0F), direction, std::numeric_limits<float>::infinity());
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    tracer_.intersect(embree_, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return glm::vec3(0.0F);
    const glm::vec3 side = glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z));
    const glm::vec3 normal = glm::dot(side, direction) > 0.0F ? -side : side;
    return shade(query.ray.tfar * direction, normal, -glm::normalize(direction));
  }

 private:
  glm::vec3 shade(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& toViewer) {
    // Far more than the position's rounding error, far less than a triangle.
    const glm::vec3 magnitude = glm::abs(position);
    const float offset = 4e-6F * std::max({magnitude.x, magnitude.y, magnitude.z});
    glm::vec3 color = material_.ambient;
    for (const FloatLight& light : lights_) {
      const glm::vec3 toLight = glm::normalize(light.position - position);
      const float cosine = glm::dot(toLight, normal);
      const glm::vec3 origin = position + (cosine < 0.0F ? -offset : offset) * normal;
      RTCRay shadow = makeRay(origin, light.position - origin, 1.0F - 1e-6F);
      tracer_.occluded(embree_, &shadow);
      if (shadow.tfar < 0.0F) continue;
      color += light.ambient * material_.ambient;
      if (cosine <= 0.0F) continue;
      const float highlight = glm::dot(2.0F * cosine * normal - toLight, toViewer);
      color += light.diffuse * material_.diffuse * cosine;
      if (highlight > 0.0F) {
        color += light.specular * material_.specular * std::pow(highlight, material_.shininess);
      }
    }
    return glm::clamp(color, 0.0F, 1.0F);
  }

  RTCScene embree_;
  ImageSize size_;
  float focalLength_;
  std::vector<FloatLight> lights_;
  FloatMaterial material_;
  EmbreeTracer tracer_;
};

}  // namespace

void renderWithEmbree(RTCScene embree, const Scene& scene, const Frame& frame, const ImageSize& size,
                      unsigned threads, std::span<float> rgb) {
  parallelFor(size.height, threads, [&](std::size_t row) {
    Picture picture(embree, scene, frame, size);
    float* out = rgb.data() + 3 * row * size.width;
    for (int x = 0; x < size.width; ++x) {
      const glm::vec3 color = picture.pixel(x, static_cast<int>(row));
      for (int channel = 0; channel < 3; ++channel) *out++ = color[channel];
    }
  });
}

}  // namespace lavaray::bench
