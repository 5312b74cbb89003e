#include "vulkan/driver_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/printable.hpp"

namespace lavaray::vulkan {
namespace {

namespace fs = std::filesystem;

// Like the loader, ignores the environment of a set-user-id program.
std::optional<std::string> variable(const char* name) {
  const char* value = secure_getenv(name);
  if (value == nullptr) return std::nullopt;
  return value;
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end > 0) parts.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return parts;
}

bool isManifestName(std::string_view name) {
  return name.size() > 5 && name.ends_with(".json");
}

// Why there is no file of that name, if the name itself gives it away.
std::string hint(const std::string& name) {
  if (name.find(".json,") != std::string::npos || name.find(".json;") != std::string::npos) {
    return "; colons separate the files of a list, not commas or semicolons";
  }
  if (name.starts_with('~')) return "; nobody has replaced the ~ by a home folder";
  return {};
}

std::vector<std::string> manifestsIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (isManifestName(entry->path().filename().native())) names.push_back(entry->path().filename().native());
  }
  return names;
}

void addNamed(const std::string& by, const std::string& name, std::vector<ManifestCandidate>& candidates) {
  const std::string naming = by + " names " + inQuotes(name);
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  if (isManifestName(name)) {
    candidates.push_back({name, naming,
                          fs::exists(status) || status.type() == fs::file_type::none
                              ? std::string()
                              : ", which is not there" + hint(name)});
  } else if (fs::is_directory(status)) {
    const std::vector<std::string> files = manifestsIn(name);
    for (const std::string& file : files) {
      candidates.push_back({fs::path(name) / file,
                            by + " names the folder " + inQuotes(name) + ", which holds " + inQuotes(file),
                            {}});
    }
    if (files.empty()) {
      candidates.push_back(
          {name, by + " names the folder " + inQuotes(name), ", which holds no manifest to be read"});
    }
  } else {
    candidates.push_back({name, naming,
                          fs::exists(status) ? ", which does not end in .json, so that it is not read"
                                             : ", which is not there" + hint(name)});
  }
}

void addListed(const char* variableName, const std::string& list,
               std::vector<ManifestCandidate>& candidates) {
  for (const std::string& name : split(list)) addNamed(inQuotes(variableName), name, candidates);
}

std::vector<std::string> searchedFolders(const char* subfolder) {
  std::vector<std::string> folders;
  for (const BaseFolders& base : manifestBaseFolders()) {
    for (const std::string& folder : base.folders) {
      const std::string path = fs::path(folder) / "vulkan" / subfolder;
      if (std::find(folders.begin(), folders.end(), path) == folders.end()) folders.push_back(path);
    }
  }
  return folders;
}

// The first of the variables that is set, even to nothing, recandidates all else; `additional` comes first.
std::vector<ManifestCandidate> find(std::initializer_list<const char*> replacing, const char* additional,
                                    const char* subfolder) {
  std::vector<ManifestCandidate> candidates;
  for (const char* name : replacing) {
    const auto list = variable(name);
    if (!list) continue;
    addListed(name, *list, candidates);
    if (candidates.empty()) {
      candidates.push_back(
          {{}, inQuotes(name), " is set, but empty, so that no manifest is looked for; unset it"});
    }
    return candidates;
  }
  if (additional != nullptr) {
    if (const auto list = variable(additional)) addListed(additional, *list, candidates);
  }
  for (const std::string& folder : searchedFolders(subfolder)) {
    for (const std::string& file : manifestsIn(folder)) {
      candidates.push_back(
          {fs::path(folder) / file, "the folder " + inQuotes(folder) + " holds " + inQuotes(file), {}});
    }
  }
  return candidates;
}

}  // namespace

std::string inQuotes(const std::string& text) {
  return '"' + printable(text) + '"';
}

std::vector<BaseFolders> manifestBaseFolders() {
  const std::optional<std::string> home = variable("HOME");
  const auto one = [&](const char* name, const char* belowHome) {
    const std::string value = variable(name).value_or("");
    if (!value.empty()) return BaseFolders{name, split(value)};
    return BaseFolders{name, home ? std::vector{*home + belowHome} : std::vector<std::string>{}};
  };
  const auto several = [&](const char* name, const char* otherwise) {
    const std::string value = variable(name).value_or("");
    return BaseFolders{name, split(value.empty() ? otherwise : value)};
  };
  return {one("XDG_CONFIG_HOME", "/.config"),
          several("XDG_CONFIG_DIRS", "/etc/xdg"),
          {nullptr, {"/etc"}},
          one("XDG_DATA_HOME", "/.local/share"),
          several("XDG_DATA_DIRS", "/usr/local/share:/usr/share")};
}

std::vector<std::string> driverFolders() {
  return searchedFolders("icd.d");
}

std::vector<ManifestCandidate> findDriverManifests() {
  return find({"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}, "VK_ADD_DRIVER_FILES", "icd.d");
}

std::vector<ManifestCandidate> findImplicitLayerManifests() {
  return find({}, nullptr, "implicit_layer.d");
}

std::vector<ManifestCandidate> findExplicitLayerManifests() {
  return find({"VK_LAYER_PATH"}, "VK_ADD_LAYER_PATH", "explicit_layer.d");
}

}  // namespace lavaray::vulkan
