#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace lavaray {

// No file that the process reads is ever what it writes, nor do two outputs share a file, by whatever name or
// link. Whatever opens a file for reading notes it here, and OutputFile claims what it is to replace.

// `what` is for messages: "the scene". Of several notes of one name the first counts. Throws Error(kUsage)
// where the file is claimed for writing.
void noteRead(const std::filesystem::path& file, const std::string& what = "the file");

// For a process that goes on without that file.
void forgetRead(const std::filesystem::path& file);

// For a file that is written without being replaced, as the standard output may be. Throws Error(kUsage)
// where it is one that is read.
void checkNotRead(int descriptor, const std::string& output);

// The file that a name for writing stands for.
struct WriteTarget {
  // Follows symbolic links, also to a file that is not there yet. Throws std::system_error where they have no
  // end.
  explicit WriteTarget(const std::filesystem::path& name);

  [[nodiscard]] std::filesystem::path folder() const;
  [[nodiscard]] bool isSameAs(const WriteTarget& other) const;

  std::filesystem::path path;
  std::optional<struct stat> old;  // of what is there
};

// A claim of a file for writing, as long as it lives.
class WriteClaim {
 public:
  // `option` is the one that names the file; `mayReplace` a file that is read and may be replaced nonetheless
  // (a film that a render goes on from), or empty. Throws Error(kUsage) where the file is another that is
  // read or is claimed already.
  WriteClaim(const WriteTarget& target, const std::filesystem::path& name, const std::string& option,
             const std::filesystem::path& mayReplace);
  ~WriteClaim();
  WriteClaim(const WriteClaim&) = delete;
  WriteClaim& operator=(const WriteClaim&) = delete;

 private:
  int number_;
};

}  // namespace lavaray
