// The scene's arrays, and the functions that read them.
//
// Nodes, primitives, their planes and normals are read through texel buffer views: on lavapipe a texel fetch is a few wide
// loads where a storage buffer load is a branch for every component of every lane. The texels are integers, so
// that no driver takes an index for a denormal float and flushes it.
#ifndef SCENE_DATA_GLSL
#define SCENE_DATA_GLSL

#include "interface.h"

layout(constant_id = kSpecHasSpheres) const bool kHasSpheres = true;
layout(constant_id = kSpecHasTriangles) const bool kHasTriangles = true;
layout(constant_id = kSpecHasCornerNormals) const bool kHasCornerNormals = true;
layout(constant_id = kSpecPlaneCount) const uint kPlaneCount = 0u;
layout(constant_id = kSpecLightCount) const uint kLightCount = 0u;
layout(constant_id = kSpecHasMirrors) const bool kHasMirrors = false;
layout(constant_id = kSpecHasSphericalLights) const bool kHasSphericalLights = false;

layout(set = 0, binding = kBindingNodes) uniform utextureBuffer nodeTexels;
layout(set = 0, binding = kBindingPrimitives) uniform utextureBuffer primitiveTexels;
layout(set = 0, binding = kBindingTrianglePlanes) uniform utextureBuffer trianglePlaneTexels;
layout(set = 0, binding = kBindingCornerNormals) uniform utextureBuffer cornerNormalTexels;
layout(std430, set = 0, binding = kBindingPlanes) readonly buffer Planes { Plane planes[]; };
layout(std430, set = 0, binding = kBindingLights) readonly buffer Lights { Light lights[]; };
layout(std430, set = 0, binding = kBindingMaterials) readonly buffer Materials { Material materials[]; };

BvhNode fetchNode(uint index) {
  const int texel = int(index * kTexelsPerNode);
  const uvec4 t0 = texelFetch(nodeTexels, texel);
  const uvec4 t1 = texelFetch(nodeTexels, texel + 1);
  const uvec4 t2 = texelFetch(nodeTexels, texel + 2);
  const uvec4 t3 = texelFetch(nodeTexels, texel + 3);
  return BvhNode(uintBitsToFloat(t0.xyz), t0.w, uintBitsToFloat(t1.xyz), t1.w,  //
                 uintBitsToFloat(t2.xyz), t2.w, uintBitsToFloat(t3.xyz), t3.w);
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

#endif
