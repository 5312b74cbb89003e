// Nothing but a point on a plane and the offset from it, so that the module's arithmetic is theirs.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"
#include "surface.glsl"

void main() { weights = leave(pointOnPlane(a, b, tMax, gateRay().direction), c); }
