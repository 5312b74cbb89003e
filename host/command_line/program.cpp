#include "command_line/program.hpp"

#include <fcntl.h>
#include <lavaray/files.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include "command_line/deadly_signals.hpp"
#include "command_line/file_size_limit.hpp"
#include "command_line/interrupt.hpp"

namespace lavaray {
namespace {

constexpr const char* kNoMemory = "there is not enough memory; a smaller image or scene needs less";

std::string programName;

// Drivers have threads of their own, in which their compiler throws if it gets no memory.
[[noreturn]] void onTerminate() {
  removeTemporaryFiles();
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    std::fputs((programName + ": " + kNoMemory + '\n').c_str(), stderr);
    std::_Exit(static_cast<int>(ErrorKind::kMemory));
  } catch (...) {
  }
  std::abort();
}

// A file that is opened later must not become a standard stream: the picture would go into a driver's memory,
// or messages into the picture. These are opened in the wrong direction, so that using a closed stream stays
// an error.
void occupyStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool isClosed = fcntl(stream, F_GETFD) == -1 && errno == EBADF;
    if (isClosed) (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

// A stream remembers that a write has failed, but not why; another write tells.
int checkPrinted(int code) {
  if (std::cout.flush() && std::fflush(stdout) == 0) return code;
  errno = 0;
  std::putchar('\n');
  std::fflush(stdout);
  const int reason = errno;
  throw Error(ErrorKind::kOutput, std::string("the output cannot be written to stdout: ") +
                                      (reason != 0 ? std::strerror(reason) : "a write failed"));
}

Failure failureOf(ErrorKind kind, const std::string& message) {
  return {static_cast<int>(kind), message};
}

}  // namespace

Failure currentFailure() {
  try {
    throw;
  } catch (const Error& error) {
    return failureOf(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return failureOf(ErrorKind::kMemory, kNoMemory);
  } catch (const std::system_error& error) {
    // If a thread cannot start, the system says no more than to try again.
    const bool isMemory = error.code() == std::errc::not_enough_memory ||
                          error.code() == std::errc::resource_unavailable_try_again;
    if (isMemory) return failureOf(ErrorKind::kMemory, kNoMemory);
    return failureOf(ErrorKind::kInternal, "the system refuses what is needed: " + error.code().message());
  } catch (const std::exception& error) {
    return failureOf(ErrorKind::kInternal,
                     std::string("internal error, a defect of the program: ") + error.what());
  }
}

int runProgram(const std::string& name, const std::function<int()>& body) {
  programName = name;
  occupyStandardStreams();
  protectInputs();
  std::set_terminate(onTerminate);
  cleanUpAtDeath();
  catchInterrupts(name);
  surviveFileSizeLimit(name);
  try {
    return checkPrinted(body());
  } catch (const std::exception&) {
    const Failure failure = currentFailure();
    std::cerr << name << ": " << failure.message << '\n';
    return failure.code;
  }
}

}  // namespace lavaray
