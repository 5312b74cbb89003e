// What the host and the shaders both know: array layouts, binding numbers, specialization constants, limits.
// This file is compiled as C++ and as GLSL, so each fact is stated once. The layouts hold in both because
// every vec3 is followed by a 4-byte scalar and every struct is a multiple of 16 bytes.
#ifndef LAVARAY_INTERFACE_H
#define LAVARAY_INTERFACE_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lavaray::gpu {
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using uint = std::uint32_t;
#define LAVARAY_SIZE(Struct, bytes) static_assert(sizeof(Struct) == (bytes) && (bytes) % 16 == 0)
#else
#define LAVARAY_SIZE(Struct, bytes)
#endif

// Invocations of one work group; each does a work item.
const uint kWorkGroupSize = 64u;

// A path from the root to a leaf passes at most this many inner nodes. The builder obeys it, and the
// traversal's stack needs no more entries. Drivers unroll loops of that many turns, which the stack depends
// on.
const uint kMaxBvhDepth = 32u;
const uint kMaxLeafSize = 8u;

// A scene of at most so many primitives is one leaf, spheres first, and its rays test each of them: beyond
// that a traversal is faster (tools/bench_speed/traversal.md).
const uint kMaxFewPrimitives = 8u;

// A node reference: an inner node's index, or the leaf's primitives as count << kLeafShift | first.
const uint kLeafShift = 28u;
const uint kMaxReference = (1u << kLeafShift) - 1u;
// The traversal's stack holds a node's index beside 8 other bits.
const uint kMaxNode = (1u << 24u) - 1u;

// llvmpipe ends every loop of an invocation, silently, once the loops of its subgroup have taken 65,535 turns
// in all. A traversal gives up before that is certain, and an invocation traces at most so many shadow rays;
// what is left over goes on in another dispatch (see render.comp).
const uint kMaxTraversalSteps = 60000u;
const uint kMaxShadowRaysPerDispatch = 256u;

// Samples of one pixel that a work item takes at most. They are summed in float32, so few enough that the sum
// loses nothing that an image shows; the host adds the sums of work items without rounding.
const uint kMaxSamplesPerItem = 4u;

// Directions in which a sample looks at a spherical light where its colour may exceed 1. The light's term is
// a mean over directions that is clamped afterwards: below 1 that is the mean over samples of one direction
// each, above it a sample needs a mean of its own.
const uint kClampedLightDirections = 16u;

// A mirror ray is dropped when every channel of its weight is below.
const float kMinReflectance = 1e-4f;

// Bindings of descriptor set 0. Those below kTexelBindings are read through texel buffer views, four 32-bit
// words a texel (see scene_data.glsl); the others are storage buffers.
const uint kTexelBindings = 8u;
const uint kSceneBindings = 7u;  // the first ones, the same for all shaders
const uint kBindingNodes = 0u;
const uint kBindingPrimitives = 1u;
const uint kBindingTrianglePlanes = 2u;
const uint kBindingCornerNormals = 3u;
const uint kBindingPlanes = 4u;
const uint kBindingLights = 5u;
const uint kBindingMaterials = 6u;
const uint kBindingEntryNodes = 7u;
const uint kBindingFilter = 8u;
const uint kBindingWork = 9u;
const uint kBindingResults = 10u;
const uint kBindingStates = 11u;
const uint kBindingStatus = 12u;
const uint kBindingCount = 13u;

// Specialization constants: what the scene has, so that the pipeline holds no code for what it has not.
const uint kSpecHasSpheres = 0u;
const uint kSpecHasTriangles = 1u;
const uint kSpecHasCornerNormals = 2u;
const uint kSpecPlaneCount = 3u;
const uint kSpecLightCount = 4u;
const uint kSpecHasMirrors = 5u;
const uint kSpecHasSphericalLights = 6u;
const uint kSpecSampling = 7u;
const uint kSpecResumable = 8u;
const uint kSpecCountRays = 9u;
const uint kSpecStackSize = 10u;
const uint kSpecView = 11u;
const uint kSpecFewSpheres = 12u;  // of a scene of few primitives, as the next one
const uint kSpecFewTriangles = 13u;
const uint kSpecHasEntryNodes = 14u;
const uint kSpecAsData = 15u;
const uint kSpecCount = 16u;

// A WorkResult's squares where there is none yet.
const float kSquaresUnfinished = -1.0f;

// Values of DispatchConstants::mode: which work items a dispatch does. Only a resumable pipeline can leave an
// item half done and go on with it.
const uint kModeAll = 0u;
const uint kModeUnfinished = 1u;  // those that an earlier dispatch gave up, from the start
const uint kModeResumed = 2u;     // those that an earlier dispatch left half done, from there

// Values of kSpecSampling: where the samples of a pixel come from.
const uint kSamplingCenter = 0u;  // one sample in the pixel's centre
const uint kSamplingSobol = 1u;   // an Owen-scrambled Sobol sequence
const uint kSamplingRandom = 2u;  // independent random numbers

