#pragma once

#include <stdexcept>
#include <string>

namespace lavaray {

// What the process returns. Scripts depend on these, so the numbers are fixed.
enum class ExitCode : int {
  kSuccess = 0,
  kInternalError = 1,
  kUsage = 2,
  kInput = 3,  // the scene or a mesh
  kDevice = 4,
  kOutput = 5,
  kMemory = 6,
  kImagesDiffer = 10,
  kHungUp = 129,
  kInterrupted = 130,
  kEnded = 143,
};

// Bad input or a bad environment. The message is a sentence for the user; main prints it and returns
// the exit code. What can only be a defect of the program itself is an assertion or a std::logic_error.
class Error : public std::runtime_error {
 public:
  Error(ExitCode exitCode, const std::string& message) : std::runtime_error(message), exitCode_(exitCode) {}
  [[nodiscard]] ExitCode exitCode() const { return exitCode_; }

 private:
  ExitCode exitCode_;
};

}  // namespace lavaray
