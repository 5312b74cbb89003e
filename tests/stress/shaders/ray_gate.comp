// Nothing but what is computed once for a ray, so that the module's arithmetic is that.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "gate.glsl"

void main() {
  const RayConstants constants = rayConstants(gateRay());
  inverse = constants.inverse;
  negative = uvec3(constants.negative);
  shear = constants.shear;
  axis = constants.axis;
  inverseZ = constants.inverseZ;
}
