#pragma once

#include <string>

#include "base/errors.hpp"

namespace lavaray {

// What SIGHUP, SIGINT and SIGTERM do from here on: they end the process at once with 128 + the signal's
// number, a word on stderr that begins with `programName`, and no temporary file left; or, while there is an
// InterruptGuard, they are remembered. A SIGHUP that is ignored already stays so (nohup).
void catchInterrupts(const std::string& programName);

// What is said where a signal ends the process at once; text that stays.
void setInterruptedText(const char* text);

// For work that looks at wasInterrupted() many times a second and keeps what it has. More signals are the
// same wish: `timeout` sends two, GNU parallel three within half a second. Only a Ctrl-C more than a second
// after the first signal ends the process at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

bool wasInterrupted();
// By the first signal; kInterrupted where there was none.
ExitCode interruptCode();

}  // namespace lavaray
