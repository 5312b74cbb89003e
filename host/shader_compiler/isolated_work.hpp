#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>

namespace lavaray {

// Work that may end the process that does it, as a compiler with a defect does: each piece of it is done in a
// process of its own.
//
// A process forked from one with several threads has only the forking one, and whatever the others had locked
// stays locked. So these processes are forked from a server, which is forked before there are threads; it is
// idle between the requests, and ends with this object or with the process that made it, however that ends.
class IsolatedWork {
 public:
  using Send = std::function<void(std::string_view)>;
  using Work = std::function<void(const std::string& request, const Send& send)>;
  struct Result {
    std::string sent;     // up to the end of the work, however it ended
    std::string failure;  // how it ended, in a few words, where it did not return; otherwise empty
  };

  // `prepare` is run once, by the server, for all pieces of work. To be called by the main thread, as the
  // server ends with the thread that makes it. Throws std::system_error where the system has no process left.
  IsolatedWork(const std::function<void()>& prepare, const Work& work);
  ~IsolatedWork();
  IsolatedWork(const IsolatedWork&) = delete;
  IsolatedWork& operator=(const IsolatedWork&) = delete;

  // Waits for it. Work that prints anything prints it to nowhere. Not for several threads at a time.
  Result run(const std::string& request);

 private:
  int socket_ = -1;
  pid_t server_ = -1;
  std::string serverFailure_;
};

}  // namespace lavaray
