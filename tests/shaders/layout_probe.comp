// Reads every struct that host and shaders share, field by field, and writes the fields out one after the
// other: if the layouts agree, that is what the host has in memory.
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
layout(std430, set = 0, binding = kBindingProbeOut) buffer Words { uint words[]; };
layout(push_constant) uniform PushConstants { DispatchConstants constants; };

void put(uint value, inout uint end) { words[end++] = value; }
void put(float value, inout uint end) { put(floatBitsToUint(value), end); }
void put(uvec3 value, inout uint end) {
  put(value.x, end);
  put(value.y, end);
  put(value.z, end);
}
void put(vec2 value, inout uint end) {
  put(value.x, end);
  put(value.y, end);
}
void put(vec3 value, inout uint end) {
  put(value.xy, end);
  put(value.z, end);
}

// The second element of each array, so that the size of one is proved too.
void main() {
  uint end = 0u;
  const BvhNode node = fetchNode(1u);
  put(node.origin, end); put(node.exponents, end); put(node.lower, end); put(node.padding0, end);
  put(node.upper, end); put(node.padding1, end); put(node.children.xyz, end); put(node.children.w, end);
  const Primitive primitive = fetchPrimitive(1u);
  put(primitive.a, end); put(primitive.kind, end); put(primitive.b, end); put(primitive.object, end);
  put(primitive.c, end); put(primitive.order, end);
  const TrianglePlane trianglePlane = fetchTrianglePlane(1u);
  put(trianglePlane.normal, end); put(trianglePlane.distance, end);
  const CornerNormal cornerNormal = fetchCornerNormal(1u);
  put(cornerNormal.normal, end); put(cornerNormal.padding, end);
  const Plane plane = fetchPlane(1u);
  put(plane.normal, end); put(plane.distance, end); put(plane.object, end);
  put(plane.padding0, end); put(plane.padding1, end); put(plane.padding2, end);
  const Light light = fetchLight(1u);
  put(light.position, end); put(light.radius, end); put(light.ambient, end); put(light.padding1, end);
  put(light.diffuse, end); put(light.padding2, end); put(light.specular, end); put(light.padding3, end);
  const Material material = fetchMaterial(1u);
  put(material.ambient, end); put(material.shininess, end); put(material.diffuse, end);
  put(material.padding0, end); put(material.specular, end); put(material.padding1, end);
  put(material.reflectance, end); put(material.padding2, end);
  put(constants.pixelSize, end); put(constants.halfImage, end); put(constants.focalLength, end);
  put(constants.cropX, end); put(constants.cropY, end); put(constants.cropWidth, end);
  put(constants.itemCount, end); put(constants.mode, end); put(constants.seed, end);
  put(constants.maxDepth, end); put(constants.filterSize, end);
  put(constants.firstPixel, end); put(constants.tileShift, end); put(constants.tilesAcross, end);
  const WorkItem item = items[1];
  put(item.pixel, end); put(item.part, end); put(item.first, end); put(item.count, end);
  const WorkState state = states[1];
  put(state.sum, end); put(state.taken, end); put(state.color, end); put(state.bounce, end);
  put(state.step, end); put(state.squares, end); put(state.tests, end); put(state.padding0, end);
  results[1] = WorkResult(vec3(1.0, 2.0, 3.0), 4.0);
  statuses[1] = DispatchStatus(5u, 6u, 7u, 8u, 9u, 10u, 11u, 12u);
}
