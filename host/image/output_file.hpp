#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace lavaray {

// A file that comes into being whole or not at all: it is written under a temporary name in the same folder
// and renamed by commit(). Without that it vanishes, and what was there before stays.
class OutputFile {
 public:
  // Throws Error(kOutput) where the folder cannot be written to or `path` is no ordinary file.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::FILE* stream() const { return stream_; }
  // Throws Error(kOutput) where not everything could be written.
  void commit();

 private:
  void removeTemporary();
  void forgetTemporary();

  std::filesystem::path path_;
  std::string temporary_;
  std::FILE* stream_ = nullptr;
};

// Removes what all OutputFiles have written so far. For a signal handler that ends the process.
void removeTemporaryFiles();

}  // namespace lavaray
