#include "lavaray/report.hpp"

#include <sys/resource.h>

#include <iomanip>
#include <sstream>

#include "scene/camera.hpp"

namespace lavaray {
namespace {

double milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

double mebibytes(std::size_t bytes) {
  return static_cast<double>(bytes) / (1U << 20U);
}

}  // namespace

void StepTimes::endStep(const std::string& name, Clock::duration ofNext) {
  const Clock::time_point now = Clock::now() - ofNext;
  steps_.emplace_back(name, now - last_);
  last_ = now;
}

double StepTimes::seconds() const {
  return std::chrono::duration<double>(last_ - begin_).count();
}

void StepTimes::print(std::ostream& out) const {
  out << std::fixed << std::setprecision(1) << "time (ms)\n";
  for (const auto& [name, duration] : steps_) {
    out << "  " << std::left << std::setw(18) << name << std::right << std::setw(9) << milliseconds(duration)
        << '\n';
  }
  out << "  " << std::left << std::setw(18) << "all" << std::right << std::setw(9)
      << milliseconds(last_ - begin_) << '\n';
}

std::string StepTimes::inOneLine() const {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  for (const auto& [name, duration] : steps_) {
    text << (text.tellp() > 0 ? ", " : "") << name << ' ' << milliseconds(duration) << " ms";
  }
  return text.str();
}

void printWarnings(std::ostream& out, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) out << "warning: " << warning << '\n';
}

void printScene(std::ostream& out, const Scene& scene) {
  const ImageSize size = imageSize(scene.camera).value();
  out << "scene " << scene.file.string() << "\n  image           " << size.width << " x " << size.height
      << "\n  planes          " << scene.planes.size() << "\n  spheres         " << scene.spheres.size()
      << "\n  triangles       " << scene.triangles.size() << "\n  meshes          "
      << scene.meshObjects.size() << " with " << meshTriangles(scene) << " triangles"
      << "\n  lights          " << scene.lights.size() << '\n';
  for (const Mesh& mesh : scene.meshes) {
    out << "  mesh file       " << mesh.file.string() << ": " << mesh.triangles.size() << " triangles, "
        << mesh.positions.size() << " vertices, " << mesh.normals.size() << " normals, "
        << mesh.degenerateTriangles << " degenerate triangles dropped\n";
  }
}

std::size_t meshTriangles(const Scene& scene) {
  std::size_t count = 0;
  for (const MeshObject& object : scene.meshObjects) count += scene.meshes[object.mesh].triangles.size();
  return count;
}

std::size_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t{1024} * static_cast<std::size_t>(usage.ru_maxrss);
}

void printDevices(std::ostream& out, const std::vector<vulkan::DeviceDescription>& devices) {
  for (std::size_t i = 0; i < devices.size(); ++i) {
    out << i << ": " << devices[i].name << " (" << devices[i].kind << ", " << devices[i].driver << ')'
        << (devices[i].usable ? "" : ", not usable: no Vulkan 1.2 compute") << '\n';
  }
}

void printStatistics(std::ostream& out, const Scene& scene, const GpuScene& gpuScene,
                     const vulkan::Device& device, const RenderStatistics& result) {
  printScene(out, scene);
  const BvhQuality& bvh = gpuScene.bvhQuality;
  out << std::fixed << std::setprecision(2) << "bvh\n  primitives      " << gpuScene.primitives.size() << " ("
      << gpuScene.droppedDuplicates << " duplicates dropped)\n  inner nodes     " << bvh.innerNodes
      << "\n  leaves          " << bvh.leaves << " of " << bvh.leafSize
      << " primitives in the mean\n  depth           " << bvh.depth << " of at most " << gpu::kMaxBvhDepth
      << "\n  as traversed    ";
  if (gpuScene.hasFewPrimitives) {
    out << "not at all, each ray tests all primitives";
  } else {
    out << gpuScene.nodes.size() << " nodes of up to " << gpu::kNodeWidth << " children, depth "
        << gpuScene.bvhDepth;
  }
  out << "\n  SAH cost        " << bvh.sahCost << '\n';
  out << "rays\n  camera          " << result.counts.samples << " (" << result.samplesPerPixel
      << " a pixel, at most " << result.mostSamples << ")\n  mirror          " << result.counts.mirrorRays
      << "\n  shadow          " << result.counts.shadowRays << "\nskipped\n  camera rays     "
      << result.counts.skippedSamples << "\n  shadow rays     " << result.counts.skippedShadowRays
      << "\n  black pixels    " << result.skippedPixels << "\nsampling\n  stopped         "
      << stopReasonName(result.stopReason) << '\n';
  if (result.estimatedError > 0.0) {
    out << "  estimated RMSE  " << std::setprecision(6) << result.estimatedError << std::setprecision(2)
        << '\n';
  }
  out << "device\n  name            " << device.description().name << "\n  driver          "
      << device.description().driver << "\n  buffers         " << mebibytes(result.deviceBytes)
      << " MiB\n  dispatches      " << result.counts.dispatches << "\nmemory\n  process, peak   "
      << mebibytes(peakMemoryBytes()) << " MiB\n";
}

}  // namespace lavaray
