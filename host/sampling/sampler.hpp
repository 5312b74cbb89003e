#pragma once

#include <cstdint>

#include <lavaray/types.h>

namespace lavaray {

using v0::kSamplerNames;
using v0::Sampler;

inline const char* samplerName(Sampler sampler) {
  return sampler == Sampler::kSobol ? "sobol" : "random";
}

// As many samples as the fixed-point sums can hold (see PixelSum).
inline constexpr std::uint32_t kMaxSamplesPerPixel = 1U << 22U;

}  // namespace lavaray
