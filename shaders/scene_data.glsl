// The scene's arrays and the functions that read them.
//
// They are read through texel buffer views as far as these reach: on lavapipe a texel fetch is a few wide
// loads, where a storage buffer load is a branch for every component of every lane. A device need not allow
// more than 65,536 texels in a view, so another module reads the same words from storage buffers (see
// scene_buffers.hpp). Texels are integers, so that no driver flushes an index to zero as a denormal float.
#ifndef SCENE_DATA_GLSL
#define SCENE_DATA_GLSL

#include "interface.h"

// One of the modules that are compiled from this has no hierarchy. Drivers take long to remove what a
// specialization constant makes dead, so the choice is a compile-time constant.
#ifdef LAVARAY_FEW_PRIMITIVES
const bool kFewPrimitives = true;
#else
const bool kFewPrimitives = false;
#endif

// The rays that an invocation traces together. Their loops are unrolled when the module is made: with arrays
// and loops of a size that only the driver knows, it compiles for much longer.
#ifndef LAVARAY_RAYS_PER_LANE
#define LAVARAY_RAYS_PER_LANE 1
#endif
const uint kRaysPerLane = LAVARAY_RAYS_PER_LANE;

layout(constant_id = kSpecHasSpheres) const bool kHasSpheres = true;
layout(constant_id = kSpecHasTriangles) const bool kHasTriangles = true;
layout(constant_id = kSpecHasCornerNormals) const bool kHasCornerNormals = true;
layout(constant_id = kSpecPlaneCount) const uint kPlaneCount = 0u;
layout(constant_id = kSpecLightCount) const uint kLightCount = 0u;
layout(constant_id = kSpecHasMirrors) const bool kHasMirrors = false;
layout(constant_id = kSpecHasSphericalLights) const bool kHasSphericalLights = false;
layout(constant_id = kSpecFewSpheres) const uint kFewSpheres = 0u;
layout(constant_id = kSpecFewTriangles) const uint kFewTriangles = 0u;
layout(constant_id = kSpecHasEntryNodes) const bool kHasEntryNodes = false;
layout(constant_id = kSpecStackSize) const uint kStackSize = kMaxBvhDepth;

#ifndef LAVARAY_SCENE_IN_STORAGE
layout(set = 0, binding = kBindingNodes) uniform utextureBuffer nodeTexels;
layout(set = 0, binding = kBindingPrimitives) uniform utextureBuffer primitiveTexels;
layout(set = 0, binding = kBindingTrianglePlanes) uniform utextureBuffer trianglePlaneTexels;
layout(set = 0, binding = kBindingCornerNormals) uniform utextureBuffer cornerNormalTexels;
layout(set = 0, binding = kBindingPlanes) uniform utextureBuffer planeTexels;
layout(set = 0, binding = kBindingLights) uniform utextureBuffer lightTexels;
layout(set = 0, binding = kBindingMaterials) uniform utextureBuffer materialTexels;
layout(set = 0, binding = kBindingEntryNodes) uniform utextureBuffer entryNodeTexels;
#define TEXEL(texels, index) texelFetch(texels, int(index))
#else
layout(std430, set = 0, binding = kBindingNodes) readonly buffer Nodes {
  uvec4 nodeTexels[];
};
layout(std430, set = 0, binding = kBindingPrimitives) readonly buffer Primitives {
  uvec4 primitiveTexels[];
};
layout(std430, set = 0, binding = kBindingTrianglePlanes) readonly buffer TrianglePlanes {
  uvec4 trianglePlaneTexels[];
};
layout(std430, set = 0, binding = kBindingCornerNormals) readonly buffer CornerNormals {
  uvec4 cornerNormalTexels[];
};
layout(std430, set = 0, binding = kBindingPlanes) readonly buffer Planes {
  uvec4 planeTexels[];
};
layout(std430, set = 0, binding = kBindingLights) readonly buffer Lights {
  uvec4 lightTexels[];
};
layout(std430, set = 0, binding = kBindingMaterials) readonly buffer Materials {
  uvec4 materialTexels[];
};
layout(std430, set = 0, binding = kBindingEntryNodes) readonly buffer EntryNodes {
  uvec4 entryNodeTexels[];
};
#define TEXEL(texels, index) texels[index]
#endif

