#include "lavaray/viewer.hpp"

#include <iomanip>
#include <iostream>
#include <sstream>

#include "command_line/interrupt.hpp"
#include "command_line/progress.hpp"

namespace lavaray {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// The shortest time from one showing of a growing picture to the next: drawing takes time from rendering.
constexpr auto kShowEvery = 250ms;
// How long a key press may go unnoticed while nothing is rendered.
constexpr auto kIdle = 100ms;

}  // namespace

void Viewer::open(const ImageSize& size) {
  if (!options_.display || window_ || hasFailed_) return;
  try {
    window_ = std::make_unique<Window>("lavaray", size);
  } catch (const Error& error) {
    hasFailed_ = true;  // The picture is still written; the exit code tells.
    std::cerr << "lavaray: " << error.what() << '\n';
  }
}

void Viewer::update(RenderJob& job) {
  if (!window_) return;
  if (Clock::now() - lastShown_ >= kShowEvery && job.samplesPerPixel() > 0.0) show(job, false);
  idle();
}

void Viewer::showFinished(RenderJob& job) {
  if (window_) show(job, true);
}

void Viewer::idle() {
  if (window_) isClosed_ = !window_->isOpen();
}

void Viewer::waitUntilClosed() {
  while (window_ && !isClosed_ && !wasInterrupted()) {
    window_->wait(kIdle);
    idle();
  }
}

void Viewer::show(RenderJob& job, bool isFinished) {
  std::ostringstream title;
  title << options_.scene.filename().string() << ": " << describeSamples(job);
  const double share = job.shareDone();
  if (!isFinished) {
    title << ", " << static_cast<int>(100.0 * share) << " %, "
          << hoursAndMinutes(remainingTime(std::chrono::duration<double>(job.secondsElapsed()), share))
          << " left";
  }
  Image image = job.image();
  // The file may hold numbers in place of colours.
  if (options_.render.view == View::kCost && !options_.render.falseColors) applyFalseColors(image.rgb);
  window_->show(std::move(image), title.str());
  lastShown_ = Clock::now();
}

std::string describeSamples(const RenderJob& job) {
  std::ostringstream text;
  text << std::setprecision(3) << job.samplesPerPixel() << " spp";
  if (job.estimatedError() > 0.0) text << ", error " << job.estimatedError();
  return text.str();
}

}  // namespace lavaray
