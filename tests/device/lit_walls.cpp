#include "device/lit_walls.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "device/sampled_image.hpp"
#include "support/closed_forms.hpp"

namespace lavaray {
namespace {

// The wall shows kBase + kGain times the visible part. Both are exact in float32.
constexpr double kBase = 1.0 / 128.0;
constexpr double kGain = 0.875;
constexpr double kWallZ = -4.0;
// Behind the camera, as are the occluders.
const glm::dvec3 kLight(0.4, -0.3, 4.0);

// The camera in the origin sees `halfWidth` of the wall to either side.
Penumbra wallOf(double lightRadius, const ImageSize& size, double halfWidth) {
  Penumbra result;
  result.size = size;
  result.wallPixel = 2.0 * halfWidth / size.width;
  Camera& camera = result.scene.camera;
  camera.focalLength = -kWallZ / result.wallPixel;
  camera.fovDegrees = 2.0 * std::atan(size.height / (2.0 * camera.focalLength)) * 180.0 / std::numbers::pi;
  camera.aspect = static_cast<double>(size.width) / size.height;
  result.scene.planes = {{{0, 0, 1}, {0, 0, kWallZ}, addObject(result.scene, glow(glm::dvec3(kBase)))}};
  result.scene.lights = {{kLight, glm::dvec3(kGain / kBase), glm::dvec3(0.0), glm::dvec3(0.0), lightRadius}};
  return result;
}

double coneAngle(const glm::dvec3& point, const glm::dvec3& center, double radius) {
  return std::asin(radius / glm::distance(point, center));
}

}  // namespace

MatteWall matteWall(int pixels) {
  const glm::dvec3 lamp(0.2, 0.1, -0.5);
  const double half = pixels / 2.0;
  MatteWall wall;
  wall.scene.camera = {{0, 0, 0}, 90.0, half, 1.0};
  Material matte;
  matte.diffuse = glm::dvec3(0.9);
  wall.scene.planes = {{{0, 0, 1}, {0, 0, -1}, addObject(wall.scene, matte)}};
  wall.scene.lights = {{lamp, glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0), 0.0}};
  wall.shading = [=](double x, double y) {
    const glm::dvec3 toLamp = lamp - glm::dvec3((x - half) / half, (half - y) / half, -1.0);
    return 0.9 * toLamp.z / glm::length(toLamp);
  };
  return wall;
}

glm::dvec3 Penumbra::onWall(double x, double y) const {
  return {(x - size.width / 2.0) * wallPixel, (size.height / 2.0 - y) * wallPixel, kWallZ};
}

double Penumbra::expected(int x, int y) const {
  return meanOverSquare(x, y,
                        [&](double pixelX, double pixelY) { return visibleAtPoint(onWall(pixelX, pixelY)); });
}

bool Penumbra::isPlain(int x, int y) const {
  const double corner = visibleAtPoint(onWall(x - 1, y - 1));
  return (corner == 0.0 || corner == 1.0) && visibleAtPoint(onWall(x + 2, y - 1)) == corner &&
         visibleAtPoint(onWall(x - 1, y + 2)) == corner && visibleAtPoint(onWall(x + 2, y + 2)) == corner;
}

double Penumbra::color(double visible) {
  return kBase + kGain * visible;
}

Penumbra halfPlanePenumbra(double lightRadius, const ImageSize& size) {
  constexpr double kOccluderZ = 1.0;
  // From the light's centre to the middle of the image.
  const double share = (kLight.z - kOccluderZ) / (kLight.z - kWallZ);
  const glm::dvec3 edge = kLight + share * (glm::dvec3(0.0, 0.0, kWallZ) - kLight);
  const glm::dvec3 into(std::cos(0.2), std::sin(0.2), 0.0);
  const glm::dvec3 along(-into.y, into.x, 0.0);
  const double penumbra = lightRadius * (kOccluderZ - kWallZ) / (kLight.z - kOccluderZ);
  Penumbra result = wallOf(lightRadius, size, 1.2 * penumbra);
  result.scene.triangles = {{{edge - 10.0 * along, edge + 10.0 * along, edge + 10.0 * into},
                             addObject(result.scene, glow(glm::dvec3(0.0)))}};
  result.visibleAtPoint = [=](const glm::dvec3& point) {
    glm::dvec3 normal = glm::normalize(glm::cross(edge - point, along));
    if (glm::dot(normal, into) < 0.0) normal = -normal;
    const double lit = -std::asin(glm::dot(normal, glm::normalize(kLight - point)));
    return 1.0 - capBeyond(coneAngle(point, kLight, lightRadius), lit);
  };
  return result;
}

Penumbra ballPenumbra(double lightRadius, double ballRadius, const ImageSize& size) {
  const glm::dvec3 ball = 0.5 * (kLight + glm::dvec3(0.0, 0.0, kWallZ)) + glm::dvec3(0.0, 0.0, 1.5);
  const glm::dvec3 shadow = kLight + (ball - kLight) * (kLight.z - kWallZ) / (kLight.z - ball.z);
  const double half =
      (ballRadius * (kLight.z - kWallZ) + lightRadius * (ball.z - kWallZ)) / (kLight.z - ball.z);
  Penumbra result = wallOf(lightRadius, size, 1.1 * half);
  result.scene.spheres = {{ball, ballRadius, addObject(result.scene, glow(glm::dvec3(0.0)))}};
  // The camera looks straight ahead, so the scene is moved.
  const glm::dvec3 middle(shadow.x, shadow.y, 0.0);
  result.scene.spheres[0].center -= middle;
  result.scene.lights[0].position -= middle;
  result.visibleAtPoint = [=](const glm::dvec3& pointInImage) {
    const glm::dvec3 point = pointInImage + middle;
    const double between = std::atan2(glm::length(glm::cross(ball - point, kLight - point)),
                                      glm::dot(ball - point, kLight - point));
    return 1.0 -
           capWithin(coneAngle(point, kLight, lightRadius), coneAngle(point, ball, ballRadius), between);
  };
  return result;
}

}  // namespace lavaray
