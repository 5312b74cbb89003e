#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "oracle/oracle.hpp"

namespace lavaray {

// Scenes whose images can be worked out by hand. The camera is at the origin with a field of 90 degrees and
// an image of 101 x 101 pixels, so that the pixel (50 + i, 50 + j) looks along (i, -j, -50.5).

inline constexpr double kFocalLength = 50.5;
inline const Material kMaterial{glm::dvec3(0.1, 0.15, 0.05), glm::dvec3(0.3, 0.2, 0.4),
                                glm::dvec3(0.2, 0.3, 0.1), 2.0, glm::dvec3(0.0)};
inline const Light kLight{glm::dvec3(0.0), glm::dvec3(0.5, 0.4, 0.3), glm::dvec3(0.9, 1.0, 0.8),
                          glm::dvec3(0.6, 0.7, 0.8), 0.0};

inline Light lightAt(const glm::dvec3& position) {
  Light light = kLight;
  light.position = position;
  return light;
}

// The format's formula for one visible light, given the cosines.
inline glm::dvec3 phong(double diffuseCosine, double specularPower) {
  return kMaterial.ambient + kLight.ambient * kMaterial.ambient +
         kLight.diffuse * kMaterial.diffuse * diffuseCosine +
         kLight.specular * kMaterial.specular * specularPower;
}

inline Scene emptyScene() {
  Scene scene;
  scene.camera = {glm::dvec3(0.0), 90.0, kFocalLength, 1.0};
  return scene;
}

inline std::uint32_t addMaterial(Scene& scene, const Material& material = kMaterial) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline void addPlane(Scene& scene, const glm::dvec3& normal, const glm::dvec3& point,
                     const Material& material = kMaterial) {
  scene.planes.push_back({normal, point, addMaterial(scene, material)});
}

inline void addSphere(Scene& scene, const glm::dvec3& center, double radius,
                      const Material& material = kMaterial) {
  scene.spheres.push_back({center, radius, addMaterial(scene, material)});
}

// A large triangle in the plane z = -10 with one normal at all corners, `copies` times over.
inline void addMesh(Scene& scene, const glm::dvec3& normal, bool reversed = false, int copies = 1) {
  Mesh mesh;
  mesh.positions = {glm::dvec3(-40.0, -40.0, -10.0), glm::dvec3(40.0, -40.0, -10.0),
                    glm::dvec3(0.0, 80.0, -10.0)};
  mesh.normals = {normal};
  MeshTriangle triangle{{0, 1, 2}, {0, 0, 0}};
  if (reversed) triangle.positions = {0, 2, 1};
  mesh.triangles.assign(static_cast<std::size_t>(copies), triangle);
  scene.meshes.push_back(mesh);
  scene.meshObjects.push_back({scene.meshes.size() - 1, addMaterial(scene)});
}

inline oracle::Pixel pixelAt(const Scene& scene, int x, int y, int maxDepth = 8) {
  oracle::Options options;
  options.x0 = x;
  options.y0 = y;
  options.x1 = x + 1;
  options.y1 = y + 1;
  options.maxDepth = maxDepth;
  return oracle::render(scene, options).pixels.at(0);
}

inline void expectColor(const oracle::Pixel& pixel, const glm::dvec3& expected) {
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(pixel.color[channel], expected[channel], 1e-12);
}

}  // namespace lavaray
