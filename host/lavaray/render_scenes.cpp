#include "lavaray/render_scenes.hpp"

#include <iostream>

#include "command_line/interrupt.hpp"
#include "lavaray/render_context.hpp"
#include "lavaray/scene_loop.hpp"
#include "lavaray/session.hpp"
#include "lavaray/standard_input.hpp"

namespace lavaray {
namespace {

int renderScene(const Options& options, RenderContext& context) {
  Session session(options, context);
  context.progress.begin("reading the scene");
  session.inputs().readScene({});
  session.times().endStep("read scene");
  context.progress.begin("compiling the shaders");
  if (session.inputs().compileShaders({})) session.times().endStep("compile shaders");
  session.printWarnings();
  const int code = session.renderAndWrite();
  session.viewer().waitUntilClosed();
  return session.viewer().hasFailed() && code == 0 ? static_cast<int>(ErrorKind::kOutput) : code;
}

std::string interruptedText(std::size_t left) {
  return "interrupted; " + std::to_string(left) + (left == 1 ? " scene is left" : " scenes are left");
}

// Nothing can be kept of a scene that is being read: a signal ends the process.
void prepareForInterrupt(std::size_t left, RenderContext& context) {
  static std::string text;  // as setInterruptedText asks for
  setInterruptedText("");
  text = interruptedText(left) + '\n';
  setInterruptedText(text.c_str());
  context.guard.reset();
}

}  // namespace

int renderScenes(const std::vector<Options>& scenes) {
  RenderContext context(scenes.front());
  const std::size_t count = scenes.size();
  if (count > 1) (void)context.device.info();  // Without one, no scene can be rendered.
  std::size_t begun = 0;
  const auto render = [&](std::size_t index) {
    if (count > 1) prepareForInterrupt(count - index, context);
    begun = index + 1;
    context.progress.beginPiece(index, count);
    if (count > 1 && scenes[index].verbose) {
      std::cerr << "scene " << begun << " of " << count << ": " << shownName(scenes[index].scene) << '\n';
    }
    try {
      return renderScene(scenes[index], context);
    } catch (...) {
      context.progress.end();  // before the message
      throw;
    }
  };
  const int code = forEachScene(scenes, render, [] { return !wasInterrupted(); });
  if (begun < count) throwInterrupted(interruptedText(count - begun));
  return code;
}

}  // namespace lavaray
