#include "lavaray/scene_loop.hpp"

#include <iostream>

#include "command_line/interrupt.hpp"
#include "command_line/program.hpp"
#include "lavaray/standard_input.hpp"

namespace lavaray {
namespace {

// Most messages begin with the scene anyway.
std::string named(const std::string& scene, const std::string& message) {
  return message.starts_with(scene) ? message : scene + ": " + message;
}

}  // namespace

int forEachScene(const std::vector<Options>& scenes, const std::function<int(std::size_t index)>& work,
                 const std::function<bool()>& canGoOn) {
  if (scenes.size() == 1) return work(0);
  int first = 0;
  for (std::size_t i = 0; i < scenes.size() && canGoOn(); ++i) {
    int code = 0;
    try {
      code = work(i);
    } catch (const std::exception&) {
      const Failure failure = currentFailure();
      std::cerr << "lavaray: " << named(shownName(scenes[i].scene), failure.message) << '\n';
      code = failure.code;
    }
    if (first == 0 || (wasInterrupted() && code == interruptCode())) first = code;
  }
  return first;
}

}  // namespace lavaray
