#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace lavaray {

// This room is what every other room builds on: errors, numbers and text, files that are read and written
// safely, memory and threads. It knows nothing about rendering. Input is read in the same way in every
// locale, no output file is ever left half written, and every failure is an Error with a sentence for the
// user.

// What an error is about: the programs' exit codes. Scripts depend on these numbers, so they must not change.
enum class ExitCode : int {
  kSuccess = 0,
  kInternalError = 1,
  kUsage = 2,
  kInput = 3,  // the scene or a mesh
  kDevice = 4,
  kOutput = 5,
  kMemory = 6,
};

// Bad input or a bad environment. The message is a sentence for the user: a program prints it and returns the
// exit code. A defect of the program itself is an assertion or a std::logic_error instead.
class Error : public std::runtime_error {
 public:
  // `file` and `line` are for programs: a message about a file names it anyway.
  Error(ExitCode exitCode, const std::string& message, std::string file = {}, std::size_t line = 0)
      : std::runtime_error(message), exitCode_(exitCode), file_(std::move(file)), line_(line) {}
  [[nodiscard]] ExitCode exitCode() const { return exitCode_; }
  [[nodiscard]] const std::string& file() const { return file_; }  // empty where it is about none
  [[nodiscard]] std::size_t line() const { return line_; }         // from 1; 0 where it is about none

 private:
  ExitCode exitCode_;
  std::string file_;
  std::size_t line_;
};

}  // namespace lavaray
