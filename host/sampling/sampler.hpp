#pragma once

#include <cstdint>

namespace lavaray {

// How samples are placed in a pixel and on a light.
enum class Sampler {
  kSobol,   // Owen-scrambled Sobol points
  kRandom,  // independent random numbers; for comparison
};

inline constexpr const char* kSamplerNames = "sobol, random";
inline const char* samplerName(Sampler sampler) {
  return sampler == Sampler::kSobol ? "sobol" : "random";
}

// As many samples as the fixed-point sums can hold (see PixelSum).
inline constexpr std::uint32_t kMaxSamplesPerPixel = 1U << 22U;

}  // namespace lavaray
