#pragma once

#include <string>

namespace lavaray {

// From here on SIGHUP, SIGINT and SIGTERM end the process at once with exit code 128 + the signal's number, a
// message on stderr that begins with `programName`, and no temporary file left behind; or, while there is an
// InterruptGuard, they are only remembered. A SIGHUP that is ignored already stays ignored (nohup).
void catchInterrupts(const std::string& programName);

// What a signal that ends the process at once prints. The text must stay where it is.
void setInterruptedText(const char* text);

// For work that checks wasInterrupted() many times a second and keeps what it has. Further signals count as
// the same request: `timeout` sends two, GNU parallel three within half a second. Only Ctrl-C more than a
// second after the first signal ends the process at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

bool wasInterrupted();
// The exit code of the first signal, 128 and its number; that of Ctrl-C if there was none.
int interruptCode();
// Throws an Error with that exit code.
[[noreturn]] void throwInterrupted(const std::string& message);

}  // namespace lavaray
