#include "lavaray/watch_scene.hpp"

#include <iostream>
#include <optional>
#include <type_traits>

#include "command_line/interrupt.hpp"
#include "lavaray/render_context.hpp"
#include "lavaray/session.hpp"
#include "watch/folder_watcher.hpp"

namespace lavaray {
namespace {

using namespace std::chrono_literals;

// How long a change or a key press may go unnoticed while nothing is rendered.
constexpr auto kIdle = 100ms;

class Watch {
 public:
  explicit Watch(const Options& options)
      : options_(options), context_(options), session_(options, context_) {}
  int run();

 private:
  using Files = Inputs::Files;

  template <typename Work>
  std::optional<std::invoke_result_t<Work>> attempt(const Work& work);
  bool readChanged(const Files& changed);
  std::optional<int> render();
  Files waitForChanges();

  const Options& options_;
  RenderContext context_;
  Session session_;
  FolderWatcher watcher_;  // made before anything is read, so that no change is lost
  Files changed_;          // during a render, which that ends
};

// What `work` returns. If its input is wrong, prints that and returns nothing: someone is about to mend it.
template <typename Work>
std::optional<std::invoke_result_t<Work>> Watch::attempt(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInput && error.kind() != ErrorKind::kUsage) throw;
    context_.progress.end();
    std::cerr << "lavaray: " << error.what() << '\n';
    return std::nullopt;
  }
}

int Watch::run() {
  int code = 0;
  bool isDue = false;  // whether something has changed that no picture shows yet
  for (Files changed; !session_.isEnded(); changed = changed_.empty() ? waitForChanges() : changed_) {
    if (!options_.quiet) {
      for (const auto& file : changed) std::cerr << "changed: " << file.string() << '\n';
    }
    session_.times() = StepTimes();
    context_.guard.reset();
    isDue = readChanged(changed) || isDue;
    watcher_.watch(session_.inputs().files());
    changed_.clear();
    if (!isDue || !session_.inputs().areComplete()) continue;
    const std::optional<int> result = render();
    if (result) setInterruptedText("interrupted; the picture is of an earlier state\n");
    code = result.value_or(code);
    isDue = !changed_.empty();  // since a change has ended the render
    if (result && !isDue && !options_.quiet) {
      std::cerr << "wrote " << options_.output << ": " << session_.times().inOneLine() << '\n';
    }
  }
  return session_.viewer().hasFailed() && code == 0 ? static_cast<int>(ErrorKind::kOutput) : code;
}

// Returns whether there is something new to render.
bool Watch::readChanged(const Files& changed) {
  const auto timed = [&](const std::string& step, const auto& read) {
    context_.progress.begin(step);
    const bool isNew = attempt(read).value_or(false);
    if (isNew) session_.times().endStep(step);
    return isNew;
  };
  Inputs& inputs = session_.inputs();
  const bool isSceneNew = timed("read scene", [&] { return inputs.readScene(changed); });
  const bool isShaderNew = timed("compile shaders", [&] { return inputs.compileShaders(changed); });
  session_.printWarnings();
  return isSceneNew || isShaderNew;
}

std::optional<int> Watch::render() {
  return attempt([&] {
    return session_.renderAndWrite([&] {
      changed_ = watcher_.changes(0ms);
      return !changed_.empty();
    });
  });
}

Inputs::Files Watch::waitForChanges() {
  Files changed;
  context_.keepWhenInterrupted();
  while (changed.empty() && !session_.isEnded()) {
    changed = watcher_.changes(kIdle);
    session_.viewer().idle();
  }
  return changed;
}

}  // namespace

int watchScene(const Options& options) {
  return Watch(options).run();
}

}  // namespace lavaray
