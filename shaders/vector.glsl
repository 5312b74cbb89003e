// Vector functions that the language has not, or has with too little range.
#ifndef VECTOR_GLSL
#define VECTOR_GLSL

const float kInfinity = 1.0 / 0.0;

float maxComponent(vec3 v) { return max(v.x, max(v.y, v.z)); }
float minComponent(vec3 v) { return min(v.x, min(v.y, v.z)); }

// The dot product as products and sums that a compiler may not contract; `precise` does not reach into the built-in
// dot.
float preciseDot(vec3 a, vec3 b) {
  precise const float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

// v at unit length; the zero vector stays zero. The built-in normalize loses vectors shorter than 1e-19 or
// longer than 1e19, whose squared length is not a float; here the largest component is 1 before the squaring.
vec3 unit(vec3 v) {
  const float largest = maxComponent(abs(v));
  if (largest == 0.0) return vec3(0.0);
  const vec3 scaled = v / largest;
  return scaled / sqrt(dot(scaled, scaled));
}

#endif
