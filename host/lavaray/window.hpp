#pragma once

#include <lavaray/types.h>

#include <chrono>
#include <memory>
#include <string>

namespace lavaray {

// A window on the screen that shows a picture. The wheel, + and - zoom about the mouse pointer, the title
// gives the value of the pixel under it, and Esc, q or the close button closes the window.
class Window {
 public:
  // Throws Error(kOutput) if there is no screen, or the program was built without X11.
  Window(const std::string& title, const ImageSize& size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Shows the image and the title; the whole image, if its size is not that of the last one.
  void show(Image image, const std::string& title);
  // Handles keys and mouse. False once the user has closed the window.
  bool isOpen();
  // Waits until something happens or the time is up.
  void wait(std::chrono::milliseconds time);

 private:
  struct Screen;
  std::unique_ptr<Screen> screen_;
};

}  // namespace lavaray
