#include "command_line/interrupt.hpp"

#include <lavaray/files.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

namespace lavaray {
namespace {

constexpr std::int64_t kPatienceNanoseconds = 1'000'000'000;

// All that the signal handler uses, which any thread may run, several at a time.
std::string messageBegin;  // made in advance, as a signal handler cannot
std::atomic<const char*> interruptedText{"interrupted before anything was written\n"};
std::atomic<int> guards{0};
std::atomic<std::int64_t> firstTime{0};
std::atomic<int> firstSignal{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may set it");

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void say(const char* text) {
  (void)!write(STDERR_FILENO, text, std::strlen(text));
}

[[noreturn]] void endAtOnce(int signal, const char* text) {
  removeTemporaryFiles();
  say(messageBegin.c_str());
  say(text);
  _exit(128 + signal);
}

void onSignal(int signal) {
  const int before = errno;
  const std::int64_t time = now();
  std::int64_t none = 0;
  firstTime.compare_exchange_strong(none, time);
  int noSignal = 0;
  firstSignal.compare_exchange_strong(noSignal, signal);
  if (guards == 0) endAtOnce(signal, interruptedText);
  if (signal == SIGINT && time - firstTime > kPatienceNanoseconds)
    endAtOnce(signal, "interrupted again: what was rendered is lost\n");
  errno = before;
}

}  // namespace

void catchInterrupts(const std::string& programName) {
  // A terminal may be showing the progress bar.
  messageBegin = (isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "") + programName + ": ";
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hangUp {};
  sigaction(SIGHUP, nullptr, &hangUp);
  if (hangUp.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

void setInterruptedText(const char* text) {
  interruptedText = text;
}

InterruptGuard::InterruptGuard() {
  ++guards;
}

InterruptGuard::~InterruptGuard() {
  --guards;
}

bool wasInterrupted() {
  return firstSignal != 0;
}

int interruptCode() {
  const int signal = firstSignal;
  return 128 + (signal != 0 ? signal : SIGINT);
}

void throwInterrupted(const std::string& message) {
  // An enumeration of int, of which only the values of the library have names.
  throw Error(static_cast<ErrorKind>(interruptCode()), message);
}

}  // namespace lavaray
