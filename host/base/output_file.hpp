#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/checked_stream.hpp"
#include "base/file_claims.hpp"
#include "base/temporary_file.hpp"

namespace lavaray {

// A file to be written, as the command line names it.
struct OutputName {
  std::string option;
  std::filesystem::path file;
  // A file that is read and may be replaced nonetheless: a film that a render goes on from, by a checkpoint.
  std::filesystem::path mayReplace = {};
};

// A file that comes into being whole or not at all: it is written beside its place and takes it by commit().
// Without that it vanishes, and what was there before stays. Behind a symbolic link the file that it points
// to is replaced, not the link.
class OutputFile {
 public:
  // Finds out now what would make commit() fail. Throws Error(kOutput) where the folder cannot be written to,
  // or what is there is no ordinary file or may not be replaced; Error(kUsage) where it is a file that is
  // read, or that is being written already.
  explicit OutputFile(const OutputName& output);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::FILE* stream() const { return stream_->get(); }
  // Throws Error(kOutput) where not everything could be written; where it was, but the file cannot take its
  // place, it stays under a name that the message tells.
  void commit();

 private:
  std::filesystem::path name_;
  WriteTarget target_;
  WriteClaim claim_;
  std::optional<TemporaryFile> temporary_;
  std::optional<CheckedStream> stream_;
};

// Before anything is read: throws Error(kUsage) where one of the files is one that is read, or two are the
// same. Whether they can be written is for OutputFile to find out.
void checkOutputs(std::span<const OutputName> outputs);

}  // namespace lavaray
