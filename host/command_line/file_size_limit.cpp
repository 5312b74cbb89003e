#include "command_line/file_size_limit.hpp"

#include <lavaray/files.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace lavaray {
namespace {

std::string message;  // made in advance, as a signal handler cannot
std::atomic<bool> wasLimitMet{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void onFileTooLarge(int /*signal*/) {
  wasLimitMet = true;
}

// That is the reason only if a file could not grow before. Otherwise the access is repeated without this
// handler, and ends the process as it would have; a signal that another process has sent is sent again.
void onBusError(int signal, siginfo_t* info, void* /*context*/) {
  removeTemporaryFiles();
  if (!wasLimitMet || info->si_code != BUS_ADRERR) {
    std::signal(signal, SIG_DFL);
    if (info->si_code <= 0) raise(signal);
    return;
  }
  (void)!write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(ErrorKind::kMemory));
}

}  // namespace

void surviveFileSizeLimit(const std::string& programName) {
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  message =
      programName + ": the driver keeps its memory in a file, and files may have at most " +
      std::to_string(limit.rlim_cur) +
      " bytes here, which is too little; raise that limit (ulimit -f), or render a smaller scene or image\n";
  struct sigaction tooLarge {};
  tooLarge.sa_handler = onFileTooLarge;
  tooLarge.sa_flags = SA_RESTART;
  sigaction(SIGXFSZ, &tooLarge, nullptr);
  struct sigaction busError {};
  busError.sa_sigaction = onBusError;
  busError.sa_flags = SA_SIGINFO;
  sigaction(SIGBUS, &busError, nullptr);
}

}  // namespace lavaray
