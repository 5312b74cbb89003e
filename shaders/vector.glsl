// Vector functions that the language lacks, or has with too small a range or in an unspecified order of
// operations.
#ifndef VECTOR_GLSL
#define VECTOR_GLSL

const float kInfinity = 1.0 / 0.0;
const float kMinNormal = 1.17549435e-38;  // 2^-126; below are the denormal numbers
const float kMinExact = 7.8886091e-31;    // 2^-100; a denormal number added to this or more is rounded away

float maxComponent(vec3 v) {
  return max(v.x, max(v.y, v.z));
}
float minComponent(vec3 v) {
  return min(v.x, min(v.y, v.z));
}

// The dot product, added from left to right. The order in which the built-in dot, length, distance and
// reflect add, and how mix with a number is computed, are up to the driver and differ between versions of
// Mesa, so no shader uses them (tests/stress/spirv_gate.cpp checks that).
float preciseDot(vec3 a, vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
float preciseLength(vec3 v) {
  return sqrt(preciseDot(v, v));
}

// v scaled to unit length; the zero vector stays zero. The built-in normalize loses vectors shorter than
// 1e-19 or longer than 1e19, whose squared length is out of range; here the largest component is 1 before it
// is squared.
vec3 unit(vec3 v) {
  const float largest = maxComponent(abs(v));
  if (largest == 0.0) return vec3(0.0);
  const vec3 scaled = v / largest;
  return scaled / preciseLength(scaled);
}

#endif
