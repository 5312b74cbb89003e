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

// The command line as it applies to one of its scenes, checked as far as possible without reading the scene.
struct Options {
  std::filesystem::path scene;  // or "-" for standard input
  // A path, or "-" for PPM to stdout; with the ending .film the film in place of a picture.
  std::string output;
  std::optional<int> width;
  std::optional<int> height;
  std::optional<Rectangle> crop;
  bool normalize = false;
  RenderSettings render;  // but for what depends on the scene: size, crop, shader, what is kept and counted
  bool statesSamples = false;  // whether --spp is given
  bool half = false;
  std::vector<Layer> layers;
  double reflect = 0.0;
  double lightRadius = 0.0;
  std::string device;
  std::string tuning = "auto";
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

// One for each scene, or one without a scene for --list-devices. They differ only in the files that they
// name. Empty if the command line asked for help or the version, which have been printed then. Throws
// Error(kUsage).
std::vector<Options> parseOptions(int argc, const char* const* argv);

// `options` for each of the scenes, at least one, with its own names of files, where `{}` stands for the
// scene's name. Throws Error(kUsage) if two files would be one.
std::vector<Options> optionsOfScenes(const Options& options, const std::vector<std::string>& scenes);

// The size of the image: the camera's, or what was asked for; if only one side was, the other keeps the
// camera's aspect. Throws Error(kUsage) if a side is out of range.
ImageSize outputSize(const Options& options, const ImageSize& cameraSize);

// Whether --output is a film, not a picture.
bool writesFilm(const Options& options);

// The files that are to be written.
std::vector<OutputName> outputNames(const Options& options);
// The one of them that may replace the film that is resumed from.
OutputName checkpointName(const Options& options);

// The target error of a picture that neither --spp nor --target-error says anything about, where one sample
// per pixel would be noise: that of spherical lights, by colour.
std::optional<double> defaultTargetError(const Options& options, const Scene& scene);

// Gives the options' reflectance and radius to materials and lights that state none.
void applyDefaults(const Options& options, Scene& scene);

}  // namespace lavaray
