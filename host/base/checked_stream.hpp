#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>

namespace lavaray {

// A stream for writing to a descriptor that remembers why a write failed, which a FILE of the C library
// forgets.
class CheckedStream {
 public:
  // The descriptor stays the caller's. Throws std::system_error.
  explicit CheckedStream(int descriptor);
  ~CheckedStream();
  CheckedStream(const CheckedStream&) = delete;
  CheckedStream& operator=(const CheckedStream&) = delete;

  [[nodiscard]] std::FILE* get() const { return stream_; }
  // Writes what is left, and returns why not all of it could be written, or nothing.
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
