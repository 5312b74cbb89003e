#pragma once

#include <lavaray/types.h>

namespace lavaray {

// Samples of each pixel's sequence.
using v0::SampleRange;

}  // namespace lavaray
