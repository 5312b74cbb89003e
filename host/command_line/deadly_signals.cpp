#include "command_line/deadly_signals.hpp"

#include <lavaray/files.h>
#include <array>
#include <csignal>
#include <cstdlib>

namespace lavaray {
namespace {

// All signals that end a process by default, except SIGKILL and those of interrupt.hpp and
// file_size_limit.hpp.
constexpr std::array kDeadly = {SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,   SIGFPE,  SIGUSR1, SIGSEGV,   SIGUSR2,
                                SIGALRM, SIGXCPU, SIGPROF, SIGVTALRM, SIGPOLL, SIGPWR,  SIGSTKFLT, SIGSYS};
std::array<struct sigaction, NSIG> before{};  // by signal

// Hands over to the former handler, a sanitizer's or the system's own: when this returns, a faulty access is
// repeated; a signal that another process has sent is sent again here.
void onDeadlySignal(int signal, siginfo_t* info, void* /*context*/) {
  removeTemporaryFiles();
  sigaction(signal, &before[static_cast<std::size_t>(signal)], nullptr);
  const bool isRepeated = info->si_code > 0 && (signal == SIGSEGV || signal == SIGILL || signal == SIGFPE);
  if (!isRepeated) raise(signal);
}

}  // namespace

void cleanUpAtDeath() {
  struct sigaction action {};
  action.sa_sigaction = onDeadlySignal;
  action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK);
  const auto handle = [&](int signal) {
    struct sigaction& old = before[static_cast<std::size_t>(signal)];
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  };
  for (const int signal : kDeadly) handle(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) handle(signal);
  std::signal(SIGPIPE, SIG_IGN);
  std::atexit(removeTemporaryFiles);
  std::at_quick_exit(removeTemporaryFiles);
}

}  // namespace lavaray
