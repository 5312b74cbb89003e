#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lavaray {

// This room turns a scene file and its meshes into a Scene: exactly what the files state, in double precision
// and world coordinates, with nothing derived. Everything that a renderer makes of it (float arrays, bounding
// boxes, camera-relative coordinates) is made later. Errors and warnings have the form `file:line: message`;
// a warning is for what is odd but tolerated.

// Phong reflection coefficients, each >= 0.
struct Material {
  glm::dvec3 ambient{0.0};
  glm::dvec3 diffuse{0.0};
  glm::dvec3 specular{0.0};
  double shininess = 0.0;
  glm::dvec3 reflectance{0.0};     // of a perfect mirror; 0 is none
  bool statesReflectance = false;  // whether the file gives it
};

// Looks along -z; +y is up.
struct Camera {
  glm::dvec3 position{0.0};
  double fovDegrees = 60.0;  // vertical, in (0, 180)
  double focalLength = 1.0;  // distance of the image plane, in pixels, > 0
  double aspect = 1.0;       // width / height, > 0
};

// `object` numbers the surfaces (planes, spheres, triangles, meshes) in file order, from 0. It is the index
// of the surface's material; of surfaces at the same distance, the one with the lower number is seen.
struct Plane {
  glm::dvec3 normal;  // any length > 0
  glm::dvec3 point;
  std::uint32_t object;
};

struct Sphere {
  glm::dvec3 center;
  double radius;  // > 0
  std::uint32_t object;
  bool operator==(const Sphere&) const = default;
};

struct Triangle {
  std::array<glm::dvec3, 3> vertices;  // always with an area
  std::uint32_t object;
  bool operator==(const Triangle&) const = default;
};

inline constexpr std::uint32_t kNoNormal = 0xFFFFFFFF;

// Indices into the mesh's positions and normals. Either all three corners have a normal or none does.
struct MeshTriangle {
  std::array<std::uint32_t, 3> positions;
  std::array<std::uint32_t, 3> normals{kNoNormal, kNoNormal, kNoNormal};
  bool operator==(const MeshTriangle&) const = default;
};

struct Mesh {
  std::filesystem::path file;
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // of any length; none that a triangle uses is zero
  std::vector<MeshTriangle> triangles;
  std::size_t degenerateTriangles = 0;  // dropped because they have no area
  std::vector<std::string> warnings;    // each `file:line: message`
  bool operator==(const Mesh&) const = default;
};

// A mesh as an object of the scene. Several may share a mesh, since each OBJ file is read only once.
struct MeshObject {
  std::size_t mesh;  // index into Scene::meshes
  std::uint32_t object;
  bool operator==(const MeshObject&) const = default;
};

struct Light {
  glm::dvec3 position{0.0};
  glm::dvec3 ambient{0.0};
  glm::dvec3 diffuse{0.0};
  glm::dvec3 specular{0.0};
  double radius = 0.0;        // 0 is a point light
  bool statesRadius = false;  // whether the file gives it
};

struct Scene {
  std::filesystem::path file;
  Camera camera;
  std::vector<Plane> planes;
  std::vector<Sphere> spheres;
  std::vector<Triangle> triangles;
  std::vector<Mesh> meshes;
  std::vector<MeshObject> meshObjects;
  std::vector<Material> materials;  // indexed by `object`
  std::vector<Light> lights;
  std::vector<std::string> warnings;  // each `file:line: message`
};

}  // namespace lavaray
