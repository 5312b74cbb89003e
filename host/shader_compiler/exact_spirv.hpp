#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lavaray {

// The last step of compiling a shader, of those in the program and of a user's alike: `spirv`, as glslang
// generates it, becomes the module that the driver gets. Each floating-point operation in it is marked
// NoContraction, which is what GLSL's `precise` asks for, so that neither the optimizer nor a driver fuses,
// reorders or replaces one: a shader means the same arithmetic to every driver. Then it is optimized for
// size. Throws std::invalid_argument where these words are no SPIR-V, std::runtime_error where the optimizer
// fails.
//
// Marked here instead of in the source, nothing can be forgotten, and a driver cannot tell the two apart.
// What no mark keeps drivers from reordering, the built-in functions dot, length and the like, the shaders do
// not use (vector.glsl).
std::vector<std::uint32_t> finishShader(std::span<const std::uint32_t> spirv);

}  // namespace lavaray
