#include "lavaray/text_report.hpp"

#include <iomanip>
#include <string>

namespace lavaray {
namespace {

double mebibytes(std::size_t bytes) {
  return static_cast<double>(bytes) / (1U << 20U);
}

void printHierarchy(std::ostream& out, const HierarchyStatistics& hierarchy) {
  out << "bvh\n  primitives      " << hierarchy.primitives << " (" << hierarchy.droppedDuplicates
      << " duplicates dropped)\n  inner nodes     " << hierarchy.innerNodes << "\n  leaves          "
      << hierarchy.leaves << " of " << hierarchy.primitivesPerLeaf
      << " primitives in the mean\n  depth           " << hierarchy.depth << " of at most "
      << hierarchy.maxDepth << "\n  as traversed    ";
  if (hierarchy.isTraversed) {
    out << hierarchy.traversedNodes << " nodes of up to " << hierarchy.nodeWidth << " children, depth "
        << hierarchy.traversedDepth;
  } else {
    out << "not at all, each ray tests all primitives";
  }
  out << "\n  SAH cost        " << hierarchy.sahCost << '\n';
}

double millions(double number) {
  return 1e-6 * number;
}

// Of nothing there is no share.
std::string percent(double share) {
  return share > 0.0 ? std::to_string(static_cast<int>(100.0 * share + 0.5)) + " %" : "none";
}

void printRender(std::ostream& out, const Statistics& render) {
  const RayRates rates = ratesOf(render);
  out << "rays\n  camera          " << render.rays.camera << " (" << render.samplesPerPixel
      << " a pixel, at most " << render.maxSamples << ")\n  mirror          " << render.rays.mirror
      << "\n  shadow          " << render.rays.shadow << "\n  a second        " << millions(rates.all())
      << " M: " << millions(rates.camera) << " M camera, " << millions(rates.mirror) << " M mirror, "
      << millions(rates.shadow) << " M shadow\n  lanes in use    "
      << percent(render.rays.nearestHitLanesInUse) << " for nearest hits, "
      << percent(render.rays.shadowLanesInUse) << " for shadows\nskipped\n  camera rays     "
      << render.rays.skippedCamera << "\n  shadow rays     " << render.rays.skippedShadow
      << "\n  black pixels    " << render.skippedPixels << "\nsampling\n  stopped         "
      << name(render.stopReason) << '\n';
  if (render.estimatedError > 0.0) {
    out << "  estimated RMSE  " << std::setprecision(6) << render.estimatedError << std::setprecision(2)
        << '\n';
  }
}

void printActivity(std::ostream& out, const DeviceActivity& activity) {
  const auto percentOfAll = [&](double seconds) {
    return activity.seconds > 0.0 ? 100.0 * (seconds / activity.seconds) : 0.0;
  };
  out << "  idle            " << percentOfAll(activity.deviceIdleSeconds) << " % of " << activity.seconds
      << " s, by " << (activity.byDeviceClock ? "its own clock" : "the host's clock")
      << "\n  host waits      " << percentOfAll(activity.hostWaitSeconds) << " %\n";
}

void printTimes(std::ostream& out, const StepTimes& times) {
  const auto print = [&](const std::string& name, StepTimes::Clock::duration duration) {
    out << "  " << std::left << std::setw(18) << name << std::right << std::setw(9) << milliseconds(duration)
        << '\n';
  };
  out << std::setprecision(1) << "time (ms)\n";
  for (const auto& [name, duration] : times.steps()) print(name, duration);
  print("all", times.all());
}

}  // namespace

void printWarnings(std::ostream& out, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) out << "warning: " << warning << '\n';
}

void printDevices(std::ostream& out, const std::vector<DeviceInfo>& devices) {
  for (std::size_t i = 0; i < devices.size(); ++i) {
    out << i << ": " << devices[i].name << " (" << devices[i].kind << ", " << devices[i].driver << ')'
        << (devices[i].isUsable ? "" : ", not usable: no Vulkan 1.2 compute") << '\n';
  }
}

void printScene(std::ostream& out, const SceneSummary& scene) {
  out << "scene " << scene.file.string() << "\n  image           " << scene.image.width << " x "
      << scene.image.height << "\n  planes          " << scene.planes << "\n  spheres         "
      << scene.spheres << "\n  triangles       " << scene.triangles << "\n  meshes          " << scene.meshes
      << " with " << scene.meshTriangles << " triangles\n  lights          " << scene.lights << '\n';
  for (const MeshSummary& mesh : scene.meshFiles) {
    out << "  mesh file       " << mesh.file.string() << ": " << mesh.triangles << " triangles, "
        << mesh.vertices << " vertices, " << mesh.normals << " normals, " << mesh.degenerateTriangles
        << " degenerate triangles dropped\n";
  }
}

void printReport(std::ostream& out, const RunReport& report) {
  printScene(out, report.scene);
  out << std::fixed << std::setprecision(2);
  printHierarchy(out, report.render.hierarchy);
  printRender(out, report.render);
  out << "device\n  name            " << report.device.name << "\n  driver          " << report.device.driver
      << "\n  reads scene as  " << report.render.sceneReadAs << "\n  traces together "
      << report.render.raysPerInvocation << " rays\n  buffers         "
      << mebibytes(report.render.deviceBytes) << " MiB\n  dispatches      " << report.render.dispatches
      << '\n';
  printActivity(out, report.render.activity);
  out << "memory\n  process, peak   " << mebibytes(report.peakMemoryBytes) << " MiB\n";
  printTimes(out, report.times);
}

}  // namespace lavaray
