// Vector functions that the language has not, or has with too little range or in no certain order.
#ifndef VECTOR_GLSL
#define VECTOR_GLSL

const float kInfinity = 1.0 / 0.0;
const float kMinNormal = 1.17549435e-38;  // 2^-126: what is below is a denormal number
const float kMinExact = 7.8886091e-31;  // 2^-100: what denormal numbers add to this or more rounds to nothing

float maxComponent(vec3 v) {
  return max(v.x, max(v.y, v.z));
}
float minComponent(vec3 v) {
  return min(v.x, min(v.y, v.z));
}

// The dot product from left to right. In which order the built-in dot, length, distance and reflect add, and
// how mix with a number is computed, is the driver's choice, and it differs from one version of Mesa's to the
// next: no shader uses them (tests/stress/spirv_gate.cpp looks).
float preciseDot(vec3 a, vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
float preciseLength(vec3 v) {
  return sqrt(preciseDot(v, v));
}

// v at unit length; the zero vector stays zero. The built-in normalize loses vectors shorter than 1e-19 or
// longer than 1e19, whose squared length is not a float; here the largest component is 1 before the squaring.
vec3 unit(vec3 v) {
  const float largest = maxComponent(abs(v));
  if (largest == 0.0) return vec3(0.0);
  const vec3 scaled = v / largest;
  return scaled / preciseLength(scaled);
}

#endif
