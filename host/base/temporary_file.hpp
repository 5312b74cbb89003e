#pragma once

#include <filesystem>
#include <string>

namespace lavaray {

// A file that is written in the folder of the file that it is to become, so that the latter is created whole
// or not at all. If the file system supports files without a name (O_TMPFILE), it has none until it is
// finished: whatever ends the process, nothing is left behind. Elsewhere it has a temporary name, which a
// process killed by a signal removes (removeTemporaryFiles). It is also locked (flock), so that the next
// process that writes the same file can tell leftovers from files in use, and removes the leftovers.
class TemporaryFile {
 public:
  // Throws std::system_error.
  explicit TemporaryFile(const std::filesystem::path& target);
  // Removes the file unless it has replaced the target or was kept.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  // Gives the file a temporary name if it has none. Throws std::system_error.
  void giveName();
  // Needs a name, as does keep(). False if it fails, with the reason in errno.
  [[nodiscard]] bool replaceTarget();
  // Leaves the file under a visible name, for the user to find, and returns that name.
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
  std::string name_;    // empty if it has none
  int descriptor_ = -1;
};

// Removes all temporary files of this process that have names. For a signal handler that ends the process; in
// a forked child it does nothing.
void removeTemporaryFiles();

}  // namespace lavaray
