#pragma once

#include <lavaray/statistics.h>

#include "image/difference.hpp"

namespace lavaray {

v0::Difference publicDifference(const Difference& found);

}  // namespace lavaray
