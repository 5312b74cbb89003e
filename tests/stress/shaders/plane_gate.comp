// Nothing but the plane test, so that the module's arithmetic is that of the plane test.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"

void main() { distance = intersectPlane(gateRay(), a, tMax); }
