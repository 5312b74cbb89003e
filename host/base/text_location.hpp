#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/printable.hpp"

namespace lavaray {

// A line of an input file, counted from 1. Refers to the path, which must outlive the object.
struct TextLocation {
  const std::filesystem::path& file;
  std::size_t line;
};

// `file:line: message`, the form of every message about input.
std::string messageAt(const TextLocation& location, std::string_view message);

// Throws Error(kInput) with messageAt's text.
[[noreturn]] void failAt(const TextLocation& location, std::string_view message);

// Text from an input file in double quotes, made fit for a message: control characters replaced, long text
// cut.
std::string quoted(std::string_view text);

// A word of a file format in backticks, which set it off from the sentence around it.
std::string backticked(std::string_view word);

}  // namespace lavaray
