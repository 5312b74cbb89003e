#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <system_error>

#include "base/errors.hpp"

namespace lavaray {

// Reads a file's bytes in order. Throws std::system_error with the system's reason if it cannot.
class ByteReader {
 public:
  explicit ByteReader(const std::filesystem::path& file);
  // Takes ownership of a stream that was just opened; null if that failed, with the reason in errno.
  explicit ByteReader(std::FILE* stream);
  // Returns how many bytes it filled: all of them, or as many as were left.
  std::size_t read(std::span<char> bytes);

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Close> stream_;
};

// Appends whatever the reader has left to `beginning`. `size` is about how many bytes that is, where known.
std::string readAll(ByteReader& reader, std::string beginning = {}, std::size_t size = 0);

// The bytes of a file. Throws std::system_error with the system's reason if it cannot be read.
std::string readFile(const std::filesystem::path& file);

// A hint for readAll, 0 if unknown: a pipe has no size.
std::size_t expectedSize(const std::filesystem::path& file);

// A file that is missing or cannot be read.
class UnreadableFile : public Error {
  using Error::Error;
};

// `file: cannot be read: reason`.
std::string unreadableText(const std::filesystem::path& file, const std::string& reason);
// Throw UnreadableFile with that message.
[[noreturn]] void failUnreadable(const std::filesystem::path& file, const std::string& reason);
[[noreturn]] void failUnreadable(const std::filesystem::path& file, const std::system_error& error);

}  // namespace lavaray
