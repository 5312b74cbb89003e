#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>

#include "film/film.hpp"

namespace lavaray {

// A film file: a line that names the format, the header as JSON with its length before it, the pixels row by
// row as in memory, the pending work items, and a checksum of all that.

// Writes a film to a stream: the header at once, then whatever write() is given, and with finish() the
// checksum. The owner of the stream checks whether everything was written.
class FilmWriter {
 public:
  FilmWriter(std::FILE* stream, const FilmHeader& header);
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  void write(std::span<const std::byte> bytes);
  void finish();

 private:
  struct Checksum;
  std::FILE* stream_;
  std::unique_ptr<Checksum> checksum_;
};

// An open film file. Throws Error(kInput), naming the file, if it is not a film, is damaged or ends early.
class FilmReader {
 public:
  // Reads the whole file once to verify its length and its checksum.
  explicit FilmReader(const std::filesystem::path& file);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const FilmHeader& header() const { return header_; }

  // Reads the pixels of row `row` of header().traced into `bytes`, which must be of their length.
  void readRow(int row, std::span<std::byte> bytes);
  // Likewise for all pixels, and for all pending work items.
  void readPixels(std::span<std::byte> bytes);
  void readItems(std::span<std::byte> bytes);

 private:
  [[noreturn]] void fail(const std::string& why) const;
  void readHeader();
  void verify();
  void readAt(std::uint64_t position, std::span<std::byte> bytes);
  [[nodiscard]] std::uint64_t pixelBytes() const;

  std::filesystem::path file_;
  std::FILE* stream_ = nullptr;
  FilmHeader header_;
  std::uint64_t pixelsBegin_ = 0;  // in the file
};

// Of a file's bytes, as text; for identities. Throws Error(kInput) where it cannot be read.
std::string checksumOfFile(const std::filesystem::path& file);
std::string checksumOf(std::span<const std::byte> bytes);

}  // namespace lavaray
