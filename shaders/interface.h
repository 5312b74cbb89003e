// What the host and the shaders share: array layouts, binding numbers, specialization constants and limits.
// The file compiles both as C++ and as GLSL, so each fact is stated once. The layouts agree because a 4-byte
// scalar follows every vec3 and the size of every struct is a multiple of 16 bytes.
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
#extension GL_EXT_control_flow_attributes : require
#define LAVARAY_SIZE(Struct, bytes)
#endif

// Invocations of a work group; each handles one work item.
const uint kWorkGroupSize = 64u;

// So many neighbouring invocations take a unit of the picture (see lane.glsl), as wide in pixels as this, and
// as high as each of them traces rays together.
const uint kLanesPerUnit = 8u;
const uint kUnitWidth = 8u;

// The most inner nodes on any path from the root to a leaf. The builder keeps to it, so the traversal's stack
// needs no more entries. Drivers unroll loops of this many iterations, which the stack depends on.
const uint kMaxBvhDepth = 32u;
const uint kMaxLeafSize = 8u;

// A scene with no more primitives than this is a single leaf, spheres first, and its rays test every one of
// them; with more, a traversal is faster (tools/bench_speed/traversal.md).
const uint kMaxFewPrimitives = 8u;

// A node reference is an inner node's index, or a leaf's primitives as count << kLeafShift | first.
const uint kLeafShift = 28u;
const uint kMaxReference = (1u << kLeafShift) - 1u;
// The traversal's stack packs a node's index with 8 other bits.
const uint kMaxNode = (1u << 24u) - 1u;

// Once the loops of a subgroup have run 65,535 iterations in all, llvmpipe silently ends every loop of its
// invocations. A traversal gives up before that is certain to happen, and an invocation traces a limited
// number of shadow rays; another dispatch does the rest (see render.comp).
const uint kMaxTraversalSteps = 60000u;
const uint kMaxShadowRaysPerDispatch = 256u;

// The most samples of its pixel that a work item takes. They are summed in float32, so they are few enough
// for the sum to lose nothing that an image shows; the host adds the sums of work items without rounding.
const uint kMaxSamplesPerItem = 4u;
// The fewest where samples follow a target error. Items that have no more share an invocation's rays (see
// lane_turns.glsl).
const uint kMinSamplesPerItem = 2u;

// The directions in which a sample looks at a spherical light where its colour may exceed 1. The light's term
// is a mean over directions, clamped afterwards. Below 1 that equals the mean over samples of one direction
// each; above 1 each sample needs a mean of its own.
const uint kClampedLightDirections = 16u;

// A mirror ray is dropped when every channel of its weight is below this.
const float kMinReflectance = 1e-4f;

// Bindings of descriptor set 0. Those below kTexelBindings are read through texel buffer views, four 32-bit
// words per texel (see scene_data.glsl); the others are storage buffers.
const uint kTexelBindings = 8u;
const uint kSceneBindings = 7u;  // the first ones, which all shaders share
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

// Specialization constants: what the scene contains, so that the pipeline has no code for anything else.
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
const uint kSpecFewSpheres = 12u;  // these two: of a scene of few primitives
const uint kSpecFewTriangles = 13u;
const uint kSpecHasEntryNodes = 14u;
const uint kSpecAsData = 15u;
const uint kSpecCount = 16u;

// Value of WorkResult::squares where the item needs another dispatch.
const float kSquaresUnfinished = -1.0f;

// Values of DispatchConstants::mode: which work items a dispatch handles. Only a resumable pipeline can leave
// an item half done and resume it.
const uint kModeAll = 0u;
const uint kModeUnfinished = 1u;  // those that an earlier dispatch gave up on, from the start
const uint kModeResumed = 2u;     // those that an earlier dispatch left half done, from where it stopped

// Values of kSpecSampling: where the samples of a pixel come from.
const uint kSamplingCenter = 0u;  // one sample in the pixel's centre
const uint kSamplingSobol = 1u;   // an Owen-scrambled Sobol sequence
const uint kSamplingRandom = 2u;  // independent random numbers

// Values of kSpecView: what a work item sums up for each sample.
const uint kViewColor = 0u;   // the colour, in [0, 1]
const uint kViewNormal = 1u;  // n / 2 + 1/2 for the shading normal n, on the side that is seen
const uint kViewDepth = 2u;   // the distance from the camera, and 1; both 0 where nothing is hit
const uint kViewObject = 3u;  // a colour per object
const uint kViewShadow = 4u;  // the share of the lights that are not blocked
const uint kViewCost = 5u;    // nodes and primitives that the rays are tested against
// With kSpecAsData, kViewNormal is n itself and kViewObject is the object's number, counted from 1.

