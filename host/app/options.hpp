#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/camera.hpp"
#include "image/image.hpp"

namespace lavaray {

// The command line, checked as far as that goes without reading the scene.
struct Options {
  std::filesystem::path scene;
  std::string output;  // a path, or "-" for PPM to stdout
  std::optional<int> width;
  std::optional<int> height;
  std::optional<Rectangle> crop;
  bool normalize = false;
  int maxDepth = 8;
  std::string device;
  bool listDevices = false;
  bool check = false;
  bool validate = false;
  bool stats = false;
  bool quiet = false;
  bool verbose = false;
};

// Nothing where the command line asked for help or the version, which are printed then. Throws Error(kUsage).
std::optional<Options> parseOptions(int argc, const char* const* argv);

// The size of the image: the camera's, or the one asked for, where a missing side keeps the camera's aspect.
// Throws Error(kUsage) where a side or the crop is out of range.
ImageSize outputSize(const Options& options, const ImageSize& cameraSize);

// The part of an image of `size` to render. Throws Error(kUsage) where it is not inside.
Rectangle outputCrop(const Options& options, const ImageSize& size);

}  // namespace lavaray