// Values of kSpecView: what a work item sums up for each sample.
const uint kViewColor = 0u;   // the colour, in [0, 1]
const uint kViewNormal = 1u;  // n / 2 + 1/2 for the shading normal n, on the side that is seen
const uint kViewDepth = 2u;   // the distance from the camera, and 1; both 0 where nothing is hit
const uint kViewObject = 3u;  // a colour for each object
const uint kViewShadow = 4u;  // share of the lights that are not blocked
const uint kViewCost = 5u;    // nodes and primitives that the rays are tested against
// Where kSpecAsData is set, kViewNormal is n, and kViewObject the object's number, counted from 1.

// An inner node of the BVH with the boxes of up to four children. On each axis the bound b of a box lies at
// origin + b 2^(exponent - 127), a number that float32 holds exactly, and no box is smaller than what is in
// it. A child that is not there has lower bounds above its upper ones. Based on: Ylitie, Karras and Laine,
// "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017, four wide and with
// children that lie anywhere.
struct BvhNode {
  vec3 origin;
  uint exponents;  // a byte an axis, that of x the lowest
  uvec3 lower;     // for each axis: a byte a child, that of child 0 the lowest
  uint padding0;
  uvec3 upper;
  uint padding1;
  uvec4 children;  // node references
};
LAVARAY_SIZE(BvhNode, 64);
const uint kTexelsPerNode = 4u;
const uint kNodeWidth = 4u;

// Children of a node that are still to be visited, packed: node << 8 | slots << 2 | count, of slots of two
// bits each the first one lowest; 0 is none.
const uint kGroupNodeShift = 8u;
const uint kGroupSlotsShift = 2u;
const uint kRootGroup = 1u;  // the only child of the node above the root

const uint kEntryNodesPerTexel = 4u;  // packed groups

// Values of Primitive::kind; any other is a triangle's first corner normal of three.
const uint kPrimitiveFlatTriangle = 0xFFFFFFFFu;  // one that has its own normal only
const uint kPrimitiveSphere = 0xFFFFFFFEu;

// A triangle's vertices a, b, c, or a sphere's centre a and radius b.x.
struct Primitive {
  vec3 a;
  uint kind;  // kPrimitiveSphere, ...
  vec3 b;
  uint object;  // index of its material
  vec3 c;
  uint order;  // in the scene file: of two at the same distance the lower one is seen
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
const uint kTexelsPerPlane = 2u;

struct Light {
  vec3 position;
  float radius;  // 0 is a point light
  vec3 ambient;
  float padding1;
  vec3 diffuse;
  float padding2;
  vec3 specular;
  float padding3;
};
LAVARAY_SIZE(Light, 64);
const uint kTexelsPerLight = 4u;

struct Material {
  vec3 ambient;
  float shininess;
  vec3 diffuse;
  float padding0;
  vec3 specular;
  float padding1;
  vec3 reflectance;
  float padding2;
};
LAVARAY_SIZE(Material, 64);
const uint kTexelsPerMaterial = 4u;

// Some samples of one pixel: `count` of them from number `first` on.
struct WorkItem {
  uint pixel;  // of the cropped image, counted row by row
  uint part;   // of the pixel's sums that they belong to, for the host
  uint first;
  uint count;
};
LAVARAY_SIZE(WorkItem, 16);

// The sum of a work item's colours, each clamped to [0, 1], and of their squares in the mean over the
// channels.
struct WorkResult {
  vec3 sum;
  float squares;  // kSquaresUnfinished: the item needs another dispatch
};
LAVARAY_SIZE(WorkResult, 16);

// How far an unfinished work item has come: its finished samples with their sums, and of the one under way
// the path's colour so far, its next bounce and there the next step (0 is the ambient colour, i + 1 is light
// i), and its tests so far (see tests.glsl).
struct WorkState {
  vec3 sum;
  uint taken;  // samples
  vec3 color;
  uint bounce;
  uint step;
  float squares;
  uint tests;
  uint padding0;
};
LAVARAY_SIZE(WorkState, 48);

// What a dispatch tells the host.
struct DispatchStatus {
  uint unfinished;  // work items that need another dispatch
  uint stuck;       // of them, those that got no further in this one
  // These are counted where kSpecCountRays is set.
  uint shadowRays;
  uint mirrorRays;
  uint skippedShadowRays;  // their light would add nothing, or nothing that shows
  uint padding0;
  uint padding1;
  uint padding2;
};
LAVARAY_SIZE(DispatchStatus, 32);

// Push constants.
struct DispatchConstants {
  vec2 pixelSize;     // of an output pixel on the camera's image plane
  vec2 halfImage;     // half of the image plane's extent
  float focalLength;  // its distance
  uint cropX;         // left and top of the crop, in pixels
  uint cropY;
  uint cropWidth;
  uint itemCount;
  uint mode;  // kModeAll, ...
  uint seed;
  uint maxDepth;    // mirror bounces
  uint filterSize;  // entries of the filter's table; 0 is the box
  uint firstPixel;  // of the items, where they are consecutive pixels (kSamplingCenter)
  // Camera rays through a square of 2^tileShift pixels of the crop start at its entry node, where the
  // pipeline has entry nodes: tiles are counted row by row, tilesAcross in one.
  uint tileShift;
  uint tilesAcross;
};
LAVARAY_SIZE(DispatchConstants, 64);

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif

#undef LAVARAY_SIZE
#endif
