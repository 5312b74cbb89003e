#include "shader_compiler/built_in_sources.hpp"

#include <algorithm>
#include <array>

#include "shader_compiler/built_in_texts.hpp"

namespace lavaray {

std::optional<std::string_view> builtInSource(std::string_view name) {
  const auto* source = std::ranges::find(kBuiltInTexts, name, &BuiltInText::name);
  if (source == std::end(kBuiltInTexts)) return std::nullopt;
  return source->text;
}

std::string builtInSourceNames() {
  std::string names;
  for (const BuiltInText& source : kBuiltInTexts) {
    if (!names.empty()) names += ", ";
    names += source.name;
  }
  return names;
}

}  // namespace lavaray