uvec4 fetchNodeTexel(uint index, uint texel) {
  return TEXEL(nodeTexels, index * kTexelsPerNode + texel);
}

uvec4 fetchChildren(uint index) {
  return fetchNodeTexel(index, 3u);
}

BvhNode fetchNode(uint index) {
  const uvec4 t0 = fetchNodeTexel(index, 0u);
  const uvec4 t1 = fetchNodeTexel(index, 1u);
  const uvec4 t2 = fetchNodeTexel(index, 2u);
  return BvhNode(uintBitsToFloat(t0.xyz), t0.w, t1.xyz, t1.w, t2.xyz, t2.w, fetchChildren(index));
}

Primitive fetchPrimitive(uint index) {
  const uint texel = index * kTexelsPerPrimitive;
  const uvec4 t0 = TEXEL(primitiveTexels, texel);
  const uvec4 t1 = TEXEL(primitiveTexels, texel + 1u);
  const uvec4 t2 = TEXEL(primitiveTexels, texel + 2u);
  return Primitive(uintBitsToFloat(t0.xyz), t0.w, uintBitsToFloat(t1.xyz), t1.w, uintBitsToFloat(t2.xyz),
                   t2.w);
}

// The object of a primitive.
uint fetchObject(uint index) {
  return TEXEL(primitiveTexels, index * kTexelsPerPrimitive + 1u).w;
}

TrianglePlane fetchTrianglePlane(uint index) {
  const vec4 t = uintBitsToFloat(TEXEL(trianglePlaneTexels, index));
  return TrianglePlane(t.xyz, t.w);
}

CornerNormal fetchCornerNormal(uint index) {
  const uvec4 t = TEXEL(cornerNormalTexels, index);
  return CornerNormal(uintBitsToFloat(t.xyz), t.w);
}

Plane fetchPlane(uint index) {
  const uint texel = index * kTexelsPerPlane;
  const vec4 t0 = uintBitsToFloat(TEXEL(planeTexels, texel));
  const uvec4 t1 = TEXEL(planeTexels, texel + 1u);
  return Plane(t0.xyz, t0.w, t1.x, t1.y, t1.z, t1.w);
}

// The packed group at which the tile's camera rays enter the hierarchy.
uint fetchEntryNode(uint tile) {
  const uvec4 t = TEXEL(entryNodeTexels, tile / kEntryNodesPerTexel);
  const uvec2 pair = (tile & 2u) == 0u ? t.xy : t.zw;
  return (tile & 1u) == 0u ? pair.x : pair.y;
}

Light fetchLight(uint index) {
  const uint texel = index * kTexelsPerLight;
  const vec4 t0 = uintBitsToFloat(TEXEL(lightTexels, texel));
  const vec4 t1 = uintBitsToFloat(TEXEL(lightTexels, texel + 1u));
  const vec4 t2 = uintBitsToFloat(TEXEL(lightTexels, texel + 2u));
  const vec4 t3 = uintBitsToFloat(TEXEL(lightTexels, texel + 3u));
  return Light(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w);
}

Material fetchMaterial(uint index) {
  const uint texel = index * kTexelsPerMaterial;
  const vec4 t0 = uintBitsToFloat(TEXEL(materialTexels, texel));
  const vec4 t1 = uintBitsToFloat(TEXEL(materialTexels, texel + 1u));
  const vec4 t2 = uintBitsToFloat(TEXEL(materialTexels, texel + 2u));
  const vec4 t3 = uintBitsToFloat(TEXEL(materialTexels, texel + 3u));
  return Material(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w);
}

#endif
