#pragma once

#include <string>

namespace lavaray::vulkan {

// What the loader needs of a manifest.
struct ManifestContents {
  std::string library;        // of a driver: a path, or a name for the system to look up
  std::string problem;        // worded to follow the manifest's name: `, which is empty`; or empty
  bool isUnparsable = false;  // old loaders take that for a lack of memory and give up altogether
};

// `acceptsMark` says whether the loader accepts a UTF-8 byte-order mark.
ManifestContents readDriverManifest(const std::string& file, bool acceptsMark);

// Of a layer, only finds out whether the manifest can be parsed.
ManifestContents readLayerManifest(const std::string& file, bool acceptsMark);

}  // namespace lavaray::vulkan
