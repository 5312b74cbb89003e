#pragma once

#include <functional>
#include <vector>

#include "base/errors.hpp"
#include "lavaray/options.hpp"

namespace lavaray {

// Does the work of each scene, one after the other, while that can go on, and returns the first failure's
// exit code, or an interrupt's. Where there are several scenes, what the work of one throws is printed, with
// the scene's name, and does not keep the others from being done.
ExitCode forEachScene(
    const std::vector<Options>& scenes, const std::function<ExitCode(std::size_t index)>& work,
    const std::function<bool()>& canGoOn = [] { return true; });

}  // namespace lavaray
