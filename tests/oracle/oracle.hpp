#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray::oracle {

// A second ray tracer to hold the first one against: double precision, no tree, no line shared with the
// renderer but the scene it reads and the size of its image.
//
// With one sample there is one ray through each pixel's centre, and lights are points whatever their radius.
// With more the pixel is the mean of samples at independent random positions in its square (box filter), each
// clamped to [0, 1]; each sample sees each light with a radius in one random direction from each point of its
// path. The samples are not stratified on purpose: nothing is shared with the renderer's sampler, and
// `standardError` is an honest measure of what is left of the noise.

struct Options {
  ImageSize size{};  // 0 x 0: the size that the camera asks for
  int x0 = 0, y0 = 0;
  int x1 = std::numeric_limits<int>::max(), y1 = std::numeric_limits<int>::max();  // exclusive
  int maxDepth = 8;                                                                // of mirror rays
  int samples = 1;                                                                 // for each pixel
  std::uint64_t seed = 0;     // of the random samples; those of a pixel depend on it and on the pixel only
  double probeOffset = 0.02;  // in pixels; 0 leaves out the probes, as several samples do
};

// `uncertain` says that a float32 renderer could legitimately decide otherwise. It is found by tracing eight
// more rays at `probeOffset` around the pixel's centre. They must tell the same story as the centre's: the
// same surfaces along the path, the same sides of them, the same lights visible from each point, the same
// sign of l.n where a specular term hangs on it. Different facets of one mesh are the same surface as long as
// the colour does not jump between them. Besides, the centre's own path must keep off the decisions that the
// probes cannot reach: shadow rays along an occluder's edge, coincident surfaces of different colour, l.n =
// 0, a power that is too steep.
struct Pixel {
  glm::dvec3 color{0.0};  // clamped to [0, 1], not truncated
  bool uncertain = false;
  // Of an uncertain pixel, what a renderer shows that decides otherwise because it rounds otherwise: the
  // colours that rays see at `probeOffset` around the centre and at tenths of it down to a millionth of a
  // pixel, with the shadow rays along occluders' edges blocked, and with them open.
  std::vector<glm::dvec3> alternatives{};
  // Of each channel's mean; 0 for one sample, and where all samples are equal: an edge that all of them miss
  // does not show in it.
  glm::dvec3 standardError{0.0};
};

struct Result {
  int width = 0, height = 0;  // of the crop
  std::vector<Pixel> pixels;  // rows from the top
};

// Runs on all processors; the result does not depend on their number. Throws std::invalid_argument where the
// camera's image or the crop has no pixel, or a pixel no sample.
Result render(const Scene& scene, const Options& options = {});

}  // namespace lavaray::oracle
