// Nothing but the slab test, so that the module's arithmetic is that of the slab test.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"

void main() { distances = intersectBoxes(gateRay(), gateConstants(), near, far, tMax); }
