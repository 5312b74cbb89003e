#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>

#include "image/image.hpp"

namespace lavaray {

// Writes an EXR file row by row from the top: scan lines, compressed by ZIP, channels R, G, B or one channel
// Y, by which name most readers take it for grey. The texts become attributes of its header. In 32 bits a
// colour keeps its 8-bit level.
class ExrWriter {
 public:
  enum class Precision { kFloat, kHalf };

  // One channel or three. Throws Error(kOutput) for what OpenEXR refuses; whether all was written is for the
  // owner of the stream, which can be sought in, to check.
  ExrWriter(int width, int height, std::size_t channels, Precision precision, const TextEntries& texts,
            std::FILE* stream);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  // The next values, all channels of a pixel side by side, in any division: numbers that are no colours.
  void writeNumbers(std::span<const float> values);
  // Likewise colours, which become linear light.
  void writeColors(std::span<const float> values);
  void finish();

 private:
  struct File;
  void put(float value);

  std::unique_ptr<File> file_;
};

}  // namespace lavaray
