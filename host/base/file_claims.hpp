#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace lavaray {

// Makes sure that no two outputs share a file, by whatever name or link, and that a process that asks for it
// never overwrites a file that it reads. Whoever opens a file for reading notes it here, and OutputFile
// claims what it is to replace.

// From here on what is read is noted. For a program, which reads and writes what its command line names:
// other users of the library may replace what they have read.
void protectInputs();

// `what` is for messages: "the scene". If a name is noted more than once, the first note counts. Throws
// Error(kUsage) if the file is claimed for writing.
void noteRead(const std::filesystem::path& file, const std::string& what = "the file");

// For a process that runs on without using that file any more.
void forgetRead(const std::filesystem::path& file);

// For a file that is written in place, as standard output may be. Throws Error(kUsage) if it is one that is
// read.
void checkNotRead(int descriptor, const std::string& output);

// The file that an output's name refers to.
struct WriteTarget {
  // Follows symbolic links, even to a file that does not exist yet. Throws std::system_error if they form a
  // loop.
  explicit WriteTarget(const std::filesystem::path& name);

  [[nodiscard]] std::filesystem::path folder() const;
  [[nodiscard]] bool isSameAs(const WriteTarget& other) const;

  std::filesystem::path path;
  std::optional<struct stat> old;  // of the file that exists there, if any
};

// Claims a file for writing for as long as the object lives.
class WriteClaim {
 public:
  // `option` is the command-line option that names the file. `mayReplace`, if not empty, is a file that is
  // read but may be replaced all the same (a film that a render resumes). Throws Error(kUsage) if the file is
  // any other that is read, or is claimed already.
  WriteClaim(const WriteTarget& target, const std::filesystem::path& name, const std::string& option,
             const std::filesystem::path& mayReplace);
  ~WriteClaim();
  WriteClaim(const WriteClaim&) = delete;
  WriteClaim& operator=(const WriteClaim&) = delete;

 private:
  int number_;
};

}  // namespace lavaray
