// Prints what the image readers make of files: `image_values FILE...`. For each file that is a line
// `WIDTH HEIGHT FORMAT MAXIMUM... CHANNELS` and then the pixels, as floats in the machine's order of bytes,
// the colours of all before their alphas; or a line `refused MESSAGE`.
#include <cstdint>
#include <iostream>
#include <iterator>
#include <vector>

#include "base/errors.hpp"
#include "image/image_reader.hpp"

namespace {

void print(const std::vector<float>& values) {
  std::cout.write(reinterpret_cast<const char*>(values.data()), std::ssize(values) * 4);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    try {
      const lavaray::Image image = lavaray::readImage(argv[i]);
      std::cout << image.width << ' ' << image.height << ' ' << image.source.format;
      for (const std::uint32_t maximum : image.source.maxima) std::cout << ' ' << maximum;
      std::cout << ' ' << (image.alpha.empty() ? 3 : 4) << '\n';
      print(image.rgb);
      print(image.alpha);
    } catch (const lavaray::Error& error) {
      std::cout << "refused " << error.what() << '\n';
    }
  }
  return std::cout.flush() ? 0 : 1;
}
