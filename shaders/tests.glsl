// The number of nodes and primitives that rays are tested against; an inner node counts once for all its
// children's boxes. Only the pipeline of the view that shows it counts. In all others kCountsTests is false
// wherever a count would change, so that nothing of it is left: on lavapipe their machine code is the same as
// without the counts.
#ifndef TESTS_GLSL
#define TESTS_GLSL

#include "interface.h"

layout(constant_id = kSpecView) const uint kView = kViewColor;

const bool kCountsTests = kView == kViewCost;

#endif
