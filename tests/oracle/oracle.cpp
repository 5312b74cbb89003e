#include "oracle/oracle.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oracle/geometry.hpp"
#include "oracle/sampling.hpp"

namespace lavaray::oracle {
namespace {

using glm::dvec3;

constexpr double kHalfLevel = 0.5 / 255.0;  // a colour difference of no consequence
constexpr double kSteepStep = 0.1;          // a colour difference too large for the width of the probes
constexpr double kMinWeight = 1e-4;         // a mirror ray that counts for less is dropped

// What a point of the path saw of one light.
enum class LightState : std::uint8_t { kBlocked, kVisible, kVisibleFromBehind, kAtThePoint };

struct PathPoint {
  std::uint32_t surface = kNoSurface;  // kNoSurface: the background
  dvec3 normal{0.0};
  std::vector<LightState> lights;
};

// A point of the path, to be lit.
struct ShadedPoint {
  dvec3 position;
  dvec3 toViewer;  // of unit length
  const Material& material;
  PathPoint& path;
};

// What a shadow ray along an occluder's edge says.
enum class Doubtful : std::uint8_t { kAsComputed, kIsBlocked, kIsVisible };

struct Trace {
  Random* random = nullptr;  // for the directions to lights; null: lights are points
  Doubtful doubtful = Doubtful::kAsComputed;
  dvec3 color{0.0};
  bool certain = true;
  std::vector<PathPoint> path;
};

double largest(const dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

double difference(const dvec3& a, const dvec3& b) {
  return largest(glm::abs(glm::clamp(a, 0.0, 1.0) - glm::clamp(b, 0.0, 1.0)));
}

class Tracer {
 public:
  Tracer(const Scene& scene, int maxDepth) : scene_(scene), geometry_(flatten(scene)), maxDepth_(maxDepth) {}

  [[nodiscard]] Trace trace(const dvec3& direction, bool compareCoincident, Random* random = nullptr,
                            Doubtful doubtful = Doubtful::kAsComputed) const {
    Trace result{random, doubtful, {}, true, {}};
    result.color =
        radiance({dvec3(0.0), glm::normalize(direction)}, dvec3(1.0), 0, compareCoincident, result);
    return result;
  }

  // Do the two rays tell the same story? See Pixel.
  [[nodiscard]] bool agree(const Trace& a, const Trace& b) const {
    if (a.path.size() != b.path.size()) return false;
    bool sameParts = true;
    for (std::size_t i = 0; i < a.path.size(); ++i) {
      const PathPoint& p = a.path[i];
      const PathPoint& q = b.path[i];
      if (p.lights != q.lights || glm::dot(p.normal, q.normal) < 0.0) return false;
      if (p.surface == q.surface) continue;
      if (p.surface == kNoSurface || q.surface == kNoSurface) return false;
      if (identity(geometry_, p.surface).object != identity(geometry_, q.surface).object) return false;
      sameParts = false;
    }
    return difference(a.color, b.color) <= (sameParts ? kSteepStep : kHalfLevel);
  }

 private:
  // `weight` is the product of the reflectances so far: what the ray's colour counts in the pixel.
  dvec3 radiance(const Ray& ray, const dvec3& weight, int depth, bool compareCoincident, Trace& trace) const {
    const std::vector<Hit> hits = nearestHits(geometry_, ray);
    if (hits.empty()) {
      trace.path.emplace_back();
      return dvec3(0.0);
    }
    const dvec3 color = shade(ray, hits[0], weight, depth, compareCoincident, trace);
    for (std::size_t i = 1; compareCoincident && i < hits.size(); ++i) {
      Trace other;
      const dvec3 otherColor = shade(ray, hits[i], weight, depth, false, other);
      if (largest(weight * glm::abs(otherColor - color)) > kHalfLevel) trace.certain = false;
    }
    return color;
  }

  dvec3 shade(const Ray& ray, const Hit& hit, const dvec3& weight, int depth, bool compareCoincident,
              Trace& trace) const {
    const dvec3 position = ray.origin + hit.distance * ray.direction;
    const Normal normal = shadingNormal(geometry_, hit.surface, position, ray.direction);
    const Material& material = scene_.materials[identity(geometry_, hit.surface).object];
    trace.certain = trace.certain && normal.certain;
    PathPoint pathPoint{hit.surface, normal.direction, {}};
    const ShadedPoint point{position, -ray.direction, material, pathPoint};
    dvec3 color = material.ambient;
    for (const Light& light : scene_.lights) {
      const dvec3 center = light.position - scene_.camera.position;
      const bool sampled = trace.random != nullptr && light.radius > 0.0;
      const dvec3 seen = sampled ? pointOnLight(position, center, light.radius, *trace.random) : center;
      color += lightTerm(light, seen, point, trace);
    }
    trace.path.push_back(std::move(pathPoint));

    const dvec3 mirrored = weight * material.reflectance;
    if (largest(mirrored) < kMinWeight || depth >= maxDepth_) return color;
    const dvec3 direction =
        ray.direction - 2.0 * glm::dot(ray.direction, normal.direction) * normal.direction;
    const Ray reflected{position, glm::normalize(direction), hit.surface};
    return color + material.reflectance * radiance(reflected, mirrored, depth + 1, compareCoincident, trace);
  }

  // The light's share of the point's colour, as if the light were at `lightPosition`. Adds what the light is
  // to the point to its path.
  dvec3 lightTerm(const Light& light, const dvec3& lightPosition, const ShadedPoint& point,
                  Trace& trace) const {
    const Material& material = point.material;
    bool& certain = trace.certain;
    const dvec3 toLight = lightPosition - point.position;
    const double distance = glm::length(toLight);
    const double scale = magnitude(point.position) + magnitude(lightPosition);
    if (distance <= kFloatError * scale) certain = false;
    if (distance <= kOnSurface * scale) {
      point.path.lights.push_back(LightState::kAtThePoint);
      return light.ambient * material.ambient;
    }
    const Occlusion shadow = occlusion(geometry_, point.position, point.path.surface, lightPosition);
    certain = certain && shadow.certain;
    const bool isOpen = shadow.certain || trace.doubtful == Doubtful::kAsComputed;
    if (isOpen ? shadow.blocked : trace.doubtful == Doubtful::kIsBlocked) {
      point.path.lights.push_back(LightState::kBlocked);
      return dvec3(0.0);
    }
    const dvec3 l = toLight / distance;
    const double cosine = glm::dot(l, point.path.normal);
    const dvec3 ambient = light.ambient * material.ambient;
    const dvec3 specular = light.specular * material.specular;
    const bool shiny = largest(specular) > 0.0;
    if (shiny && std::abs(cosine) < 1e-5) certain = false;
    // The diffuse term passes through l.n = 0 without a step, so that the sign is of interest only if shiny.
    point.path.lights.push_back(shiny && cosine <= 0.0 ? LightState::kVisibleFromBehind
                                                       : LightState::kVisible);
    if (cosine <= 0.0) return ambient;
    const dvec3 mirrored = 2.0 * cosine * point.path.normal - l;
    const double alignment = glm::dot(mirrored, point.toViewer);
    // x^shi is infinitely steep at 0 if shi < 1 and close to it at 1 if shi is large.
    const double step = power(alignment + kFloatError, material.shininess) -
                        power(alignment - kFloatError, material.shininess);
    if (largest(specular) * step > kHalfLevel) certain = false;
    return ambient + light.diffuse * material.diffuse * cosine +
           specular * power(alignment, material.shininess);
  }

  // 0^0 is 1, as std::pow has it.
  static double power(double base, double exponent) { return std::pow(std::clamp(base, 0.0, 1.0), exponent); }

  const Scene& scene_;
  Geometry geometry_;
  int maxDepth_;
};

// The part of the image plane that the image shows, divided into pixels.
struct View {
  double focalLength;
  ImageSize natural, size;

  // Of the ray through the point of the image, in pixels from the top left corner.
  [[nodiscard]] dvec3 direction(double x, double y) const {
    const double u = x * natural.width / size.width - natural.width / 2.0;
    const double v = natural.height / 2.0 - y * natural.height / size.height;
    return {u, v, -focalLength};
  }
};

Pixel renderCenter(const Tracer& tracer, const View& view, int x, int y, double offset) {
  const auto traceAt = [&](double dx, double dy, bool compareCoincident, Doubtful doubtful) {
    return tracer.trace(view.direction(x + 0.5 + dx, y + 0.5 + dy), compareCoincident, nullptr, doubtful);
  };
  const Trace center = traceAt(0.0, 0.0, true, Doubtful::kAsComputed);
  Pixel pixel{glm::clamp(center.color, 0.0, 1.0), !center.certain, {}, {}};
  if (offset == 0.0) return pixel;
  // Calls `visit` with the ray through each of eight places around the centre until it returns false.
  const auto visitAround = [&](double distance, Doubtful doubtful, const auto& visit) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        if (!visit(traceAt(dx * distance, dy * distance, false, doubtful))) return;
      }
    }
  };
  visitAround(offset, Doubtful::kAsComputed, [&](const Trace& probe) {
    pixel.uncertain = pixel.uncertain || !tracer.agree(center, probe);
    return !pixel.uncertain;
  });
  if (!pixel.uncertain) return pixel;
  // Closer and closer, down to what float32 rounds: at a horizon the colours of all these are different ones.
  for (double distance = offset; distance > 1e-6; distance *= 0.1) {
    for (const Doubtful doubtful : {Doubtful::kIsBlocked, Doubtful::kIsVisible}) {
      visitAround(distance, doubtful, [&](const Trace& probe) {
        pixel.alternatives.push_back(glm::clamp(probe.color, 0.0, 1.0));
        return true;
      });
    }
  }
  return pixel;
}

