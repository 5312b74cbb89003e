#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "image/image.hpp"
#include "render/layer.hpp"
#include "render/settings.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The command line for one of its scenes, checked as far as that goes without reading the scene.
struct Options {
  std::filesystem::path scene;  // or "-" for standard input
  // A path, or "-" for PPM to stdout; with the ending .film the film in place of a picture.
  std::string output;
  std::optional<int> width;
  std::optional<int> height;
  std::optional<Rectangle> crop;
  bool normalize = false;
  RenderSettings render;  // but for what depends on the scene: size, crop, shader, what is kept and counted
  bool half = false;
  std::vector<Layer> layers;
  double reflect = 0.0;
  double lightRadius = 0.0;
  std::string device;
  bool listDevices = false;
  bool check = false;
  bool validate = false;
  bool stats = false;
  std::string json;               // a path, or empty
  std::filesystem::path shaders;  // a folder, or empty
  bool watch = false;
  bool display = false;
  std::filesystem::path checkpoint;  // or empty
  double checkpointSeconds = 60.0;
  std::filesystem::path resume;  // or empty
  bool quiet = false;
  bool verbose = false;
};

// One for each scene, or one without a scene for --list-devices; they differ in the files that they name
// only. Empty where the command line asked for help or the version, which are printed then. Throws
// Error(kUsage).
std::vector<Options> parseOptions(int argc, const char* const* argv);

// `options` for each of the scenes, of which there is one at least, with their own names of files: `{}`
// stands for a scene's name. Throws Error(kUsage) where two files would be one.
std::vector<Options> optionsOfScenes(const Options& options, const std::vector<std::string>& scenes);

// The size of the image: the camera's, or the one asked for, where a missing side keeps the camera's aspect.
// Throws Error(kUsage) where a side is out of range.
ImageSize outputSize(const Options& options, const ImageSize& cameraSize);

bool writesFilm(const Options& options);  // in place of a picture

// The files that are to be written.
std::vector<OutputName> outputNames(const Options& options);
// The one among them that may take the place of the film that is resumed from.
OutputName checkpointName(const Options& options);

// Gives materials and lights that say nothing of it the reflectance and the radius that the options ask for.
void applyDefaults(const Options& options, Scene& scene);

}  // namespace lavaray
