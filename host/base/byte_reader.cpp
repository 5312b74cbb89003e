#include "base/byte_reader.hpp"

#include <cerrno>
#include <utility>

#include "base/file_claims.hpp"
#include "base/printable.hpp"

namespace lavaray {
namespace {

[[noreturn]] void throwSystemError() {
  throw std::system_error(errno, std::generic_category());
}

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& file) {
  noteRead(file);
  stream_.reset(std::fopen(file.c_str(), "rb"));
  if (!stream_) throwSystemError();
}

ByteReader::ByteReader(std::FILE* stream) : stream_(stream) {
  if (!stream_) throwSystemError();
}

std::size_t ByteReader::read(std::span<char> bytes) {
  const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), stream_.get());
  if (count < bytes.size() && std::ferror(stream_.get()) != 0) throwSystemError();
  return count;
}

std::string readAll(ByteReader& reader, std::string beginning, std::size_t size) {
  constexpr std::size_t kChunk = 1 << 16;
  std::string bytes = std::move(beginning);
  std::size_t length = bytes.size();
  bytes.reserve(length + size + kChunk);
  for (;;) {
    bytes.resize(length + kChunk);
    const std::size_t count = reader.read(std::span(bytes).subspan(length, kChunk));
    length += count;
    if (count < kChunk) break;
  }
  bytes.resize(length);
  return bytes;
}

std::string readFile(const std::filesystem::path& file) {
  ByteReader reader(file);
  return readAll(reader, {}, expectedSize(file));
}

std::size_t expectedSize(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  return unknown ? 0 : static_cast<std::size_t>(size);
}

std::string unreadableText(const std::filesystem::path& file, const std::string& reason) {
  return printable(file.native()) + ": cannot be read: " + reason;
}

void failUnreadable(const std::filesystem::path& file, const std::string& reason) {
  throw UnreadableFile(ExitCode::kInput, unreadableText(file, reason), file.string());
}

void failUnreadable(const std::filesystem::path& file, const std::system_error& error) {
  failUnreadable(file, error.code().message());
}

}  // namespace lavaray
