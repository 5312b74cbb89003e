#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lavaray {

// A scene as its file states it: double precision, world coordinates, nothing derived. Everything that a
// renderer makes of it (float arrays, bounding boxes, camera-relative coordinates) is made later.

// Phong reflection coefficients, each >= 0.
struct Material {
  glm::dvec3 ambient{0.0};
  glm::dvec3 diffuse{0.0};
  glm::dvec3 specular{0.0};
  double shininess = 0.0;
  glm::dvec3 reflectance{0.0};     // of the perfect mirror; 0 is none
  bool statesReflectance = false;  // whether the file does
};

// Looks down -z with +y up.
struct Camera {
  glm::dvec3 position{0.0};
  double fovDegrees = 60.0;  // vertical, in (0, 180)
  double focalLength = 1.0;  // distance of the image plane, in pixels, > 0
  double aspect = 1.0;       // width / height, > 0
};

// `object` counts the surfaces (planes, spheres, triangles, meshes) in the order of the file, from 0. It is
// the index of the surface's material, and between surfaces at the same distance the lower one is seen.
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
  std::array<glm::dvec3, 3> vertices;  // never without area
  std::uint32_t object;
  bool operator==(const Triangle&) const = default;
};

inline constexpr std::uint32_t kNoNormal = 0xFFFFFFFF;

// Indices into the mesh's positions and normals. Either all three corners have a normal or none has.
struct MeshTriangle {
  std::array<std::uint32_t, 3> positions;
  std::array<std::uint32_t, 3> normals{kNoNormal, kNoNormal, kNoNormal};
  bool operator==(const MeshTriangle&) const = default;
};

struct Mesh {
  std::filesystem::path file;
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // of any length; those of triangles are not zero
  std::vector<MeshTriangle> triangles;
  std::size_t degenerateTriangles = 0;  // without area, dropped
  std::vector<std::string> warnings;    // each `file:line: message`
  bool operator==(const Mesh&) const = default;
};

// A mesh as one object of the scene. Two of them may share a mesh: each OBJ file is read once.
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
  bool statesRadius = false;  // whether the file does
};

struct Scene {
  std::filesystem::path file;
  Camera camera;
  std::vector<Plane> planes;
  std::vector<Sphere> spheres;
  std::vector<Triangle> triangles;
  std::vector<Mesh> meshes;
  std::vector<MeshObject> meshObjects;
  std::vector<Material> materials;  // one for each object, indexed by `object`
  std::vector<Light> lights;
  std::vector<std::string> warnings;  // each `file:line: message`
};

}  // namespace lavaray
