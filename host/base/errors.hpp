#pragma once

#include <stdexcept>
#include <string>

namespace lavaray {

// This room is what every other room builds on: errors, numbers and text, files that are read and written
// safely, memory and threads. It knows nothing about rendering. Input is read in the same way in every
// locale, no output file is ever left half written, and every failure is an Error with a sentence for the
// user.

// The process's exit codes. Scripts depend on these numbers, so they must not change.
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

// Bad input or a bad environment. The message is a sentence for the user: main prints it and returns the exit
// code. A defect of the program itself is an assertion or a std::logic_error instead.
class Error : public std::runtime_error {
 public:
  Error(ExitCode exitCode, const std::string& message) : std::runtime_error(message), exitCode_(exitCode) {}
  [[nodiscard]] ExitCode exitCode() const { return exitCode_; }

 private:
  ExitCode exitCode_;
};

}  // namespace lavaray
