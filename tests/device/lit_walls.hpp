#pragma once

#include <functional>

#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// Scenes of a wall before the camera and a light, whose images have closed forms.

// A matte wall close to a lamp; the image is square.
struct MatteWall {
  Scene scene;
  std::function<double(double x, double y)> shading;  // at a position in the image, in pixels
};
MatteWall matteWall(int pixels);

// A wall that shows which part of a spherical light each of its points sees. The light's colour does not
// depend on the direction (its ambient term alone), and stays below where it would be clamped.
struct Penumbra {
  Scene scene;
  ImageSize size;
  double wallPixel;                                         // a pixel's width on the wall
  std::function<double(const glm::dvec3&)> visibleAtPoint;  // closed form

  // A position in the image, in pixels, as a point of the wall.
  [[nodiscard]] glm::dvec3 onWall(double x, double y) const;
  // Mean over a pixel of the closed form.
  [[nodiscard]] double expected(int x, int y) const;
  // Whether the pixel and those about it see all of the light or nothing of it.
  [[nodiscard]] bool isPlain(int x, int y) const;
  // What the wall shows where so much of the light is visible.
  static double color(double visible);
};

// The shadow of a half-plane's edge; the image is just wider than the penumbra.
Penumbra halfPlanePenumbra(double lightRadius, const ImageSize& size);

// The shadow of a ball, with the middle of it in the middle of the image.
Penumbra ballPenumbra(double lightRadius, double ballRadius, const ImageSize& size);

}  // namespace lavaray
