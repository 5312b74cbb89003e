#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lavaray {

// What the compiler says about a line of a source.
struct CompilerMessage {
  bool isError;        // or a warning
  std::string source;  // the name that the compiler knows it by; empty where the message has no place
  std::size_t line;    // from 1
  std::string text;
  std::string function;  // that the message is about, where it has no place but a function
};

// Reads a log of glslang's. What merely follows from another message is left out, as are repetitions.
std::vector<CompilerMessage> readCompilerLog(std::string_view log);

// A place in the preprocessor's output, whose lines `#line NUMBER "SOURCE"` say where the next line is from.
struct PreprocessedPlace {
  std::string source;
  std::size_t line = 1;
};

// Where `word`, or a word with what follows it, stands first; an empty source where it does not.
PreprocessedPlace findWord(std::string_view preprocessed, std::string_view word);

}  // namespace lavaray
