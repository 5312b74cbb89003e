#pragma once

#include <lavaray/types.h>

namespace lavaray {

using v0::ImageSize;
using v0::Rectangle;

}  // namespace lavaray
