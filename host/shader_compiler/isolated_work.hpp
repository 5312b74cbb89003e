#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>

namespace lavaray {

// Runs work that may end its process, as a compiler with a defect does: each request is handled in a process
// of its own.
//
// A fork of a process with several threads has only the forking thread, and whatever the others had locked
// stays locked. So the work's processes are forked from a server, which itself is forked before there are
// threads. The server is idle between requests; it ends with this object or with the process that made it,
// however that ends.
class IsolatedWork {
 public:
  using Send = std::function<void(std::string_view)>;
  using Work = std::function<void(const std::string& request, const Send& send)>;
  struct Result {
    std::string sent;     // up to the end of the work, however it ended
    std::string failure;  // in a few words, how the work ended where it did not return; otherwise empty
  };

  // The server runs `prepare` once, for all requests. The main thread has to call this, since the server ends
  // with the thread that makes it. Throws std::system_error where the system has no process left.
  IsolatedWork(const std::function<void()>& prepare, const Work& work);
  ~IsolatedWork();
  IsolatedWork(const IsolatedWork&) = delete;
  IsolatedWork& operator=(const IsolatedWork&) = delete;

  // Does the work and waits for it; what the work prints goes nowhere. For one thread at a time.
  Result run(const std::string& request);

  // False once a request has found the server gone.
  [[nodiscard]] bool isServing() const { return server_ > 0; }

 private:
  int socket_ = -1;
  pid_t server_ = -1;
  std::string serverFailure_;
};

}  // namespace lavaray
