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

// A file to write, as named on the command line.
struct OutputName {
  std::string option;
  std::filesystem::path file;
  // A file that is read but may be replaced all the same: a film that a render resumes, by a checkpoint.
  std::filesystem::path mayReplace = {};
};

// A file that is created whole or not at all: it is written in the target's folder and replaces the target in
// commit(). Without that call it vanishes, and whatever was there before stays. If the target is a symbolic
// link, the file that it points to is replaced, not the link.
class OutputFile {
 public:
  // Finds out now what would make commit() fail. Throws Error(kOutput) if the folder cannot be written to, or
  // if what is there is not an ordinary file or cannot be replaced; Error(kUsage) if it is a file that is
  // read or is being written already.
  explicit OutputFile(const OutputName& output);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::FILE* stream() const { return stream_->get(); }
  // Throws Error(kOutput) if not everything could be written. If everything was but the target cannot be
  // replaced, the file is kept under a name that the message gives.
  void commit();

 private:
  std::filesystem::path name_;
  WriteTarget target_;
  WriteClaim claim_;
  std::optional<TemporaryFile> temporary_;
  std::optional<CheckedStream> stream_;
};

// For use before anything is read: throws Error(kUsage) if one of the files is one that is read, or if two
// are the same. Whether they can be written is for OutputFile to find out.
void checkOutputs(std::span<const OutputName> outputs);

}  // namespace lavaray
