#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>

#include "image/image.hpp"

namespace lavaray {

// Writes an EXR file row by row from the top: scan lines with ZIP compression and the channels R, G, B, or
// the single channel Y, which by that name most readers take for grey. The texts become header attributes.
// With 32-bit floats a colour keeps its 8-bit level.
class ExrWriter {
 public:
  enum class Precision { kFloat, kHalf };

  // `channels` is 1 or 3. The stream must be seekable. Throws Error(kOutput) if OpenEXR refuses; whether
  // everything was written is for the stream's owner to check.
  ExrWriter(int width, int height, std::size_t channels, Precision precision, const TextEntries& texts,
            std::FILE* stream);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  // Takes the next values, with all channels of a pixel side by side and in pieces of any size, unchanged.
  void writeNumbers(std::span<const float> values);
  // The same for colours, which become linear light.
  void writeColors(std::span<const float> values);
  void finish();

 private:
  struct File;
  void put(float value);

  std::unique_ptr<File> file_;
};

}  // namespace lavaray
