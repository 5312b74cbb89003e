// How many nodes and primitives rays are tested against. Only the pipeline whose view is of that counts: in all others
// a count stays 0, and nothing is left of it.
#ifndef TESTS_GLSL
#define TESTS_GLSL

#include "interface.h"

layout(constant_id = kSpecView) const uint kView = kViewColor;

const bool kCountsTests = kView == kViewCost;

#endif
