#pragma once

#include <string>

namespace lavaray::vulkan {

// Opens a library of a driver and never closes it, since some drivers do not survive that. Null where that
// fails, and `problem` then says why, to be said after the manifest: `, whose library "/x.so" is not there`.
void* openDriverLibrary(const std::string& library, std::string& problem);

// What NVIDIA's driver misses, if `library` is its: it says itself only that it does not start, and starts
// only where libraries for windows are, even if there are none. Empty where nothing is missing.
std::string missingForNvidia(const std::string& library);

}  // namespace lavaray::vulkan
