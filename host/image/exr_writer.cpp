#include "image/exr_writer.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include "base/errors.hpp"
#include "image/color_spaces.hpp"
#include "image/exr_common.hpp"

namespace lavaray {
namespace {

// Lets OpenEXR write to a C stream. The stream remembers a failed write for its owner.
class Stream : public Imf::OStream {
 public:
  explicit Stream(std::FILE* stream) : OStream("the image"), stream_(stream) {}
  void write(const char bytes[], int count) override {
    (void)!std::fwrite(bytes, 1, static_cast<std::size_t>(count), stream_);
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(ftello(stream_)); }
  void seekp(std::uint64_t position) override {
    (void)fseeko(stream_, static_cast<off_t>(position), SEEK_SET);
  }

 private:
  std::FILE* stream_;
};

// OpenEXR throws exceptions of several types.
template <typename Body>
void writing(const Body& body) {
  try {
    body();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ExitCode::kOutput, "the image cannot be written: " + reasonOf(error));
  }
}

// The float nearest to the linear light. Near black, floats are too far apart for every value to survive a
// round trip, but one that would come back as another 8-bit level moves to the neighbouring float, which does
// not.
float linearLight(float color) {
  constexpr float kMayMove = 1.0F / 16.0F;
  const auto linear = static_cast<float>(linearFromSrgb(double{color}));
  if (!(color > 0.0F && color < kMayMove)) return linear;
  const auto back = static_cast<float>(srgbFromLinear(double{linear}));
  return toByte(back) == toByte(color) ? linear : std::nextafter(linear, back < color ? 1.0F : 0.0F);
}

Imf::Header makeHeader(int width, int height, std::size_t channels, Imf::PixelType type,
                       const TextEntries& texts) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  if (channels == 1) {
    header.channels().insert(kExrGrey, Imf::Channel(type));
  } else {
    for (const char* name : kExrColors) header.channels().insert(name, Imf::Channel(type));
  }
  for (const auto& [keyword, text] : texts) header.insert(keyword, Imf::StringAttribute(text));
  return header;
}

}  // namespace

struct ExrWriter::File {
  File(const Imf::Header& header, std::size_t channels, Imf::PixelType pixelType, std::FILE* target)
      : stream(target), type(pixelType) {
    const std::size_t values = channels * static_cast<std::size_t>(header.dataWindow().max.x + 1);
    const std::size_t size = type == Imf::HALF ? sizeof(half) : sizeof(float);
    if (type == Imf::HALF) {
      halves.resize(values);
    } else {
      floats.resize(values);
    }
    char* bytes =
        type == Imf::HALF ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(floats.data());
    output.emplace(stream, header, kNoExrThreads);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < channels; ++i) {
      // A stride of 0: every row is taken from the same buffer.
      frame.insert(channels == 1 ? kExrGrey : kExrColors[i],
                   Imf::Slice(type, bytes + i * size, channels * size, 0));
    }
    output->setFrameBuffer(frame);
  }

  Stream stream;
  Imf::PixelType type;
  // The row being filled, in whichever of the two has the precision.
  std::vector<float> floats;
  std::vector<half> halves;
  std::size_t filled = 0;
  std::optional<Imf::OutputFile> output;  // refers to the stream and the row
};

ExrWriter::ExrWriter(int width, int height, std::size_t channels, Precision precision,
                     const TextEntries& texts, std::FILE* stream) {
  writing([&] {
    const Imf::PixelType type = precision == Precision::kHalf ? Imf::HALF : Imf::FLOAT;
    file_ = std::make_unique<File>(makeHeader(width, height, channels, type, texts), channels, type, stream);
  });
}

ExrWriter::~ExrWriter() = default;

void ExrWriter::put(float value) {
  std::size_t row = 0;
  if (file_->type == Imf::HALF) {
    file_->halves[file_->filled++] = half(value);
    row = file_->halves.size();
  } else {
    file_->floats[file_->filled++] = value;
    row = file_->floats.size();
  }
  if (file_->filled < row) return;
  writing([&] { file_->output->writePixels(1); });
  file_->filled = 0;
}

void ExrWriter::writeNumbers(std::span<const float> values) {
  for (const float value : values) put(value);
}

void ExrWriter::writeColors(std::span<const float> values) {
  for (const float value : values) put(linearLight(value));
}

void ExrWriter::finish() {
  // Destroying it goes back and writes the rows' offsets; only the stream knows if that fails.
  file_->output.reset();
}

}  // namespace lavaray
