#pragma once

#include <string>
#include <vector>

// Where the Vulkan loader looks for manifests on Linux, as the loader's documents say
// (LoaderDriverInterface.md and LoaderLayerInterface.md of Khronos' Vulkan-Loader). The loader itself tells
// nobody.

namespace lavaray::vulkan {

// A file that the loader reads, or what a variable names in vain.
struct ManifestPlace {
  std::string file;    // empty where a variable is empty
  std::string naming;  // who names it, and how: `"VK_DRIVER_FILES" names "/x.json"`
  // Why the loader does not come to read it, to be said after the naming; empty where it does.
  std::string problem;
};

// What the loader finds base folders by: an environment variable that holds one or several, or none for /etc.
struct BaseFolders {
  const char* variable;
  std::vector<std::string> folders;
};

// In the order in which the loader searches them.
std::vector<BaseFolders> manifestBaseFolders();

// The folders of drivers' manifests that exist or might.
std::vector<std::string> driverFolders();

// In the loader's order.
std::vector<ManifestPlace> findDriverManifests();
std::vector<ManifestPlace> findImplicitLayerManifests();
std::vector<ManifestPlace> findExplicitLayerManifests();

// Text of a user's for a message, whole, in double quotes.
std::string inQuotes(const std::string& text);

}  // namespace lavaray::vulkan
