// Nothing but the triangle test, so that the module's arithmetic is that of the edge functions.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"

void main() { distance = intersectTriangle(gateRay(), gateConstants(), a, b, c, weights); }
