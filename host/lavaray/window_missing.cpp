#include "lavaray/window.hpp"

namespace lavaray {

struct Window::Screen {};

Window::Window(const std::string& /*title*/, const ImageSize& /*size*/) {
  throw Error(ErrorKind::kOutput,
              "--display: this lavaray was built without windows; build it with libx11-dev");
}

Window::~Window() = default;
void Window::show(Image /*image*/, const std::string& /*title*/) {}
bool Window::isOpen() {
  return false;
}
void Window::wait(std::chrono::milliseconds /*time*/) {}

}  // namespace lavaray
