#pragma once

#include <string>

namespace lavaray::vulkan {

// What a manifest says, as far as the loader needs it.
struct ManifestContents {
  std::string library;        // of a driver: a path, or a name for the system to look up
  std::string problem;        // to be said after the manifest: `, which is empty`; empty where there is none
  bool isUnparsable = false;  // old loaders take that for a lack of memory, and give up altogether
};

// The manifest of a driver. `acceptsMark` says whether the loader accepts a UTF-8 byte-order mark in it.
ManifestContents readDriverManifest(const std::string& file, bool acceptsMark);

// That of a layer, of which nothing is looked at but whether it can be parsed.
ManifestContents readLayerManifest(const std::string& file, bool acceptsMark);

}  // namespace lavaray::vulkan
