#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lavaray {

// The text of a header in the folder `shaders` that this program was built with.
std::optional<std::string_view> builtInSource(std::string_view name);

// The names of all of them, for messages.
std::string builtInSourceNames();

}  // namespace lavaray
