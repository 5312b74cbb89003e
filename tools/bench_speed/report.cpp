#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace lavaray::bench {
namespace {

constexpr const char* kReference = "embree robust";

const Timing* find(const std::vector<Timing>& timings, const std::string& name) {
  const auto place =
      std::find_if(timings.begin(), timings.end(), [&](const auto& t) { return t.name == name; });
  return place == timings.end() ? nullptr : &*place;
}

// Milliseconds of processor and clock time, minimum and median; the minimum processor time in nanoseconds per
// item; and how many times the reference's that is.
void printTimings(std::ostream& out, const std::vector<Timing>& timings, std::size_t items,
                  const char* item) {
  const Timing* reference = find(timings, kReference);
  out << std::fixed << "    " << std::left << std::setw(26) << "" << std::right << std::setw(11)
      << "cpu ms min" << std::setw(9) << "median" << std::setw(13) << "wall ms min" << std::setw(9)
      << "median" << std::setw(8) << "cpu ns" << '/' << item;
  if (reference != nullptr) out << "  x robust";
  out << '\n';
  for (const Timing& timing : timings) {
    out << "    " << std::left << std::setw(26) << timing.name << std::right << std::setprecision(1)
        << std::setw(11) << 1e3 * minimum(timing.cpu) << std::setw(9) << 1e3 * median(timing.cpu)
        << std::setw(13) << 1e3 * minimum(timing.wall) << std::setw(9) << 1e3 * median(timing.wall)
        << std::setw(8) << 1e9 * minimum(timing.cpu) / static_cast<double>(items)
        << std::string(1 + std::string(item).size(), ' ');
    if (reference != nullptr) {
      out << std::setprecision(2) << std::setw(10) << minimum(timing.cpu) / minimum(reference->cpu);
    }
    out << '\n';
  }
}

const char* unit(const SceneResult& scene) {
  return scene.isSpheres ? "sphere" : "triangle";
}

void printBatch(std::ostream& out, const BatchResult& batch) {
  out << "  " << batch.name << " rays as lanes of " << batch.raysPerLane << " take them: " << batch.rays
      << ", of which " << batch.hits << " hit";
  if (batch.unfinished > 0) out << ", " << batch.unfinished << " NOT FINISHED";
  if (batch.disagreements) out << "; " << *batch.disagreements << " differ from " << kReference;
  out << '\n';
  printTimings(out, batch.timings, batch.rays, "ray");
}

void printPicture(std::ostream& out, const PictureResult& picture) {
  out << "  picture: " << picture.rays << " camera and shadow rays, made and shaded by the contestants";
  if (picture.differingPixels)
    out << "; " << *picture.differingPixels << " pixels differ from " << kReference;
  out << '\n';
  printTimings(out, picture.timings, picture.rays, "ray");
}

// Minimum processor nanoseconds per item; - if it was not measured.
std::string perItem(const std::vector<Timing>& timings, const std::string& name, std::size_t items) {
  const Timing* timing = find(timings, name);
  if (timing == nullptr) return "-";
  return std::to_string(std::llround(1e9 * minimum(timing->cpu) / static_cast<double>(items)));
}

// Of the camera rays in their first order; - if they were not measured.
std::string perCameraRay(const SceneResult& scene, const std::string& name) {
  if (scene.batches.empty()) return "-";
  const BatchResult& camera = scene.batches.front();
  return perItem(camera.timings, name, camera.rays);
}

}  // namespace

void printHead(std::ostream& out, const Results& results) {
  out << "device   " << results.device << "\nembree   " << results.peer << "\nthreads  " << results.threads
      << " for Embree and for building\npictures " << results.size.width << " x " << results.size.height
      << ", " << results.rounds << " rounds after one that is not counted\n"
      << "rays     the same arrays for all, in the order in which the renderer's lanes take them; lavaray's "
         "renderer code\n         in a shader that reads them as texels\n"
      << "picture  the renderer's own shader and dispatches; Embree with single rays and the same shading\n";
  for (const std::string& reason : results.skipped) out << "skipped  " << reason << '\n';
}

void printScene(std::ostream& out, const SceneResult& scene) {
  out << '\n' << scene.name << ": " << scene.what << ", " << scene.primitives << ' ' << unit(scene) << "s\n";
  for (const BatchResult& batch : scene.batches) printBatch(out, batch);
  if (!scene.picture.timings.empty()) printPicture(out, scene.picture);
  if (!scene.builds.empty()) {
    out << "  building\n";
    printTimings(out, scene.builds, scene.primitives, unit(scene));
  }
  out << std::flush;
}

void printSummary(std::ostream& out, const Results& results) {
  out << "\ncpu ns per camera ray, cpu ns per primitive built, bytes per primitive\n    " << std::left
      << std::setw(14) << "" << std::right << std::setw(10) << "primitives" << std::setw(9) << "lavaray"
      << std::setw(9) << "robust" << std::setw(9) << "default" << std::setw(9) << "packets" << std::setw(13)
      << "build" << std::setw(9) << "embree" << std::setw(13) << "bytes" << std::setw(9) << "embree" << '\n';
  for (const SceneResult& scene : results.scenes) {
    out << "    " << std::left << std::setw(14) << scene.name << std::right << std::setw(10)
        << scene.primitives;
    for (const std::string& name : {contestant(results.raysPerLane.front()), std::string(kReference),
                                    std::string("embree default"), std::string("embree packets of 8")}) {
      out << std::setw(9) << perCameraRay(scene, name);
    }
    out << std::setw(13) << perItem(scene.builds, "lavaray all arrays", scene.primitives) << std::setw(9)
        << perItem(scene.builds, "embree default commit", scene.primitives) << std::setw(13)
        << scene.bytes / scene.primitives << std::setw(9)
        << (scene.peerBytes ? std::to_string(*scene.peerBytes / scene.primitives) : "-") << '\n';
  }
}

}  // namespace lavaray::bench
