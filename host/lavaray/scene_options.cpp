// What the file names of the command line become for each of its scenes.
#include <map>
#include <utility>

#include "lavaray/options.hpp"
#include "lavaray/standard_input.hpp"

namespace lavaray {
namespace fs = std::filesystem;

namespace {

constexpr const char* kPlaceholder = "{}";

std::string filledIn(const std::string& pattern, const fs::path& scene) {
  const std::string name = fs::path(shownName(scene)).stem().string();
  std::string text;
  std::size_t begin = 0;
  for (std::size_t end; (end = pattern.find(kPlaceholder, begin)) != std::string::npos; begin = end + 2) {
    text += pattern.substr(begin, end - begin) + name;
  }
  return text + pattern.substr(begin);
}

// Standard input holds one text, which does not change.
void checkStandardInput(const Options& options, const std::vector<std::string>& scenes) {
  std::size_t count = 0;
  for (const std::string& scene : scenes) count += isStandardInput(scene) ? 1 : 0;
  if (count > 1) {
    throw Error(ErrorKind::kUsage, "SCENE - is given " + std::to_string(count) +
                                       " times, but standard input can be read once only");
  }
  if (count == 1 && options.watch) {
    throw Error(ErrorKind::kUsage, "--watch needs scene files that may change; SCENE - is standard input");
  }
}

// Rejects what only makes sense for a single scene.
void checkSeveral(const Options& options, std::size_t count) {
  const std::string scenes = std::to_string(count) + " scenes";
  const std::pair<const char*, bool> forOne[] = {{"--watch", options.watch},
                                                 {"--display", options.display},
                                                 {"--checkpoint", !options.checkpoint.empty()},
                                                 {"--resume", !options.resume.empty()}};
  for (const auto& [name, isGiven] : forOne) {
    if (isGiven) throw Error(ErrorKind::kUsage, std::string(name) + " is for one scene, here are " + scenes);
  }
  const std::pair<const char*, const std::string&> patterns[] = {{"--output", options.output},
                                                                 {"--json", options.json}};
  for (const auto& [name, pattern] : patterns) {
    if (pattern.empty() || pattern.find(kPlaceholder) != std::string::npos) continue;
    throw Error(ErrorKind::kUsage, std::string(name) + ' ' + pattern + " would be the same for " + scenes +
                                       "; it must have {}, which stands for a scene's name");
  }
}

// Rejects scenes of the same name. Other files that would be one are noticed when they are claimed.
void checkNames(const std::vector<Options>& all) {
  for (std::string Options::*const file : {&Options::output, &Options::json}) {
    const std::string option = file == &Options::output ? "--output" : "--json";
    std::map<fs::path, fs::path> scenes;  // by what they would write
    for (const Options& options : all) {
      if ((options.*file).empty()) continue;
      const auto [other, isNew] =
          scenes.try_emplace(fs::path(options.*file).lexically_normal(), options.scene);
      if (isNew) continue;
      throw Error(ErrorKind::kUsage,
                  option + " of " + other->second.string() + " and of " + options.scene.string() +
                      " would both be " + options.*file +
                      ", as {} stands for a scene's name without its folder and ending; give the scenes "
                      "other names, or render them one by one");
    }
  }
}

// What the render must do for the files that are to be written.
void completeRenderOptions(Options& options) {
  RenderOptions& render = options.render;
  render.falseColors = imageFormat(options.output) != ImageFormat::kPfm;
  render.countRays = options.stats || !options.json.empty();
  render.keepsPicture = options.display;
  render.keepsFilm = writesFilm(options) || !options.checkpoint.empty() || !options.resume.empty();
}

}  // namespace

std::vector<Options> optionsOfScenes(const Options& options, const std::vector<std::string>& scenes) {
  checkStandardInput(options, scenes);
  if (scenes.size() > 1) checkSeveral(options, scenes.size());
  const std::string output = options.output.empty() ? "{}.bmp" : options.output;
  std::vector<Options> all;
  for (const std::string& scene : scenes) {
    Options one = options;
    one.scene = scene;
    one.output = filledIn(output, scene);
    one.json = filledIn(options.json, scene);
    completeRenderOptions(one);
    all.push_back(std::move(one));
  }
  checkNames(all);
  return all;
}

}  // namespace lavaray
