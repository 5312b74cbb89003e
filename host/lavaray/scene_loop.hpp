#pragma once

#include <functional>
#include <vector>

#include "lavaray/options.hpp"

namespace lavaray {

// Does the work of each scene in turn, as long as that can go on, and returns the first failure's exit code,
// or an interrupt's, or 0. If there are several scenes, an exception in the work of one is printed with the
// scene's name and does not stop the others.
int forEachScene(
    const std::vector<Options>& scenes, const std::function<int(std::size_t index)>& work,
    const std::function<bool()>& canGoOn = [] { return true; });

}  // namespace lavaray
