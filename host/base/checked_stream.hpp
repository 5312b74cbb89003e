#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>

namespace lavaray {

// A stream that writes to a descriptor and remembers why a write failed, which a plain FILE forgets.
class CheckedStream {
 public:
  // The caller keeps ownership of the descriptor. Throws std::system_error.
  explicit CheckedStream(int descriptor);
  ~CheckedStream();
  CheckedStream(const CheckedStream&) = delete;
  CheckedStream& operator=(const CheckedStream&) = delete;

  [[nodiscard]] std::FILE* get() const { return stream_; }
  // Writes what is buffered. Returns why anything so far could not be written; empty if all of it was.
  std::string flush();

 private:
  struct Target {
    int descriptor;
    int error;
  };
  static ssize_t write(void* cookie, const char* bytes, std::size_t size);
  static int seek(void* cookie, off64_t* offset, int whence);

  std::unique_ptr<Target> target_;
  std::FILE* stream_;
};

}  // namespace lavaray
