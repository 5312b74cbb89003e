#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"
#include "scene/camera.hpp"

namespace lavaray::bench {

// Rays traced by all contestants. Without a peer, its figures are absent.
struct BatchResult {
  std::string name;
  unsigned raysPerLane = 0;  // by which the rays are ordered, see Batch
  std::size_t rays = 0;
  std::size_t hits = 0;
  std::size_t unfinished = 0;                // searches that lavaray's device cut short
  std::optional<std::size_t> disagreements;  // with the peer, over hit or miss or the distance
  std::vector<Timing> timings;
};

// The whole picture; each contestant makes its own rays and shades its own points. Without timings it was not
// measured.
struct PictureResult {
  std::size_t rays = 0;                        // camera and shadow rays
  std::optional<std::size_t> differingPixels;  // by more than one level of 255 in a channel
  std::vector<Timing> timings;
};

struct SceneResult {
  std::string name;
  std::string what;
  bool isSpheres = false;
  std::size_t primitives = 0;
  std::size_t bytes = 0;  // of lavaray's arrays on the device
  std::optional<std::size_t> peerBytes;
  std::vector<BatchResult> batches;
  PictureResult picture;
  std::vector<Timing> builds;
};

// The name of lavaray as a contestant, tracing so many rays together.
inline std::string contestant(unsigned raysPerLane) {
  return "lavaray, " + std::to_string(raysPerLane) + (raysPerLane == 1 ? " ray" : " rays") + " a lane";
}

struct Results {
  std::string device;
  std::string peer;  // its version, or why it is missing
  unsigned threads = 0;
  ImageSize size;
  std::vector<unsigned> raysPerLane;
  int rounds = 0;
  std::vector<std::string> skipped;  // scenes, each with the reason
  std::vector<SceneResult> scenes;
};

}  // namespace lavaray::bench
