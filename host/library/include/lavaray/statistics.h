#ifndef LAVARAY_STATISTICS_H
#define LAVARAY_STATISTICS_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <lavaray/types.h>

// What is in a scene, what a render did, and how two images differ.
namespace lavaray::v0 {

struct MeshSummary {
  std::filesystem::path file;  // empty for one that was added
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t normals = 0;
  std::size_t degenerateTriangles = 0;  // dropped
};

struct SceneSummary {
  std::filesystem::path file;
  ImageSize image;  // that the camera asks for
  std::size_t planes = 0;
  std::size_t spheres = 0;
  std::size_t triangles = 0;
  std::size_t meshes = 0;
  std::size_t meshTriangles = 0;  // of all meshes
  std::size_t lights = 0;
  std::size_t sphericalLights = 0;     // of these: with a radius above 0
  std::vector<MeshSummary> meshFiles;  // each mesh once, however often the scene shows it
};

// The hierarchy over the scene's triangles and spheres, as built and as the device traverses it.
struct HierarchyStatistics {
  std::size_t primitives = 0;
  std::size_t droppedDuplicates = 0;  // primitives that coincide with another and can never be seen
  std::size_t innerNodes = 0;
  std::size_t leaves = 0;
  double primitivesPerLeaf = 0.0;  // mean
  std::uint32_t depth = 0;         // inner nodes on the longest path
  std::uint32_t maxDepth = 0;      // that any scene may have
  double sahCost = 0.0;      // expected node visits and primitive tests of a random ray that hits the root
  bool isTraversed = false;  // else each ray tests all primitives
  std::size_t traversedNodes = 0;
  std::uint32_t traversedDepth = 0;
  std::uint32_t nodeWidth = 0;  // children of a traversed node, at most
};

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t skippedCamera = 0;  // through tiles of the picture that show nothing
  // These are counted with RenderOptions::countRays.
  std::uint64_t mirror = 0;
  std::uint64_t shadow = 0;
  std::uint64_t skippedShadow = 0;  // their light would add nothing, or nothing that shows
  // The share of the device's lanes that has something to do while their groups search the hierarchy, for
  // nearest hits and for shadows; 0 where nothing is searched.
  double nearestHitLanesInUse = 0.0;
  double shadowLanesInUse = 0.0;
};

// Seconds since the device began with the first of the dispatches, by the host's clock.
struct DispatchTimes {
  double submitted = 0.0;
  double begin = 0.0;  // of the device's work on it
  double end = 0.0;
  double waitBegin = 0.0;
  double waitEnd = 0.0;
};

// When the device was busy and the host waited, with RenderOptions::countRays.
struct DeviceActivity {
  bool byDeviceClock = false;      // or by the host's
  double seconds = 0.0;            // from the begin of the first dispatch to the end of the last
  double deviceIdleSeconds = 0.0;  // of these
  double hostWaitSeconds = 0.0;
  std::vector<DispatchTimes> first;  // of the first 1000 dispatches
};

struct Statistics {
  StopReason stopReason = StopReason::kFinished;
  double samplesPerPixel = 0.0;     // mean over pixels that are not skipped, including samples of a film
  double estimatedError = 0.0;      // RMSE, where there was a target
  std::uint32_t maxSamples = 1;     // of a pixel
  std::uint64_t skippedPixels = 0;  // known to be black without a sample
  RayCounts rays;
  std::uint64_t dispatches = 0;
  std::size_t deviceBytes = 0;
  std::string sceneReadAs;              // texels or storage; these two: see TuningOptions
  std::uint32_t raysPerInvocation = 1;  // that are traced together
  DeviceActivity activity;
  double largestMeasure = 0.0;  // of a pixel, where the view is depth or cost: that is shown as 1
  HierarchyStatistics hierarchy;
};

// How far the finite values of some channels are apart.
struct ChannelDifference {
  std::size_t differing = 0;  // pixels that are off by more than the tolerance
  double largest = 0.0;       // at pixel (x, y)
  int x = 0;
  int y = 0;
  double rmse = 0.0;
};

// How two images of the same size differ. A pixel that is finite in both counts towards the figures of its
// channels. Of any other it only matters whether both have the same values there; all NaNs count as the same.
struct Difference {
  std::size_t pixels = 0;
  std::size_t differing = 0;  // pixels with a channel, or alpha, off by more than the tolerance, or unlike
  std::size_t finite = 0;     // pixels that are finite in both
  // Other pixels, whose values are not the same in both; the first is at (unlikeX, unlikeY).
  std::size_t unlike = 0;
  int unlikeX = 0;
  int unlikeY = 0;
  ChannelDifference color;
  ChannelDifference alpha;  // of an image without alpha it is 1
};

// How far an image may be from its reference. Only limits that are given count; if there are none, no pixel
// may differ.
struct DifferenceLimits {
  std::optional<double> tolerance;  // in 1/255
  std::optional<std::size_t> maxDiffering;
  std::optional<double> maxRmse;
  std::optional<double> maxFlip;
};

// Two image files to be compared. A path that is empty is a partner that is missing.
struct ImagePair {
  std::string name;
  std::filesystem::path image;
  std::filesystem::path reference;
  std::string driver;  // that rendered the image, in words; may be empty
  DifferenceLimits limits;
};

enum class Verdict { kAlike, kDiffers, kSizesDiffer, kImageMissing, kReferenceMissing, kUnreadable };

}  // namespace lavaray::v0

#endif
