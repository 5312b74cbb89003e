#include "lavaray/window.hpp"

#include <lavaray/image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#define cimg_display 1
#define cimg_verbosity 0
#include <CImg.h>

namespace lavaray {
namespace {

namespace cimg = cimg_library::cimg;
using cimg_library::CImg;
using cimg_library::CImgDisplay;
using cimg_library::CImgDisplayException;

constexpr double kZoomStep = 1.25;
constexpr double kMaxZoom = 64.0;  // screen pixels per pixel
// The largest part of the screen that a new window takes up.
constexpr double kScreenShare = 0.9;

// The size at which a picture is first shown: its own, or the largest of its aspect ratio that fits the
// screen.
ImageSize windowSize(int width, int height) {
  const double scale = std::min({1.0, kScreenShare * CImgDisplay::screen_width() / width,
                                 kScreenShare * CImgDisplay::screen_height() / height});
  return {std::max(1, static_cast<int>(width * scale)), std::max(1, static_cast<int>(height * scale))};
}

}  // namespace

struct Window::Screen {
  CImgDisplay display;
  Image image;
  std::string title;
  double zoom = 1.0;             // window pixels per pixel
  double left = 0.0, top = 0.0;  // the point of the image in the window's corner

  [[nodiscard]] double column(double x) const { return left + x / zoom; }
  [[nodiscard]] double row(double y) const { return top + y / zoom; }

  void fit() {
    zoom = std::min(static_cast<double>(display.width()) / image.width,
                    static_cast<double>(display.height()) / image.height);
    left = top = 0.0;
  }

  // Keeps the point under the mouse where it is.
  void zoomBy(double factor) {
    const bool isInside = display.mouse_x() >= 0;
    const double x = isInside ? display.mouse_x() : display.width() / 2.0;
    const double y = isInside ? display.mouse_y() : display.height() / 2.0;
    const double column0 = column(x);
    const double row0 = row(y);
    const double whole = std::min(static_cast<double>(display.width()) / image.width,
                                  static_cast<double>(display.height()) / image.height);
    zoom = std::clamp(zoom * factor, std::min(whole, 1.0), kMaxZoom);
    left = std::clamp(column0 - x / zoom, 0.0, std::max(0.0, image.width - display.width() / zoom));
    top = std::clamp(row0 - y / zoom, 0.0, std::max(0.0, image.height - display.height() / zoom));
  }

  void draw() {
    CImg<unsigned char> shown(display.width(), display.height(), 1, 3, 0);
    for (int y = 0; y < shown.height(); ++y) {
      const auto v = static_cast<int>(row(y + 0.5));
      if (v >= image.height) break;
      for (int x = 0; x < shown.width(); ++x) {
        const auto u = static_cast<int>(column(x + 0.5));
        if (u >= image.width) break;
        const float* pixel = &image.rgb[3 * (static_cast<std::size_t>(v) * image.width + u)];
        for (int channel = 0; channel < 3; ++channel) shown(x, y, 0, channel) = toByte(pixel[channel]);
      }
    }
    display.display(shown);
  }

  void drawTitle() {
    std::ostringstream text;
    text << title;
    const int x = display.mouse_x();
    const auto u = static_cast<int>(column(x));
    const auto v = static_cast<int>(row(display.mouse_y()));
    if (x >= 0 && u < image.width && v < image.height) {
      const float* pixel = &image.rgb[3 * (static_cast<std::size_t>(v) * image.width + u)];
      text.precision(4);
      text << " | " << u << ',' << v << ": " << pixel[0] << ' ' << pixel[1] << ' ' << pixel[2];
    }
    if (text.str() != display.title()) display.set_title("%s", text.str().c_str());
  }
};

Window::Window(const std::string& title, const ImageSize& size) : screen_(std::make_unique<Screen>()) {
  try {
    const auto [width, height] = windowSize(size.width, size.height);
    screen_->display.assign(width, height, title.c_str(), 0);
  } catch (const CImgDisplayException&) {
    throw Error(ErrorKind::kOutput,
                "--display: there is no screen; is DISPLAY set, and an X server running?");
  }
}

Window::~Window() = default;

void Window::show(Image image, const std::string& title) {
  const bool isNewSize = image.width != screen_->image.width || image.height != screen_->image.height;
  screen_->image = std::move(image);
  screen_->title = title;
  if (isNewSize) {
    const auto [width, height] = windowSize(screen_->image.width, screen_->image.height);
    if (width != screen_->display.width() || height != screen_->display.height()) {
      screen_->display.resize(width, height, false);
    }
    screen_->fit();
  }
  screen_->draw();
  screen_->drawTitle();
}

bool Window::isOpen() {
  CImgDisplay& display = screen_->display;
  // Keys pressed since the last look, the latest first; a released one is 0.
  for (unsigned int i = 0; i < 128 && !display.is_closed(); ++i) {
    const unsigned int key = display.key(i);
    if (key == cimg::keyESC || key == cimg::keyQ || key == 'Q') display.close();
    if (key == '+' || key == cimg::keyPADADD) screen_->zoomBy(kZoomStep);
    if (key == '-' || key == cimg::keyPADSUB) screen_->zoomBy(1.0 / kZoomStep);
    if (key == '+' || key == '-' || key == cimg::keyPADADD || key == cimg::keyPADSUB) screen_->draw();
  }
  display.set_key();
  if (display.is_closed()) return false;
  if (screen_->image.rgb.empty()) return true;
  if (display.wheel() != 0) {
    screen_->zoomBy(std::pow(kZoomStep, display.wheel()));
    display.set_wheel();
    screen_->draw();
  }
  if (display.is_resized()) {
    display.resize(false);
    screen_->fit();
    screen_->draw();
  }
  screen_->drawTitle();
  return true;
}

void Window::wait(std::chrono::milliseconds time) {
  screen_->display.wait(static_cast<unsigned int>(time.count()));
}

}  // namespace lavaray
