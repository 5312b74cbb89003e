#pragma once

#include <lavaray/renderer.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lavaray {

// The command line as it applies to one of its scenes, checked as far as possible without reading the scene.
struct Options {
  std::filesystem::path scene;  // or "-" for standard input
  // A path, or "-" for PPM to stdout; with the ending .film the film in place of a picture.
  std::string output;
  RenderOptions render;        // but for the shader, and what depends on the scene
  bool statesSamples = false;  // whether --spp is given
  bool half = false;
  std::vector<Layer> layers;
  Defaults defaults;
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

// Whether --output is a film, not a picture.
bool writesFilm(const Options& options);

// The files that are to be written.
std::vector<OutputName> outputNames(const Options& options);
// The one of them that may replace the film that is resumed from.
OutputName checkpointName(const Options& options);

// The target error of a picture that neither --spp nor --target-error says anything about, where one sample
// per pixel would be noise: that of spherical lights, by colour.
std::optional<double> defaultTargetError(const Options& options, const SceneSummary& scene);

}  // namespace lavaray
