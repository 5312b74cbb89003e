#pragma once

#include <png.h>

#include <csetjmp>
#include <string>

namespace lavaray {

// What reading and writing PNG files have in common: libpng reports errors by longjmp.

// For libpng, whose error pointer is a std::string that takes the message.
inline void onPngError(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

// False if libpng found an error, which leaves `body` by longjmp: nothing with a destructor may live in it.
template <typename Body>
bool pngSucceeds(png_structp png, const Body& body) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

}  // namespace lavaray
