#include "lavaray/viewer.hpp"

#include <iomanip>
#include <iostream>
#include <sstream>

#include "base/errors.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress.hpp"
#include "image/false_color.hpp"

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

void Viewer::update(const Render& render) {
  if (!window_) return;
  if (Clock::now() - lastShown_ >= kShowEvery && render.samplesPerPixel() > 0.0) show(render, false);
  idle();
}

void Viewer::showFinished(const Render& render) {
  if (window_) show(render, true);
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

void Viewer::show(const Render& render, bool isFinished) {
  std::ostringstream title;
  title << options_.scene.filename().string() << ": " << describeSamples(render);
  const double share = render.shareDone();
  if (!isFinished) {
    title << ", " << static_cast<int>(100.0 * share) << " %, "
          << hoursAndMinutes(remainingTime(render.elapsed(), share)) << " left";
  }
  Image image = render.image();
  if (options_.normalize) normalize(image);
  if (options_.render.view == View::kCost) applyFalseColors(image.rgb);
  window_->show(std::move(image), title.str());
  lastShown_ = Clock::now();
}

std::string describeSamples(const Render& render) {
  std::ostringstream text;
  text << std::setprecision(3) << render.samplesPerPixel() << " spp";
  if (render.estimatedError() > 0.0) text << ", error " << render.estimatedError();
  return text.str();
}

}  // namespace lavaray
