#pragma once

#include <functional>
#include <string>

namespace lavaray {

// Runs a program's body and returns its exit code, which an error's kind is. An exception is printed as
// `name: message`.
int runProgram(const std::string& name, const std::function<int()>& body);

struct Failure {
  int code;  // the program's, an error's kind
  std::string message;
};
// What the exception that is being handled says.
Failure currentFailure();

}  // namespace lavaray
