#pragma once

#include <memory>
#include <optional>
#include <type_traits>

#include "app/inputs.hpp"
#include "app/open_device.hpp"
#include "app/options.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/report.hpp"
#include "app/window.hpp"
#include "core/errors.hpp"
#include "render/renderer.hpp"
#include "watch/folder_watcher.hpp"

namespace lavaray {

// Renders a scene to a picture as the options say: once, or with --watch again and again, with --display
// before the user's eyes.
class Session {
 public:
  explicit Session(const Options& options);

  // Returns when there is nothing left to do: the picture is written, and the user has closed the window or
  // interrupted the watching.
  ExitCode run();

 private:
  using Files = Inputs::Files;

  ExitCode renderOnce();
  ExitCode watch();
  template <typename Work>
  std::optional<std::invoke_result_t<Work>> attempt(const Work& work);
  bool readChanged(const Files& changed);
  void printWarnings();
  Files waitForChanges();
  void showUntilClosed();

  ExitCode renderAndWrite();
  void writeOutputs(Render& render, const RenderSettings& settings, const Rectangle& part,
                    const Identity& identity, Outputs& outputs);
  void openWindow(const ImageSize& size);
  bool proceed(const Render& render);
  void showInWindow(const Render& render, bool isFinished);
  [[nodiscard]] bool isEnded() const;

  const Options& options_;
  Inputs inputs_;  // before the device, which is opened by another thread
  FutureDevice device_;
  Progress progress_;
  StepTimes times_;
  std::optional<FolderWatcher> watcher_;  // with --watch
  Files changed_;                         // while a render was under way, which they end
  std::unique_ptr<Window> window_;
  bool windowClosed_ = false;
  bool windowFailed_ = false;
  std::chrono::steady_clock::time_point lastShown_;
};

}  // namespace lavaray