Pixel renderSamples(const Tracer& tracer, const View& view, int x, int y, int samples, std::uint64_t seed) {
  Random random = pixelRandom(seed, x, y);
  Mean mean;
  for (int i = 0; i < samples; ++i) {
    const double dx = uniform(random);
    const double dy = uniform(random);
    const Trace trace = tracer.trace(view.direction(x + dx, y + dy), false, &random);
    mean.add(glm::clamp(trace.color, 0.0, 1.0));
  }
  return {mean.value(), false, {}, mean.standardError()};
}

}  // namespace

Result render(const Scene& scene, const Options& options) {
  const std::optional<ImageSize> natural = imageSize(scene.camera);
  if (!natural) throw std::invalid_argument("the camera's image has no pixel or is too large");
  const ImageSize size = options.size.width > 0 ? options.size : *natural;
  const int x1 = std::min(options.x1, size.width);
  const int y1 = std::min(options.y1, size.height);
  if (options.x0 < 0 || options.y0 < 0 || options.x0 >= x1 || options.y0 >= y1) {
    throw std::invalid_argument("the crop has no pixel of the image");
  }
  if (options.samples < 1) throw std::invalid_argument("a pixel needs at least one sample");
  Result result{x1 - options.x0, y1 - options.y0, {}};
  result.pixels.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));

  const Tracer tracer(scene, options.maxDepth);
  const View view{scene.camera.focalLength, *natural, size};
  const auto renderPixel = [&](int x, int y) {
    return options.samples == 1 ? renderCenter(tracer, view, x, y, options.probeOffset)
                                : renderSamples(tracer, view, x, y, options.samples, options.seed);
  };
  std::atomic<int> nextRow{0};
  const auto renderRows = [&] {
    for (int row = nextRow++; row < result.height; row = nextRow++) {
      Pixel* pixels = result.pixels.data() + static_cast<std::ptrdiff_t>(row) * result.width;
      for (int column = 0; column < result.width; ++column) {
        pixels[column] = renderPixel(options.x0 + column, options.y0 + row);
      }
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(renderRows);
  renderRows();
  threads.clear();  // joins
  return result;
}

}  // namespace lavaray::oracle
