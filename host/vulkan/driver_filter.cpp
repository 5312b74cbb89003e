#include "vulkan/driver_filter.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "vulkan/driver_search.hpp"

namespace lavaray::vulkan {
namespace {

std::string valueOf(const char* variable) {
  const char* value = secure_getenv(variable);
  return value != nullptr ? value : "";
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// A pattern may have a * at either end; ~all~ matches everything.
bool fits(std::string_view name, std::string_view pattern) {
  if (pattern == "~all~" || pattern == "*" || pattern == "**") return true;
  const bool anyBegin = pattern.starts_with('*');
  if (anyBegin) pattern.remove_prefix(1);
  const bool anyEnd = pattern.ends_with('*');
  if (anyEnd) pattern.remove_suffix(1);
  if (anyBegin && anyEnd) return name.find(pattern) != std::string_view::npos;
  if (anyBegin) return name.ends_with(pattern);
  return anyEnd ? name.starts_with(pattern) : name == pattern;
}

// Whether the file name matches a pattern in the list, ignoring case.
bool isListed(const std::string& manifest, const std::string& list) {
  const std::string name = lower(std::filesystem::path(manifest).filename());
  std::istringstream patterns(lower(list));
  for (std::string pattern; std::getline(patterns, pattern, ',');) {
    if (!pattern.empty() && fits(name, pattern)) return true;
  }
  return false;
}

}  // namespace

std::string whyFilteredOut(const std::string& manifest) {
  constexpr const char* kSelect = "VK_LOADER_DRIVERS_SELECT";
  constexpr const char* kDisable = "VK_LOADER_DRIVERS_DISABLE";
  const std::string select = valueOf(kSelect);
  const std::string disable = valueOf(kDisable);
  if (isListed(manifest, select)) return {};
  if (isListed(manifest, disable)) {
    return ", which " + inQuotes(kDisable) + " leaves out: it is " + inQuotes(disable);
  }
  const bool selects = select.find_first_not_of(',') != std::string::npos;
  return selects ? ", which " + inQuotes(kSelect) + " leaves out: it is " + inQuotes(select) : std::string();
}

}  // namespace lavaray::vulkan
