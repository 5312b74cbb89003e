#include "bvh/flatten.hpp"
#include "bvh/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <span>

#include <glm/geometric.hpp>

namespace lavaray {
namespace {

const glm::uvec3 kMissing(gpu::kMissingChild);

Scene sceneWithMaterials(std::size_t count) {
  Scene scene;
  scene.materials.resize(count);
  return scene;
}

TEST(Flatten, IsEmptyForAnEmptyScene) {
  const GpuScene flat = flatten(Scene{}, 1);
  EXPECT_TRUE(flat.nodes.empty());
  EXPECT_TRUE(flat.primitives.empty());
  EXPECT_FALSE(flat.hasSpheres || flat.hasTriangles || flat.hasCornerNormals);
}

TEST(Flatten, PutsALeafBelowTheFirstNodeForASinglePrimitive) {
  Scene scene = sceneWithMaterials(1);
  scene.spheres.push_back({{0, 0, -5}, 1.0, 0});
  const GpuScene flat = flatten(scene, 1);
  ASSERT_EQ(flat.nodes.size(), 1U);
  EXPECT_EQ(flat.nodes[0].children, glm::uvec4(1U << gpu::kLeafShift, kMissing));
  EXPECT_EQ(flat.bvhDepth, 0U);
  EXPECT_TRUE(flat.trianglePlanes.empty());
}

// Triangle, sphere, triangle, sphere in the file.
TEST(Flatten, MakesOneLeafOfFewPrimitivesWithTheSpheresFirst) {
  Scene scene = sceneWithMaterials(gpu::kMaxFewPrimitives + 1);
  const glm::dvec3 away(0, 0, -5);
  scene.triangles = {{{{{0, 0, -3}, {1, 0, -3}, {0, 1, -3}}}, 0},
                     {{{{0, 0, -4}, {0, 1, -4}, {0, 0, -9}}}, 2}};
  scene.spheres = {{away, 1.0, 1}, {away, 2.0, 3}};
  GpuScene flat = flatten(scene, 1);
  EXPECT_TRUE(flat.hasFewPrimitives);
  ASSERT_EQ(flat.nodes.size(), 1U);
  EXPECT_EQ(flat.nodes[0].children, glm::uvec4(4U << gpu::kLeafShift, kMissing));
  std::vector<std::uint32_t> orders;
  for (const gpu::Primitive& primitive : flat.primitives) orders.push_back(primitive.order);
  EXPECT_EQ(orders, (std::vector<std::uint32_t>{1, 3, 0, 2}));
  EXPECT_EQ(std::abs(flat.trianglePlanes[2].normal.z), 1.0F);
  EXPECT_EQ(std::abs(flat.trianglePlanes[3].normal.x), 1.0F);

  for (std::uint32_t object = 4; scene.spheres.size() < gpu::kMaxFewPrimitives - 2; ++object)
    scene.spheres.push_back({away, 1.0, object});
  EXPECT_TRUE(flatten(scene, 1).hasFewPrimitives);
  scene.spheres.push_back({away, 1.0, gpu::kMaxFewPrimitives});
  flat = flatten(scene, 1);
  EXPECT_FALSE(flat.hasFewPrimitives);
  EXPECT_EQ(flat.bvhQuality.leafSize * static_cast<double>(flat.bvhQuality.leaves),
            gpu::kMaxFewPrimitives + 1.0);
}

// Camera and scene are 1e8 away from the origin, where a float32 has a spacing of 8.
TEST(Flatten, SubtractsTheCameraInDoublePrecision) {
  const glm::dvec3 far(1e8, -1e8, 1e8);
  Scene scene = sceneWithMaterials(2);
  scene.camera.position = far;
  scene.spheres.push_back({far + glm::dvec3(0.125, 0.25, -5.5), 1.0, 0});
  scene.planes.push_back({{0, 2, 0}, far - glm::dvec3(0, 1.5, 0), 1});
  scene.lights.push_back({far + glm::dvec3(1, 2, 3)});
  const GpuScene flat = flatten(scene, 1);
  EXPECT_EQ(flat.primitives[0].a, glm::vec3(0.125F, 0.25F, -5.5F));
  EXPECT_EQ(flat.planes[0].normal, glm::vec3(0, 1, 0));
  EXPECT_EQ(flat.planes[0].distance, -1.5F);
  EXPECT_EQ(flat.lights[0].position, glm::vec3(1, 2, 3));
}

TEST(Flatten, NumbersPrimitivesInTheOrderOfTheFile) {
  Scene scene = sceneWithMaterials(4);
  scene.meshes.resize(1);
  scene.meshes[0].positions = {{0, 0, -9}, {1, 0, -9}, {0, 1, -9}, {1, 1, -9}};
  scene.meshes[0].triangles = {{{0, 1, 2}}, {{1, 3, 2}}};
  scene.spheres = {{{0, 0, -5}, 1.0, 0}, {{9, 0, -5}, 1.0, 3}};
  scene.meshObjects = {{0, 1}};
  scene.triangles = {{{{{0, 0, -3}, {1, 0, -3}, {0, 1, -3}}}, 2}};
  const GpuScene flat = flatten(scene, 1);
  std::vector<std::uint32_t> objectOfOrder(5);
  for (const gpu::Primitive& primitive : flat.primitives)
    objectOfOrder.at(primitive.order) = primitive.object;
  EXPECT_EQ(objectOfOrder, (std::vector<std::uint32_t>{0, 1, 1, 2, 3}));
  EXPECT_TRUE(flat.hasSpheres && flat.hasTriangles);
  EXPECT_EQ(flat.trianglePlanes.size(), flat.primitives.size());
}

template <typename Elements>
bool sameBytes(const Elements& a, const Elements& b) {
  return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

// With other lights, materials, planes and another lens the hierarchy stays, and all else is as if flattened
// anew.
TEST(Flatten, TakesUpAnotherShadingOfTheSameGeometry) {
  Scene scene = sceneWithMaterials(3);
  scene.spheres = {{{0, 0, -5}, 1.0, 0}, {{9, 0, -5}, 1.0, 1}};
  scene.planes = {{{0, 1, 0}, {0, -2, 0}, 2}};
  scene.lights = {{.position = {1, 2, 3}, .radius = 0.5}};
  scene.materials[1].reflectance = glm::dvec3(0.5);
  GpuScene flat = flatten(scene, 1);

  Scene other = scene;
  other.lights = {{.position = {3, 2, 1}}, {.position = {4, 5, 6}}};
  other.materials[1].reflectance = glm::dvec3(0.0);
  other.materials.resize(4);
  other.planes.push_back({{1, 0, 0}, {-4, 0, 0}, 3});
  other.camera.focalLength = 50.0;
  other.camera.aspect = 1.5;
  EXPECT_TRUE(sameGeometry(scene, other));
  flattenShading(other, flat);
  const GpuScene anew = flatten(other, 1);
  EXPECT_TRUE(sameBytes(flat.nodes, anew.nodes));
  EXPECT_TRUE(sameBytes(flat.primitives, anew.primitives));
  EXPECT_TRUE(sameBytes(flat.planes, anew.planes));
  EXPECT_TRUE(sameBytes(flat.lights, anew.lights));
  EXPECT_TRUE(sameBytes(flat.materials, anew.materials));
  EXPECT_EQ(flat.imagePlane, anew.imagePlane);
  EXPECT_EQ(flat.imagePlane, (ImagePlane{{85.0, 57.0}, 50.0}));
  EXPECT_FALSE(flat.hasMirrors);
  EXPECT_FALSE(flat.hasSphericalLights);

  other.camera.position.x += 1.0;
  EXPECT_FALSE(sameGeometry(scene, other));
  other = scene;
  other.spheres[1].radius *= 2.0;
  EXPECT_FALSE(sameGeometry(scene, other));
  other = scene;
  other.spheres[1].object = 2;
  EXPECT_FALSE(sameGeometry(scene, other));
}

// A sphere, a mesh with normals at some of its triangles, a triangle, spheres, and the mesh once more.
Scene sceneOfAllKinds() {
  std::mt19937 random(7);
  const auto uniform = [&] { return std::uniform_real_distribution(-10.0, 10.0)(random); };
  const auto point = [&] { return glm::dvec3(uniform(), uniform(), uniform()); };
  Scene scene = sceneWithMaterials(20004);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    const glm::dvec3 first = point();
    mesh.positions.insert(mesh.positions.end(), {first, first + 0.01 * point(), first + 0.01 * point()});
    mesh.normals.push_back(point());
    mesh.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
    if (i % 3 != 0) mesh.triangles.back().normals = {i, i / 2, i / 3};
  }
  scene.meshes = {mesh};
  scene.meshObjects = {{0, 1}, {0, 20003}};
  scene.triangles = {{{{{0, 0, -3}, {1, 0, -3}, {0, 1, -3}}}, 2}};
  scene.spheres = {{point(), 0.5, 0}};
  for (std::uint32_t object = 3; object < 20003; ++object) scene.spheres.push_back({point(), 0.01, object});
  return scene;
}

TEST(Flatten, MakesTheSameArraysWhateverTheThreadCount) {
  const Scene scene = sceneOfAllKinds();
  const GpuScene one = flatten(scene, 1);
  for (const unsigned threads : {2U, 3U, 16U}) {
    const GpuScene other = flatten(scene, threads);
    EXPECT_TRUE(sameBytes(one.nodes, other.nodes)) << threads;
    EXPECT_TRUE(sameBytes(one.primitives, other.primitives)) << threads;
    EXPECT_TRUE(sameBytes(one.trianglePlanes, other.trianglePlanes)) << threads;
    EXPECT_TRUE(sameBytes(one.cornerNormals, other.cornerNormals)) << threads;
    EXPECT_EQ(one.bvhQuality.sahCost, other.bvhQuality.sahCost) << threads;
  }
}

TEST(Flatten, GivesEachTriangleItsOwnVerticesPlaneAndCornerNormals) {
  const Scene scene = sceneOfAllKinds();
  const Mesh& mesh = scene.meshes[0];
  const GpuScene flat = flatten(scene, 2);
  ASSERT_EQ(flat.primitives.size(), 120002U);
  std::vector<int> users(flat.cornerNormals.size(), 0);
  for (std::size_t place = 0; place < flat.primitives.size(); ++place) {
    const gpu::Primitive& shape = flat.primitives[place];
    if (shape.object != 1 && shape.object != 20003) {
      EXPECT_EQ(shape.order, shape.object == 0 ? 0 : shape.object + 49999);
      continue;
    }
    const std::uint32_t i = shape.order - (shape.object == 1 ? 1 : 70002);
    ASSERT_LT(i, 50000U);
    EXPECT_EQ(shape.a, glm::vec3(mesh.positions[3 * i]));
    EXPECT_EQ(shape.c, glm::vec3(mesh.positions[3 * i + 2]));
    const gpu::TrianglePlane& plane = flat.trianglePlanes[place];
    EXPECT_NEAR(glm::dot(plane.normal, shape.b), plane.distance, 1e-5);
    if (i % 3 == 0) {
      EXPECT_EQ(shape.kind, gpu::kPrimitiveFlatTriangle);
      continue;
    }
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 normal = mesh.normals[i / (corner + 1)];
      ++users.at(shape.kind + corner);
      EXPECT_NEAR(glm::dot(glm::normalize(normal),
                           glm::normalize(glm::dvec3(flat.cornerNormals[shape.kind + corner].normal))),
                  1.0, 1e-6);
    }
  }
  EXPECT_EQ(users, std::vector<int>(users.size(), 1));
}

TEST(Flatten, KeepsTheNormalOfASliverAndOfAHugeTriangle) {
  Scene scene = sceneWithMaterials(2);
  scene.triangles.push_back({{{{0, 0, -1}, {1, 0, -1}, {0.5, 1e-12, -1}}}, 0});
  scene.triangles.push_back({{{{-1e12, -3, 1e12}, {1e12, -3, 1e12}, {0, -3, -1e12}}}, 1});
  const GpuScene flat = flatten(scene, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::vec3 normal = flat.trianglePlanes[i].normal;
    EXPECT_EQ(normal, flat.primitives[i].object == 0 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
    EXPECT_EQ(flat.trianglePlanes[i].distance, flat.primitives[i].object == 0 ? -1.0F : -3.0F);
  }
}

// A tiny scene is enlarged by a power of two, lights and planes with it, and a larger one stays as it is.
TEST(Flatten, EnlargesATinyScene) {
  Scene scene = sceneWithMaterials(3);
  scene.camera.position = {0x1p-90, 0, 0};
  scene.spheres = {{{0, 0, -0x1.8p-80}, 0x1p-90, 0}};
  scene.triangles = {{{{{0, 0, -0x1p-81}, {0x1p-90, 0, -0x1p-81}, {0, 0x1p-90, -0x1p-81}}}, 1}};
  scene.planes = {{{0, 2, 0}, {1e3, -0x1p-82, 0}, 2}};  // its point is no coordinate of what is seen
  scene.lights = {{.position = {0, 0x1p-85, 0}, .radius = 0x1p-86}};
  EXPECT_EQ(frameOf(scene), (Frame{{0x1p-90, 0, 0}, 0x1p80}));
  const GpuScene flat = flatten(scene, 1);
  const gpu::Primitive& sphere = flat.primitives[0];
  EXPECT_EQ(sphere.a, glm::vec3(-0x1p-10F, 0.0F, -1.5F));
  EXPECT_EQ(sphere.b.x, 0x1p-10F);
  EXPECT_EQ(flat.primitives[1].b, glm::vec3(0.0F, 0.0F, -0.5F));
  EXPECT_EQ(flat.trianglePlanes[1].distance, -0.5F);
  EXPECT_EQ(flat.planes[0].distance, -0.25F);
  EXPECT_EQ(flat.lights[0].position, glm::vec3(-0x1p-10F, 0x1p-5F, 0.0F));
  EXPECT_EQ(flat.lights[0].radius, 0x1p-6F);

  Scene other = scene;
  other.lights[0].position.y = 1e6;         // a sun
  EXPECT_EQ(frameOf(other).scale, 0x1p31);  // which brings it to 2^50
  EXPECT_FALSE(sameGeometry(scene, other));
  other.lights[0].position.y = 0x1p60;
  EXPECT_EQ(frameOf(other).scale, 1.0);
}

TEST(Flatten, HoldsNoDenormalNumbers) {
  Scene scene = sceneWithMaterials(2);
  scene.spheres = {{{1e-39, -1e-40, -5}, 1e-41, 0}};
  scene.lights = {{.position = {1e-39, 2, 3}, .diffuse = glm::dvec3(1e-42), .radius = 1e-44}};
  scene.materials[0].specular =
      glm::dvec3(0x1.fffffep-127, 0x1p-126, 1.0);  // the first one rounds to the second
  scene.materials[1].specular = glm::dvec3(0x1p-127);
  const GpuScene flat = flatten(scene, 1);
  EXPECT_EQ(flat.primitives[0].a, glm::vec3(0, 0, -5));
  EXPECT_EQ(flat.primitives[0].b.x, 0.0F);
  EXPECT_EQ(flat.lights[0].position, glm::vec3(0, 2, 3));
  EXPECT_EQ(flat.lights[0].diffuse, glm::vec3(0.0F));
  EXPECT_EQ(flat.lights[0].radius, 0.0F);
  EXPECT_EQ(flat.materials[0].specular, glm::vec3(0x1p-126F, 0x1p-126F, 1.0F));
  EXPECT_EQ(flat.materials[1].specular, glm::vec3(0.0F));
}

TEST(Flatten, DropsAMillionDuplicatesButKeepsWhatAPixelCanShow) {
  Scene scene = sceneWithMaterials(1000000);
  const Triangle triangle{{{{0, 0, -3}, {1, 0, -3}, {0, 1, -3}}}, 0};
  for (std::uint32_t i = 0; i < 500000; ++i) {
    scene.triangles.push_back(triangle);
    std::rotate(scene.triangles.back().vertices.begin(), scene.triangles.back().vertices.begin() + i % 3,
                scene.triangles.back().vertices.end());
    scene.triangles.back().object = i;
  }
  for (std::uint32_t i = 0; i < 500000; ++i) scene.spheres.push_back({{5, 5, -5}, 1.0, 500000 + i});
  const GpuScene flat = flatten(scene, 2);
  EXPECT_EQ(flat.droppedDuplicates, 999997U);
  std::set<std::uint32_t> objects;
  for (const gpu::Primitive& primitive : flat.primitives) objects.insert(primitive.object);
  EXPECT_EQ(objects, (std::set<std::uint32_t>{0, 500000, 500001}));
}

}  // namespace
}  // namespace lavaray
