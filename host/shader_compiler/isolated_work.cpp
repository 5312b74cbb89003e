#include "shader_compiler/isolated_work.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

namespace lavaray {
namespace {

// Exit codes; not 0, since work that ends its process may call that a success.
constexpr int kFinished = 40;
constexpr int kNoMemory = 41;
constexpr int kException = 42;

using Sockets = std::array<int, 2>;

bool connect(Sockets& ends) {
  return socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
}

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// These two return whether all was sent or received; false where the other end is gone.
bool sendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool receiveAll(int socket, char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t count = recv(socket, bytes, size, 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count > 0) {
      bytes += count;
      size -= static_cast<std::size_t>(count);
    }
  }
  return true;
}

bool sendMessage(int socket, const std::string& text) {
  const std::uint64_t size = text.size();
  return sendAll(socket, {reinterpret_cast<const char*>(&size), sizeof size}) && sendAll(socket, text);
}

std::optional<std::string> receiveMessage(int socket) {
  std::uint64_t size = 0;
  if (!receiveAll(socket, reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
  std::string text(size, '\0');
  if (!receiveAll(socket, text.data(), text.size())) return std::nullopt;
  return text;
}

std::string receiveToEnd(int socket) {
  std::string text;
  std::array<char, 1U << 16U> part;
  for (;;) {
    const ssize_t count = recv(socket, part.data(), part.size(), 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
    if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
  }
}

std::string waitFor(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return "its process is gone";
  }
  if (WIFSIGNALED(status)) {
    const char* name = sigdescr_np(WTERMSIG(status));
    std::string text = name == nullptr ? "unknown signal" : name;
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
  }
  const int code = WEXITSTATUS(status);
  return code == kFinished ? "" : code == kNoMemory ? "out of memory" : "it gave up";
}

// As fork(). The child ends with its parent but not with a Ctrl-C: that reaches the program, too, which may
// want to write what it has.
pid_t forkChild() {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  const pid_t parent = getpid();
  const pid_t child = fork();
  const int reason = errno;
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(kException);  // the parent ended before the line above
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    for (const int signal : {SIGBUS, SIGXFSZ, SIGCHLD}) std::signal(signal, SIG_DFL);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  errno = reason;
  return child;
}

[[noreturn]] void doWork(const IsolatedWork::Work& work, const std::string& request, int socket) {
  if (const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  try {
    work(request, [&](std::string_view bytes) {
      if (!sendAll(socket, bytes)) _exit(kException);
    });
    _exit(kFinished);
  } catch (const std::bad_alloc&) {
    _exit(kNoMemory);
  } catch (...) {
    _exit(kException);
  }
}

IsolatedWork::Result runOnce(const IsolatedWork::Work& work, const std::string& request) {
  Sockets ends{};
  if (!connect(ends)) return {{}, std::strerror(errno)};
  const pid_t worker = forkChild();
  if (worker == 0) {
    close(ends[0]);
    doWork(work, request, ends[1]);
  }
  const int reason = errno;
  close(ends[1]);
  IsolatedWork::Result result{{}, std::strerror(reason)};
  if (worker > 0) {
    result.sent = receiveToEnd(ends[0]);
    result.failure = waitFor(worker);
  }
  close(ends[0]);
  return result;
}

[[noreturn]] void serve(int socket, const std::function<void()>& prepare, const IsolatedWork::Work& work) {
  try {
    prepare();
    while (const std::optional<std::string> request = receiveMessage(socket)) {
      const IsolatedWork::Result result = runOnce(work, *request);
      if (!sendMessage(socket, result.failure) || !sendMessage(socket, result.sent)) break;
    }
    _exit(kFinished);
  } catch (const std::bad_alloc&) {
    _exit(kNoMemory);
  } catch (...) {
    _exit(kException);
  }
}

}  // namespace

IsolatedWork::IsolatedWork(const std::function<void()>& prepare, const Work& work) {
  Sockets ends{};
  if (!connect(ends)) fail("socketpair");
  server_ = forkChild();
  if (server_ == 0) {
    close(ends[0]);
    serve(ends[1], prepare, work);
  }
  const int reason = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (server_ > 0) return;
  close(socket_);
  errno = reason;
  fail("fork");
}

IsolatedWork::~IsolatedWork() {
  shutdown(socket_, SHUT_RDWR);  // Closing is not enough where another process has the socket, too.
  close(socket_);
  if (server_ > 0) waitFor(server_);
}

IsolatedWork::Result IsolatedWork::run(const std::string& request) {
  if (sendMessage(socket_, request)) {
    std::optional<std::string> failure = receiveMessage(socket_);
    std::optional<std::string> sent = failure ? receiveMessage(socket_) : std::nullopt;
    if (sent) return {std::move(*sent), std::move(*failure)};
  }
  if (server_ > 0) serverFailure_ = waitFor(std::exchange(server_, -1));
  return {{}, serverFailure_};
}

}  // namespace lavaray