// An inner node of the BVH, with the boxes of up to four children. On each axis a box's bound b lies at
// origin + b 2^(exponent - 127), which float32 represents exactly, and no box is smaller than its contents.
// The lower bounds of a missing child are above its upper ones, so that no single ray enters it.
//
// Based on: Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
// BVHs", 2017; here with four children per node, stored anywhere.
struct BvhNode {
  vec3 origin;
  uint exponents;  // one byte per axis, x in the lowest
  uvec3 lower;     // for each axis, one byte per child, child 0 in the lowest
  uint padding0;
  uvec3 upper;
  uint padding1;
  uvec4 children;  // node references, by falling area of their boxes; kMissingChild where there is none
};
LAVARAY_SIZE(BvhNode, 64);
const uint kTexelsPerNode = 4u;
const uint kNodeWidth = 4u;

// A leaf of one primitive, which a packet that enters a missing child's box tests in vain.
const uint kMissingChild = 1u << kLeafShift;

// The children of a node that are still to be visited, packed: node << 8 | slots. A slot has two bits, the
// first one the lowest, and above the last one is a 1. 0 is no group.
const uint kGroupNodeShift = 8u;
const uint kNoSlots = 1u;
const uint kBitsPerSlot = 2u;
const uint kRootGroup = kNoSlots << kBitsPerSlot;  // the first child of the node above the root

const uint kEntryNodesPerTexel = 4u;  // packed groups

// Values of Primitive::kind; any other is the index of the first of a triangle's three corner normals.
const uint kPrimitiveFlatTriangle = 0xFFFFFFFFu;  // without corner normals
const uint kPrimitiveSphere = 0xFFFFFFFEu;

// A triangle's vertices a, b, c, or a sphere's centre a and radius b.x.
struct Primitive {
  vec3 a;
  uint kind;  // kPrimitiveSphere, ...
  vec3 b;
  uint object;  // index of its material
  vec3 c;
  uint order;  // in the scene file; of two primitives at the same distance the lower one is seen
};
LAVARAY_SIZE(Primitive, 48);
const uint kTexelsPerPrimitive = 3u;

// A triangle's plane: the points x with dot(normal, x) = distance. The normal has unit length. The host
// computes it in double precision, in which the edges of a sliver or of a huge triangle keep their direction.
struct TrianglePlane {
  vec3 normal;
  float distance;
};
LAVARAY_SIZE(TrianglePlane, 16);

struct CornerNormal {
  vec3 normal;  // as in the file, up to a factor that a triangle's three normals share
  uint padding;
};
LAVARAY_SIZE(CornerNormal, 16);

// The points x with dot(normal, x) = distance. The normal has unit length.
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
  float radius;  // 0 for a point light
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

// `count` samples of a pixel, from number `first` on.
struct WorkItem {
  uint pixel;  // of the traced area, counted row by row
  uint part;   // for the host: which of the pixel's sums they belong to
  uint first;
  uint count;
};
LAVARAY_SIZE(WorkItem, 16);

// The sum of a work item's colours, each clamped to [0, 1], and that of their squares, averaged over the
// channels.
struct WorkResult {
  vec3 sum;
  float squares;  // or kSquaresUnfinished
};
LAVARAY_SIZE(WorkResult, 16);

// How far an unfinished work item has come: its finished samples with their sums and, for the sample under
// way, the path's colour so far, the next bounce, the next step of that bounce (the ambient colour is step 0,
// light i is step i + 1) and the tests so far (see tests.glsl).
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

// Kinds of turns of the loops that search the hierarchy, for the nearest hit or, of shadow rays, for any:
// those of single lanes, and the lanes of the subgroups that make them.
const uint kTurnsForNearestHit = 0u;
const uint kLanesForNearestHit = 1u;
const uint kTurnsForAnyHit = 2u;
const uint kLanesForAnyHit = 3u;
const uint kTurnKinds = 4u;

// What a dispatch tells the host.
struct DispatchStatus {
  uint unfinished;  // work items that need another dispatch
  uint stuck;       // those of them that got no further in this one
  // Counted only where kSpecCountRays is set:
  uint shadowRays;
  uint mirrorRays;
  uint skippedShadowRays;  // whose light would add nothing, or nothing visible
  uint padding0;
  uint padding1;
  uint padding2;
  uint turns[kTurnKinds];          // the lower 32 bits of their numbers
  uint higherOfTurns[kTurnKinds];  // the higher
};
LAVARAY_SIZE(DispatchStatus, 64);

// Push constants.
struct DispatchConstants {
  vec2 pixelSize;     // of an output pixel on the camera's image plane
  vec2 halfImage;     // half the image plane's extent
  float focalLength;  // its distance
  uint areaX;         // left and top of the traced area of the picture, in pixels
  uint areaY;
  uint areaWidth;
  uint itemCount;
  uint mode;  // kModeAll, ...
  uint seed;
  uint maxDepth;    // mirror bounces
  uint filterSize;  // entries of the filter's table; 0 for the box
  uint firstPixel;  // of the items, where they are consecutive pixels (kSamplingCenter)
  // Where the pipeline has entry nodes, the camera rays through a tile of the area, a square with sides of
  // 2^tileShift pixels, start at the tile's own. Tiles are counted row by row, tilesAcross to a row.
  uint tileShift;
  uint tilesAcross;
};
LAVARAY_SIZE(DispatchConstants, 64);

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif

#undef LAVARAY_SIZE
#endif
