#pragma once

#include <lavaray/scene.h>

#include <string>

namespace lavaray {

// A sphere, a plane, a triangle, a mesh and a light, as a text and as objects.
inline constexpr const char* kText = R"(5
camera
pos: 0 2 10
fov: 40
f: 100
a: 1.5
sphere
pos: 0 1 0
rad: 1
amb: 0.8 0.2 0.1
dif: 0.8 0.2 0.1
spe: 0.5 0.5 0.5
shi: 30
ref: 0.3 0.3 0.3
plane
nor: 0 1 0
pos: 0 0 0
amb: 0.1 0.1 0.2
dif: 0.5 0.5 0.5
spe: 0 0 0
shi: 0
triangle
v1: -3 0 -1
v2: -1 0 -1
v3: -2 2 -1
amb: 0.1 0.5 0.1
dif: 0.1 0.5 0.1
spe: 0.2 0.2 0.2
shi: 5
light
pos: 5 9 6
amb: 0.2 0.2 0.2
dif: 1 1 1
spe: 1 1 1
rad: 0.5
)";

inline Scene objectScene() {
  Scene scene;
  scene.setCamera({{0, 2, 10}, 40.0, 100.0, 1.5});
  scene.add(
      Sphere{{0, 1, 0}, 1.0, {{0.8, 0.2, 0.1}, {0.8, 0.2, 0.1}, {0.5, 0.5, 0.5}, 30.0, Vec3{0.3, 0.3, 0.3}}});
  scene.add(Plane{{0, 1, 0}, {0, 0, 0}, {{0.1, 0.1, 0.2}, {0.5, 0.5, 0.5}, {0, 0, 0}, 0.0, {}}});
  scene.add(Triangle{{{{-3, 0, -1}, {-1, 0, -1}, {-2, 2, -1}}},
                     {{0.1, 0.5, 0.1}, {0.1, 0.5, 0.1}, {0.2, 0.2, 0.2}, 5.0, {}}});
  scene.add(Light{{5, 9, 6}, {0.2, 0.2, 0.2}, {1, 1, 1}, {1, 1, 1}, 0.5});
  return scene;
}

// An octahedron of radius 1 about `center`.
inline Mesh octahedron(const Vec3& center) {
  Mesh mesh;
  for (const double side : {1.0, -1.0}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3 vertex = center;
      vertex[axis] += side;
      mesh.vertices.insert(mesh.vertices.end(), vertex.begin(), vertex.end());
    }
  }
  mesh.faces = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
  mesh.material.ambient = mesh.material.diffuse = {0.2, 0.4, 0.9};
  return mesh;
}

}  // namespace lavaray
