// The scene's arrays, and the functions that read them.
//
// All are read through texel buffer views: on lavapipe a texel fetch is a few wide loads where a storage buffer load is
// a branch for every component of every lane. The texels are integers, so that no driver takes an index for a denormal
// float and flushes it.
#ifndef SCENE_DATA_GLSL
#define SCENE_DATA_GLSL

#include "interface.h"

// Of the two pipelines that this is compiled to, one knows no hierarchy. Drivers take long to remove what a
// specialization constant makes dead, so this is a constant of the compiler's.
#ifdef LAVARAY_FEW_PRIMITIVES
const bool kFewPrimitives = true;
#else
const bool kFewPrimitives = false;
#endif

layout(constant_id = kSpecHasSpheres) const bool kHasSpheres = true;
layout(constant_id = kSpecHasTriangles) const bool kHasTriangles = true;
layout(constant_id = kSpecHasCornerNormals) const bool kHasCornerNormals = true;
layout(constant_id = kSpecPlaneCount) const uint kPlaneCount = 0u;
layout(constant_id = kSpecLightCount) const uint kLightCount = 0u;
layout(constant_id = kSpecHasMirrors) const bool kHasMirrors = false;
layout(constant_id = kSpecHasSphericalLights) const bool kHasSphericalLights = false;
layout(constant_id = kSpecFewSpheres) const uint kFewSpheres = 0u;
layout(constant_id = kSpecFewTriangles) const uint kFewTriangles = 0u;
layout(constant_id = kSpecHasTileStarts) const bool kHasTileStarts = false;
layout(constant_id = kSpecStackSize) const uint kStackSize = kMaxBvhDepth;

layout(set = 0, binding = kBindingNodes) uniform utextureBuffer nodeTexels;
layout(set = 0, binding = kBindingPrimitives) uniform utextureBuffer primitiveTexels;
layout(set = 0, binding = kBindingTrianglePlanes) uniform utextureBuffer trianglePlaneTexels;
layout(set = 0, binding = kBindingCornerNormals) uniform utextureBuffer cornerNormalTexels;
layout(set = 0, binding = kBindingPlanes) uniform utextureBuffer planeTexels;
layout(set = 0, binding = kBindingLights) uniform utextureBuffer lightTexels;
layout(set = 0, binding = kBindingMaterials) uniform utextureBuffer materialTexels;
layout(set = 0, binding = kBindingTileStarts) uniform utextureBuffer tileStartTexels;

uvec4 fetchNodeTexel(uint index, uint texel) {
  return texelFetch(nodeTexels, int(index * kTexelsPerNode + texel));
}

uvec4 fetchChildren(uint index) { return fetchNodeTexel(index, 3u); }

BvhNode fetchNode(uint index) {
  const uvec4 t0 = fetchNodeTexel(index, 0u);
  const uvec4 t1 = fetchNodeTexel(index, 1u);
  const uvec4 t2 = fetchNodeTexel(index, 2u);
  return BvhNode(uintBitsToFloat(t0.xyz), t0.w, t1.xyz, t1.w, t2.xyz, t2.w, fetchChildren(index));
}

Primitive fetchPrimitive(uint index) {
  const int texel = int(index * kTexelsPerPrimitive);
  const uvec4 t0 = texelFetch(primitiveTexels, texel);
  const uvec4 t1 = texelFetch(primitiveTexels, texel + 1);
  const uvec4 t2 = texelFetch(primitiveTexels, texel + 2);
  return Primitive(uintBitsToFloat(t0.xyz), t0.w, uintBitsToFloat(t1.xyz), t1.w, uintBitsToFloat(t2.xyz), t2.w);
}

TrianglePlane fetchTrianglePlane(uint index) {
  const vec4 t = uintBitsToFloat(texelFetch(trianglePlaneTexels, int(index)));
  return TrianglePlane(t.xyz, t.w);
}

CornerNormal fetchCornerNormal(uint index) {
  const uvec4 t = texelFetch(cornerNormalTexels, int(index));
  return CornerNormal(uintBitsToFloat(t.xyz), t.w);
}

Plane fetchPlane(uint index) {
  const int texel = int(index * kTexelsPerPlane);
  const vec4 t0 = uintBitsToFloat(texelFetch(planeTexels, texel));
  const uvec4 t1 = texelFetch(planeTexels, texel + 1);
  return Plane(t0.xyz, t0.w, t1.x, t1.y, t1.z, t1.w);
}

// The packed group that camera rays through the tile start with.
uint fetchTileStart(uint tile) {
  const uvec4 t = texelFetch(tileStartTexels, int(tile / kTileStartsPerTexel));
  const uvec2 pair = (tile & 2u) == 0u ? t.xy : t.zw;
  return (tile & 1u) == 0u ? pair.x : pair.y;
}

Light fetchLight(uint index) {
  const int texel = int(index * kTexelsPerLight);
  const vec4 t0 = uintBitsToFloat(texelFetch(lightTexels, texel));
  const vec4 t1 = uintBitsToFloat(texelFetch(lightTexels, texel + 1));
  const vec4 t2 = uintBitsToFloat(texelFetch(lightTexels, texel + 2));
  const vec4 t3 = uintBitsToFloat(texelFetch(lightTexels, texel + 3));
  return Light(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w);
}

Material fetchMaterial(uint index) {
  const int texel = int(index * kTexelsPerMaterial);
  const vec4 t0 = uintBitsToFloat(texelFetch(materialTexels, texel));
  const vec4 t1 = uintBitsToFloat(texelFetch(materialTexels, texel + 1));
  const vec4 t2 = uintBitsToFloat(texelFetch(materialTexels, texel + 2));
  const vec4 t3 = uintBitsToFloat(texelFetch(materialTexels, texel + 3));
  return Material(t0.xyz, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w);
}

#endif
