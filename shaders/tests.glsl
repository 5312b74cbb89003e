// How many nodes and primitives rays are tested against: an inner node once for the boxes of all its
// children. Only the pipeline whose view is of that counts. For all others kCountsTests is false wherever a
// count is changed, so that nothing is left of it: on lavapipe their machine code is what it was without.
#ifndef TESTS_GLSL
#define TESTS_GLSL

#include "interface.h"

layout(constant_id = kSpecView) const uint kView = kViewColor;

const bool kCountsTests = kView == kViewCost;

#endif
