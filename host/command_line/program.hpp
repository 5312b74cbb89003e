#pragma once

#include <functional>
#include <string>

#include "base/errors.hpp"

namespace lavaray {

struct Failure {
  ExitCode exitCode;
  std::string message;
};

// What the exception being handled says.
Failure currentFailure();

// Runs a program's body and returns its exit code. An exception is printed as `name: message`.
int runProgram(const std::string& name, const std::function<ExitCode()>& body);

}  // namespace lavaray
