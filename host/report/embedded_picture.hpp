#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"

namespace lavaray {

// Pictures for a page, each as a PNG file in base64. All are 8-bit RGB without any chunk on colours, so that
// a browser treats them alike and a canvas gives the bytes that were written.

// The image as a display shows it: levels of 8 bits, other integers and floats as trunc(255 c). Alpha lets a
// chequerboard through, NaN is magenta.
std::string shownPicture(const Image& image);

// Whether the levels of shownPicture are the image's own values.
bool isShownExactly(const Image& image);

// The image's values as they are, in the bytes of the colours: byte k of the float32 of each channel, the
// lowest first, is in the k-th picture of those that stand one below the other. Four more follow for alpha if
// the image has any.
std::string valuesPicture(const Image& image);

// Values from 0 to 1, one for each pixel, as grey.
std::string greyPicture(int width, int height, const std::vector<float>& values);

}  // namespace lavaray
