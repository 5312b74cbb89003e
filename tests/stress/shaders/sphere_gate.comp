// Nothing but the sphere test, so that the module's arithmetic is that of the sphere test.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"

void main() { distance = intersectSphere(gateRay(), a, tMax); }
