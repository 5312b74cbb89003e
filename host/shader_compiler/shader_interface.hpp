#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lavaray {

// The first line, from 1, at which this interface.h differs from the program's; empty where none does.
std::optional<std::size_t> firstDifference(std::string_view interface);

// Something in a shader that has no counterpart in the host.
struct Misfit {
  std::string word;  // that the source has where it is declared
  std::string message;
};

// Compares what a valid compute shader asks for with what the host provides: bindings, push constants, local
// size, specialization constants and features of the device. Only what the optimizer leaves counts, since a
// shader may declare what it does not use; but it counts as written, since some optimizers shrink what they
// leave.
std::vector<Misfit> findMisfits(std::span<const std::uint32_t> written,
                                std::span<const std::uint32_t> optimized);

}  // namespace lavaray
