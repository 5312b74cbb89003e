#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lavaray {

// What the compiler says about a line of a source.
struct CompilerMessage {
  bool isError;        // or a warning
  std::string source;  // the compiler's name for it; empty where the message has no location
  std::size_t line;    // from 1
  std::string text;
  std::string function;  // that the message is about, where it names one in place of a location
};

// Reads a log of glslang's. Leaves out repetitions and what merely follows from another message.
std::vector<CompilerMessage> readCompilerLog(std::string_view log);

// Where a line of the preprocessor's output comes from; its lines `#line NUMBER "SOURCE"` say so of the next
// one.
struct PreprocessedLocation {
  std::string source;
  std::size_t line = 1;
};

// Where `word`, or a word with what follows it, first occurs; an empty source where it does not.
PreprocessedLocation findWord(std::string_view preprocessed, std::string_view word);

}  // namespace lavaray
