// Reads every struct that the host and the shaders share, field by field, and writes the fields one after the
// other: if the layouts agree, the result is what the host has in memory.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "probe.h"
#include "scene_data.glsl"

layout(local_size_x = 1) in;
layout(std430, set = 0, binding = kBindingProbeIn) buffer InAndOut {
  WorkItem items[2];
  WorkState states[2];
  WorkResult results[2];
  DispatchStatus statuses[2];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Words {
  uint words[];
};
layout(push_constant) uniform PushConstants {
  DispatchConstants constants;
};

void put(uint value, inout uint end) {
  words[end++] = value;
}
void put(float value, inout uint end) {
  put(floatBitsToUint(value), end);
}
void put(vec2 value, inout uint end) {
  put(value.x, end);
  put(value.y, end);
}
void put(uvec3 value, inout uint end) {
  put(value.x, end);
  put(value.y, end);
  put(value.z, end);
}

// Each vec3 is followed by a scalar.
void put(uvec3 value, uint next, inout uint end) {
  put(value, end);
  put(next, end);
}
void put(vec3 value, uint next, inout uint end) {
  put(floatBitsToUint(value), next, end);
}
void put(vec3 value, float next, inout uint end) {
  put(value, floatBitsToUint(next), end);
}

void putScene(inout uint end) {
  const BvhNode node = fetchNode(1u);
  put(node.origin, node.exponents, end);
  put(node.lower, node.padding0, end);
  put(node.upper, node.padding1, end);
  put(node.children.xyz, node.children.w, end);
  const Primitive primitive = fetchPrimitive(1u);
  put(primitive.a, primitive.kind, end);
  put(primitive.b, primitive.object, end);
  put(primitive.c, primitive.order, end);
  const TrianglePlane trianglePlane = fetchTrianglePlane(1u);
  put(trianglePlane.normal, trianglePlane.distance, end);
  const CornerNormal cornerNormal = fetchCornerNormal(1u);
  put(cornerNormal.normal, cornerNormal.padding, end);
  const Plane plane = fetchPlane(1u);
  put(plane.normal, plane.distance, end);
  put(uvec3(plane.object, plane.padding0, plane.padding1), plane.padding2, end);
  const Light light = fetchLight(1u);
  put(light.position, light.radius, end);
  put(light.ambient, light.padding1, end);
  put(light.diffuse, light.padding2, end);
  put(light.specular, light.padding3, end);
  const Material material = fetchMaterial(1u);
  put(material.ambient, material.shininess, end);
  put(material.diffuse, material.padding0, end);
  put(material.specular, material.padding1, end);
  put(material.reflectance, material.padding2, end);
}

void putConstants(inout uint end) {
  put(constants.pixelSize, end);
  put(constants.halfImage, end);
  put(constants.focalLength, end);
  put(uvec3(constants.areaX, constants.areaY, constants.areaWidth), end);
  put(uvec3(constants.itemCount, constants.mode, constants.seed), end);
  put(uvec3(constants.maxDepth, constants.filterSize, constants.firstPixel), end);
  put(constants.tileShift, end);
  put(constants.tilesAcross, end);
}

void putWork(inout uint end) {
  const WorkItem item = items[1];
  put(uvec3(item.pixel, item.part, item.first), item.count, end);
  const WorkState state = states[1];
  put(state.sum, state.taken, end);
  put(state.color, state.bounce, end);
  put(state.step, end);
  put(state.squares, end);
  put(state.tests, end);
  put(state.padding0, end);
}

// Takes the second element of each array, so that the size of an element is checked too.
void main() {
  uint end = 0u;
  putScene(end);
  putConstants(end);
  putWork(end);
  results[1] = WorkResult(vec3(1.0, 2.0, 3.0), 4.0);
  statuses[1] = DispatchStatus(5u, 6u, 7u, 8u, 9u, 10u, 11u, 12u, uint[](13u, 14u, 15u, 16u),
                               uint[](17u, 18u, 19u, 20u));
}
