#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "bvh/flatten.hpp"

namespace lavaray {

// Runs a probe shader on the test device: one invocation for each query, in work groups of
// gpu::kWorkGroupSize. The scene's arrays are bound as the renderer binds them, the queries at
// gpu::kBindingProbeIn and the answers, each of `answerSize` bytes, at gpu::kBindingProbeOut.
std::vector<std::byte> runProbe(std::span<const std::uint32_t> spirv, const GpuScene& scene,
                                std::span<const std::byte> queries, std::size_t queryCount,
                                std::size_t answerSize, std::span<const std::byte> constants);

// The same with types. `constants` become the push constants.
template <typename Answer, typename Query, typename Constants>
std::vector<Answer> runProbe(std::span<const std::uint32_t> spirv, const GpuScene& scene,
                             const std::vector<Query>& queries, const Constants& constants) {
  const std::vector<std::byte> bytes =
      runProbe(spirv, scene, std::as_bytes(std::span(queries)), queries.size(), sizeof(Answer),
               std::as_bytes(std::span(&constants, 1)));
  std::vector<Answer> answers(queries.size());
  std::memcpy(answers.data(), bytes.data(), bytes.size());
  return answers;
}

}  // namespace lavaray
