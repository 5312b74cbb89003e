#include "film/film.hpp"

#include <algorithm>

namespace lavaray {
namespace {

const std::string* find(const Identity& identity, const std::string& name) {
  const auto entry = std::find_if(identity.begin(), identity.end(),
                                  [&](const auto& candidate) { return candidate.first == name; });
  return entry == identity.end() ? nullptr : &entry->second;
}

}  // namespace

std::string describeDifference(const Identity& mine, const Identity& other) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& here, const std::string& there) {
    text += (text.empty() ? "" : "; ") + name + " is " + here + " here and " + there + " there";
  };
  for (const auto& [name, value] : mine) {
    const std::string* there = find(other, name);
    if (there == nullptr) add(name, value, "absent");
    if (there != nullptr && *there != value) add(name, value, *there);
  }
  for (const auto& [name, value] : other) {
    if (find(mine, name) == nullptr) add(name, "absent", value);
  }
  return text;
}

}  // namespace lavaray
