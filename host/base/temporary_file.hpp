#pragma once

#include <filesystem>
#include <string>

namespace lavaray {

// A file that is written beside the one that it is to become, so that it comes into being whole or not at
// all. Where the file system can keep a file without a name (O_TMPFILE), it has none until it is finished:
// whatever ends the process, nothing is left. Elsewhere it has a temporary name, which a process that dies by
// a signal removes (removeTemporaryFiles), and which is locked (flock), so that the next process that writes
// the same file knows what is left over from what is in use, and takes it away.
class TemporaryFile {
 public:
  // Throws std::system_error.
  explicit TemporaryFile(const std::filesystem::path& target);
  // Unless it was moved or kept, it is gone.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  // Gives it a temporary name if it has none. Throws std::system_error.
  void giveName();
  // These need a name. The first replaces the target, and returns whether it did, with errno. The second
  // leaves the file where a user finds it, and returns the name.
  [[nodiscard]] bool replaceTarget();
  std::filesystem::path keep();

 private:
  bool openUnnamed();
  void openNamed();
  bool link();
  std::string newName() const;
  void setName(const std::string& name);
  void forgetName();
  void removeLeftovers() const;

  std::filesystem::path target_;
  std::filesystem::path folder_;
  std::string prefix_;  // of its temporary names
  std::string name_;    // or empty
  int descriptor_ = -1;
};

// Removes all temporary files of this process that have names. For a signal handler that ends the process; a
// process that was forked from it removes none.
void removeTemporaryFiles();

}  // namespace lavaray
