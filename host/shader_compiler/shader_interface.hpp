#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lavaray {

// The bytes of shaders/interface.h that this program was built with.
std::string_view builtInInterface();

// The first line, from 1, at which this interface.h is not the program's; empty where it is.
std::optional<std::size_t> firstDifference(std::string_view interface);

// Something in a shader that the host has no counterpart for.
struct Misfit {
  std::string word;  // what stands in the source where it is declared
  std::string message;
};

// Compares what a valid compute shader asks for with what the host gives it: bindings, push constants, local
// size, specialization constants, features of the device. Only what the optimizer leaves counts, as a shader
// may declare what it does not use; but as it is written, since some optimizers make what is left smaller.
std::vector<Misfit> findMisfits(std::span<const std::uint32_t> written,
                                std::span<const std::uint32_t> optimized);

}  // namespace lavaray
