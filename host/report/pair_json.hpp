#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "report/pair.hpp"

namespace lavaray {

// What is known of a pair, as a JSON object without a line break.
std::string pairJson(const ComparedPair& compared);

// Writes a file of pairs, one at a time. Whether everything was written is for the stream's owner to check.
class PairsFile {
 public:
  // `version` is that of the program.
  PairsFile(std::FILE* stream, const std::string& version);
  void add(const ComparedPair& compared);
  void finish();

 private:
  std::FILE* stream_;
  bool isFirst_ = true;
};

// The pairs in a file that `lavaray-diff --json` wrote, with their drivers and limits. Paths that are not
// absolute are relative to the current folder. Throws Error(kInput) with the file's name if it is no such
// file.
std::vector<Pair> readPairs(const std::filesystem::path& file);

}  // namespace lavaray
