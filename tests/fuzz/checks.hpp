#pragma once

#include <string_view>

#include "base/errors.hpp"
#include "scene/scene.hpp"

namespace lavaray::fuzz {

// What holds of every input, however hostile. Where it does not, the process is aborted, which is how a
// fuzzer is told of a defect.

// Ends the process if the condition is false.
void require(bool condition, std::string_view what);

// Every array of the scene is as scene.hpp says; its numbers are finite.
void checkScene(const Scene& scene);

// The scene as the shaders read it, unless it is so large that a fuzzer would do nothing else: finite
// numbers, and a hierarchy that holds every primitive once.
void checkFlattened(const Scene& scene);

// The reader's complaint, or a warning, names a line of a file, in one line that a terminal can print.
void checkComplaint(const Error& error);
void checkMessage(std::string_view message);

}  // namespace lavaray::fuzz
