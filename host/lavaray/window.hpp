#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "image/image.hpp"
#include "scene/camera.hpp"

namespace lavaray {

// A window on the screen that shows a picture: the wheel, + and - zoom about the mouse, the title names the
// value of the pixel under it, and Esc, q or the close button end it.
class Window {
 public:
  // Throws Error(kOutput) where there is no screen, or where the program was built without X11.
  Window(const std::string& title, const ImageSize& size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Shows the image and the title; if it has another size than the one before, all of it.
  void show(Image image, const std::string& title);
  // Looks at keys and mouse. False once the user has closed the window.
  bool isOpen();
  // Waits for something to happen, or for the time to pass.
  void wait(std::chrono::milliseconds time);

 private:
  struct Screen;
  std::unique_ptr<Screen> screen_;
};

}  // namespace lavaray
