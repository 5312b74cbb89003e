#pragma once

#include <string>

namespace lavaray::vulkan {

// Opens a driver's library, and never closes it, which some drivers do not survive. Returns null if that
// fails; `problem` then says why, worded to follow the manifest's name: `, whose library "/x.so" is not
// there`.
void* openDriverLibrary(const std::string& library, std::string& problem);

// Which libraries NVIDIA's driver lacks, if `library` is part of it; else, or if none, empty. The driver
// itself only says that it does not start. It needs libraries for windows even to draw in none.
std::string missingForNvidia(const std::string& library);

}  // namespace lavaray::vulkan
