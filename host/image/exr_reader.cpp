#include "image/exr_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <OpenEXRConfig.h>
#if OPENEXR_VERSION_MAJOR > 3 || OPENEXR_VERSION_MINOR >= 3
#include <ImfContextInit.h>
#endif

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "image/color_spaces.hpp"
#include "image/exr_common.hpp"

namespace lavaray {
namespace {

class Stream : public Imf::IStream {
 public:
  explicit Stream(const EncodedImage& file) : IStream(file.file.c_str()), bytes_(file.bytes) {}
  bool read(char target[], int count) override {
    if (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size() - std::min(at_, bytes_.size())) {
      throw Iex::InputExc("it ends early");
    }
    std::memcpy(target, bytes_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = position; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

// An upper bound on the bytes of pixels that one byte of a file can stand for. ZIP's limit is 1032 on 32-bit
// floats, and the others' are below 1400, except for DWA and whatever OpenEXR may yet add.
std::uint64_t maxBytesPerByte(Imf::Compression compression) {
  return compression <= Imf::B44A_COMPRESSION ? 2000 : 100000;
}

std::string listed(const Imf::ChannelList& channels) {
  std::string names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    names += (names.empty() ? "" : ", ") + printable(channel.name());
  }
  return names.empty() ? "none" : names;
}

// OpenEXR itself would refuse these files without a helpful reason.
void checkKind(const EncodedImage& file, Stream& stream) {
  bool isTiled = false;
  bool isDeep = false;
  bool hasParts = false;
  if (!Imf::isOpenExrFile(stream, isTiled, isDeep, hasParts)) file.fail("is no EXR image");
  if (isDeep) file.fail("is a deep EXR image, with several samples a pixel; only flat ones are read");
  if (hasParts) file.fail("is an EXR image of several parts; only those of one part are read");
}

// Returns whether the image is grey.
bool checkChannels(const EncodedImage& file, const Imf::Header& header) {
  const Imf::ChannelList& channels = header.channels();
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  const bool isColor = std::ranges::all_of(kExrColors, has);
  const bool isGrey = !isColor && has(kExrGrey) && !has("RY") && !has("BY");  // else luminance and chroma
  if (!isColor && !isGrey) {
    file.fail("its channels are " + listed(channels) + "; only EXR images of R, G, B or of Y are read");
  }
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
      file.fail("its channel " + printable(channel.name()) +
                " has not all pixels; only whole channels are read");
    }
  }
  return isGrey;
}

// Fails if the file cannot hold so many pixels, before any memory is allocated for them.
void checkSize(const EncodedImage& file, const Imf::Header& header) {
  const Imath::Box2i& data = header.dataWindow();
  if (data != header.displayWindow()) {
    file.fail(
        "its pixels are not those of the picture that it shows, but more, fewer or others (data window and "
        "display window differ); `oiiotool IN.exr --croptofull -o OUT.exr` makes them agree");
  }
  const std::uint64_t pixels =
      (std::uint64_t(data.max.x) - data.min.x + 1) * (std::uint64_t(data.max.y) - data.min.y + 1);
  std::uint64_t bytes = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    bytes += channel.channel().type == Imf::HALF ? 2 : 4;
  }
  if (pixels * bytes / maxBytesPerByte(header.compression()) <= file.bytes.size()) return;
  file.fail("is damaged: " + std::to_string(file.bytes.size()) + " bytes cannot hold " +
            std::to_string(pixels) + " pixels");
}

// OpenEXR 3.3 and later would print errors as well as throw them.
Imf::InputFile open(const EncodedImage& file, Stream& stream) {
#if OPENEXR_VERSION_MAJOR > 3 || OPENEXR_VERSION_MINOR >= 3
  const auto ignore = [](exr_const_context_t, exr_result_t, const char*) {};
  return {file.file.c_str(), Imf::ContextInitializer().setErrorHandler(ignore).setInputStream(&stream),
          kNoExrThreads};
#else
  (void)file;
  return {stream, kNoExrThreads};
#endif
}

void readPixels(Imf::InputFile& input, bool isGrey, Image& image) {
  const Imath::Box2i& window = input.header().dataWindow();
  constexpr std::size_t kPixel = 3 * sizeof(float);
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < (isGrey ? 1 : 3); ++i) {
    frame.insert(isGrey ? kExrGrey : kExrColors[i],
                 Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + i, window, kPixel, kPixel * image.width));
  }
  if (input.header().channels().findChannel("A") != nullptr) {
    image.alpha.resize(image.rgb.size() / 3);
    frame.insert("A", Imf::Slice::Make(Imf::FLOAT, image.alpha.data(), window));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  for (std::size_t i = 0; isGrey && i < image.rgb.size(); ++i) image.rgb[i] = image.rgb[i / 3 * 3];
}

// In EXR, colours are linear light and premultiplied by alpha.
void toDisplay(Image& image) {
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double alpha = image.alpha.empty() ? 1.0 : double{image.alpha[i / 3]};
    const double light = double{image.rgb[i]} / (alpha > 0.0 ? alpha : 1.0);
    image.rgb[i] = static_cast<float>(srgbFromLinear(light));
  }
}

TextEntries textsOf(const Imf::Header& header) {
  TextEntries texts;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    const bool isText = text != nullptr && std::string_view(attribute.name()) != "type";  // the file's kind
    if (isText) texts.emplace_back(attribute.name(), text->value());
  }
  return texts;
}

Image read(const EncodedImage& file) {
  Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
  Stream stream(file);
  checkKind(file, stream);
  stream.seekg(0);
  Imf::InputFile input = open(file, stream);
  const Imf::Header& header = input.header();
  const bool isGrey = checkChannels(file, header);
  checkSize(file, header);
  const Imath::Box2i& window = header.dataWindow();
  Image image = file.blankImage(std::int64_t{window.max.x} - window.min.x + 1,
                                std::int64_t{window.max.y} - window.min.y + 1);
  readPixels(input, isGrey, image);
  image.source.texts = textsOf(header);
  const bool isLayer = header.findTypedAttribute<Imf::StringAttribute>(kExrLayer) != nullptr;
  if (!isLayer) toDisplay(image);
  image.source.notes.push_back(std::string(isLayer
                                               ? "holds the numbers of a layer, which are taken as they are"
                                               : "holds linear light, which is taken as a display shows it") +
                               (isGrey ? "; its one channel Y is grey" : ""));
  return image;
}

}  // namespace

Image readExr(const EncodedImage& file) {
  try {
    return read(file);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // of several kinds
    file.fail("is no EXR image or is damaged: " + reasonOf(error));
  }
}

}  // namespace lavaray
