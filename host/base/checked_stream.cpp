#include "base/checked_stream.hpp"

#include <stdio_ext.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace lavaray {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18U;

}  // namespace

CheckedStream::CheckedStream(int descriptor) : target_(std::make_unique<Target>(descriptor, 0)) {
  cookie_io_functions_t functions{};
  functions.write = write;
  functions.seek = seek;
  stream_ = fopencookie(target_.get(), "wb", functions);
  if (stream_ == nullptr) throw std::system_error(errno, std::generic_category());
  std::setvbuf(stream_, nullptr, _IOFBF, kBufferBytes);
  // Only one thread writes: locking the stream for every call would only take time.
  __fsetlocking(stream_, FSETLOCKING_BYCALLER);
}

CheckedStream::~CheckedStream() {
  std::fclose(stream_);
}

std::string CheckedStream::flush() {
  const bool isWritten = std::fflush(stream_) == 0 && std::ferror(stream_) == 0;
  if (target_->error != 0) return std::strerror(target_->error);
  return isWritten ? "" : "a write failed";
}

// To the stream, a result of 0 is an error.
ssize_t CheckedStream::write(void* cookie, const char* bytes, std::size_t size) {
  Target& target = *static_cast<Target*>(cookie);
  std::size_t done = 0;
  while (done < size && target.error == 0) {
    const ssize_t count = ::write(target.descriptor, bytes + done, size - done);
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) target.error = errno;
  }
  return static_cast<ssize_t>(done);
}

int CheckedStream::seek(void* cookie, off64_t* offset, int whence) {
  *offset = lseek64(static_cast<Target*>(cookie)->descriptor, *offset, whence);
  return *offset < 0 ? -1 : 0;
}

}  // namespace lavaray
