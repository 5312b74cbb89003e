// lavaray-embed-shader NAME SPIRV HEADER [--unfinished]: a tool of the build. Finishes a shader that glslang
// has compiled (exact_spirv.hpp) and writes a header that defines its words as `const uint32_t NAME[]`. With
// --unfinished it leaves them as glslang made them, for tests of a shader before it is marked and optimized.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "shader_compiler/exact_spirv.hpp"

namespace {

std::vector<std::uint32_t> readWords(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot be read");
  std::vector<std::uint32_t> words(static_cast<std::size_t>(file.tellg()) / sizeof(std::uint32_t));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(words.data()),
            static_cast<std::streamsize>(words.size() * sizeof(std::uint32_t)));
  return words;
}

void writeHeader(const std::string& path, const std::string& name, const std::vector<std::uint32_t>& words) {
  constexpr std::size_t kWordsPerLine = 8;
  std::ofstream file(path);
  file << "#pragma once\n\n#include <cstdint>\n\nconst std::uint32_t " << name << "[] = {";
  for (std::size_t i = 0; i < words.size(); ++i) {
    file << (i % kWordsPerLine == 0 ? "\n  " : " ") << words[i] << "u,";
  }
  file << "\n};\n";
  file.close();
  if (!file) throw std::runtime_error("cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  const bool isUnfinished = argc == 5 && std::string_view(argv[4]) == "--unfinished";
  if (argc != 4 && !isUnfinished) {
    std::fputs("usage: lavaray-embed-shader NAME SPIRV HEADER [--unfinished]\n", stderr);
    return 2;
  }
  try {
    const std::vector<std::uint32_t> words = readWords(argv[2]);
    writeHeader(argv[3], argv[1], isUnfinished ? words : lavaray::finishShader(words));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lavaray-embed-shader: %s: %s\n", argv[2], error.what());
    return 1;
  }
}
