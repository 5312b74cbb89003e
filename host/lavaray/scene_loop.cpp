#include "lavaray/scene_loop.hpp"

#include <iostream>

#include "command_line/interrupt.hpp"
#include "lavaray/standard_input.hpp"
#include "library/guarded.hpp"

namespace lavaray {
namespace {

// Most messages begin with the scene anyway.
std::string named(const std::string& scene, const std::string& message) {
  return message.starts_with(scene) ? message : scene + ": " + message;
}

}  // namespace

ExitCode forEachScene(const std::vector<Options>& scenes,
                      const std::function<ExitCode(std::size_t index)>& work,
                      const std::function<bool()>& canGoOn) {
  if (scenes.size() == 1) return work(0);
  ExitCode first = ExitCode::kSuccess;
  for (std::size_t i = 0; i < scenes.size() && canGoOn(); ++i) {
    ExitCode code = ExitCode::kSuccess;
    try {
      code = guarded([&] { return work(i); });
    } catch (const v0::Error& error) {
      std::cerr << "lavaray: " << named(shownName(scenes[i].scene), error.what()) << '\n';
      code = static_cast<ExitCode>(error.kind());
    }
    if (first == ExitCode::kSuccess || (wasInterrupted() && static_cast<int>(code) == interruptCode()))
      first = code;
  }
  return first;
}

}  // namespace lavaray
