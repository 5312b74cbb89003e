#pragma once

#include <string>
#include <vector>

// Where the Vulkan loader looks for manifests on Linux, by the documents of Khronos' Vulkan-Loader
// (LoaderDriverInterface.md, LoaderLayerInterface.md): the loader has no function that tells.

namespace lavaray::vulkan {

// A file that the loader reads, or that a variable names in vain.
struct ManifestCandidate {
  std::string file;    // empty if it is the variable that is empty
  std::string naming;  // who names it, and how: `"VK_DRIVER_FILES" names "/x.json"`
  // Why the loader never reads it, worded to follow `naming`; empty if it does.
  std::string problem;
};

// Where the loader takes base folders from: an environment variable that lists them, or none for /etc.
struct BaseFolders {
  const char* variable;
  std::vector<std::string> folders;
};

// In the order in which the loader searches.
std::vector<BaseFolders> manifestBaseFolders();

// The folders in which drivers' manifests may lie, whether they exist or not.
std::vector<std::string> driverFolders();

// In the loader's order.
std::vector<ManifestCandidate> findDriverManifests();
std::vector<ManifestCandidate> findImplicitLayerManifests();
std::vector<ManifestCandidate> findExplicitLayerManifests();

// A user's text, whole, in double quotes for a message.
std::string inQuotes(const std::string& text);

}  // namespace lavaray::vulkan
