// What the host and the shaders both know: array layouts, binding numbers, specialization constants, limits.
// This file is compiled as C++ and as GLSL, so each fact is stated once. The layouts hold in both because
// every vec3 is followed by a 4-byte scalar and every struct is a multiple of 16 bytes.
#ifndef LAVARAY_INTERFACE_H
#define LAVARAY_INTERFACE_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lavaray::gpu {
using glm::vec2;
using glm::vec3;
using uint = std::uint32_t;
#define LAVARAY_SIZE(Struct, bytes) static_assert(sizeof(Struct) == (bytes) && (bytes) % 16 == 0)
#else
#define LAVARAY_SIZE(Struct, bytes)
#endif

// Invocations of one work group; each renders a pixel.
const uint kWorkGroupSize = 64u;

// A path from the root to a leaf passes at most this many inner nodes. The builder obeys it, flattening
// checks it, and the traversal's stack has this size.
const uint kMaxBvhDepth = 48u;
const uint kMaxLeafSize = 8u;

// A node reference: an inner node's index, or the leaf's primitives as count << kLeafShift | first.
const uint kLeafShift = 28u;
const uint kMaxReference = (1u << kLeafShift) - 1u;

// llvmpipe ends every loop of an invocation, silently, once the loops of its subgroup have taken 65,535 turns
// in all. A traversal gives up before that is certain, and an invocation handles at most so many lights; what
// is left over goes on in another dispatch (see render.comp).
const uint kMaxTraversalSteps = 60000u;
const uint kMaxLightsPerDispatch = 64u;

// Bindings of descriptor set 0. Nodes, primitives and their planes and normals are read through texel buffer views, four
// 32-bit words a texel (see scene_data.glsl); the others are storage buffers.
const uint kBindingNodes = 0u;
const uint kBindingPrimitives = 1u;
const uint kBindingTrianglePlanes = 2u;
const uint kBindingCornerNormals = 3u;
const uint kBindingPlanes = 4u;
const uint kBindingLights = 5u;
const uint kBindingMaterials = 6u;
const uint kBindingPixels = 7u;
const uint kBindingStatus = 8u;
const uint kBindingCount = 9u;

// Specialization constants: what the scene has, so that the pipeline holds no code for what it has not.
const uint kSpecHasSpheres = 0u;
const uint kSpecHasTriangles = 1u;
const uint kSpecHasCornerNormals = 2u;
const uint kSpecPlaneCount = 3u;
const uint kSpecLightCount = 4u;
const uint kSpecCountRays = 5u;
const uint kSpecCount = 6u;

// An inner node of the BVH with the boxes of its two children.
struct BvhNode {
  vec3 lower0;
  uint child0;  // a node reference
  vec3 upper0;
  uint child1;
  vec3 lower1;
  uint padding0;
  vec3 upper1;
  uint padding1;
};
LAVARAY_SIZE(BvhNode, 64);
const uint kTexelsPerNode = 4u;

const uint kNoCornerNormals = 0xFFFFFFFFu;
const uint kSphere = 0xFFFFFFFEu;

// A triangle's vertices a, b, c, or a sphere's centre a and radius b.x.
struct Primitive {
  vec3 a;
  uint kind;  // kSphere, or a triangle's first corner normal of three, or kNoCornerNormals
  vec3 b;
  uint object;  // index of its material
  vec3 c;
  uint order;  // place in the scene file: of two at the same distance the lower one is seen
};
LAVARAY_SIZE(Primitive, 48);
const uint kTexelsPerPrimitive = 3u;

// A triangle's plane: the points x with dot(normal, x) = distance; the normal has unit length. It is made in
// double precision on the host, where the edges of a sliver or of a huge triangle still have their direction.
struct TrianglePlane {
  vec3 normal;
  float distance;
};
LAVARAY_SIZE(TrianglePlane, 16);

struct CornerNormal {
  vec3 normal;  // as long as in the file, but for a factor that the three of a triangle share
  uint padding;
};
LAVARAY_SIZE(CornerNormal, 16);

// The points x with dot(normal, x) = distance; the normal has unit length.
struct Plane {
  vec3 normal;
  float distance;
  uint object;
  uint padding0;
  uint padding1;
  uint padding2;
};
LAVARAY_SIZE(Plane, 32);

struct Light {
  vec3 position;
  float padding0;
  vec3 ambient;
  float padding1;
  vec3 diffuse;
  float padding2;
  vec3 specular;
  float padding3;
};
LAVARAY_SIZE(Light, 64);

struct Material {
  vec3 ambient;
  float shininess;
  vec3 diffuse;
  float padding0;
  vec3 specular;
  float padding1;
};
LAVARAY_SIZE(Material, 48);

// A pixel while it is rendered: the light it adds up, and the first light that is still missing, or
// kPixelFinished.
struct Pixel {
  vec3 color;
  uint nextLight;
};
LAVARAY_SIZE(Pixel, 16);
const uint kPixelFinished = 0xFFFFFFFFu;

// What a dispatch tells the host.
struct DispatchStatus {
  uint unfinished;  // pixels that need another dispatch
  uint stuck;       // pixels that got no further in this one: another would not help
  uint shadowRays;  // counted where kSpecCountRays is set
  uint padding;
};
LAVARAY_SIZE(DispatchStatus, 16);

// Push constants: a dispatch renders the pixels firstPixel .. firstPixel + pixelCount - 1 of the cropped
// image, counted row by row.
struct DispatchConstants {
  vec2 pixelSize;      // of an output pixel on the camera's image plane
  vec2 halfImage;      // half of the image plane's extent
  float focalLength;   // its distance
  uint cropX;          // left and top of the crop, in pixels
  uint cropY;
  uint cropWidth;
  uint firstPixel;
  uint pixelCount;
  uint resume;         // 1: only pixels that an earlier dispatch left unfinished
  uint rootReference;  // the BVH's root
};
LAVARAY_SIZE(DispatchConstants, 48);

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif

#undef LAVARAY_SIZE
#endif
