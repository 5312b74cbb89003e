// Gives every file of a folder to a fuzzer's target, in any build: `replay FOLDER`. What the target finds
// wrong ends the process, as in the fuzzer.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "base/byte_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: replay FOLDER\n";
    return 2;
  }
  using Clock = std::chrono::steady_clock;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  double slowest = 0.0;
  for (const std::filesystem::path& file : files) {
    std::cout << file.filename().string() << std::endl;  // at once: the next line may be the last
    const std::string text = lavaray::readFile(file);
    const Clock::time_point start = Clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::cout << files.size() << " inputs, the slowest in " << slowest << " s\n";
  return files.empty() ? 1 : 0;
}
