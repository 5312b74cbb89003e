#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lavaray {

// The last step of compiling a shader, be it one of the program's own or a user's: turns `spirv`, as glslang
// generates it, into the module that the driver gets. It marks each floating-point operation NoContraction,
// as GLSL's `precise` does, so that neither the optimizer nor a driver fuses, reorders or replaces it: a
// shader means the same arithmetic to every driver. It optimizes the module for size and unrolls the loops
// that are marked [[unroll]]. Throws std::invalid_argument where these words are no SPIR-V,
// std::runtime_error where the optimizer fails.
//
// Marking here instead of in the source forgets nothing, and a driver cannot tell the difference. No mark
// keeps drivers from reordering the built-in functions dot, length and the like; the shaders do not use these
// (vector.glsl).
std::vector<std::uint32_t> finishShader(std::span<const std::uint32_t> spirv);

}  // namespace lavaray
