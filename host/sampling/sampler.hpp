#pragma once

#include <cstdint>

namespace lavaray {

// Where in a pixel, and on a light, samples lie.
enum class Sampler {
  kSobol,   // Owen-scrambled Sobol points
  kRandom,  // independent random numbers; for comparison
};

inline constexpr const char* kSamplerNames = "sobol, random";
inline const char* samplerName(Sampler sampler) {
  return sampler == Sampler::kSobol ? "sobol" : "random";
}

// Samples of one pixel: as many as the fixed-point sums hold (see PixelSum).
inline constexpr std::uint32_t kMaxSamplesPerPixel = 1U << 22U;

}  // namespace lavaray
