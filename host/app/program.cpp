#include "app/program.hpp"

#include <csignal>
#include <exception>
#include <iostream>

namespace lavaray {

int runProgram(const std::string& name, const std::function<ExitCode()>& body) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the size limit shall be a write error, not the end
  try {
    return static_cast<int>(body());
  } catch (const Error& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return static_cast<int>(error.exitCode());
  } catch (const std::exception& error) {
    std::cerr << name << ": internal error: " << error.what() << '\n';
    return static_cast<int>(ExitCode::kInternalError);
  }
}

}  // namespace lavaray
