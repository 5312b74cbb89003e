#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "image/image_format.hpp"
#include "image/image_reader.hpp"
#include "report/pair.hpp"

namespace lavaray {
namespace {

namespace fs = std::filesystem;

// The image files in the folder, by their paths below it.
std::set<fs::path> imagesIn(const fs::path& folder) {
  std::set<fs::path> result;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path name = entry.path().lexically_relative(folder);
      if (entry.is_regular_file() && hasImageExtension(name)) result.insert(name);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(ExitCode::kInput, printable(folder.native()) + ": cannot be read: " + error.code().message());
  }
  return result;
}

// Takes away from both what is in both.
std::set<fs::path> takeCommon(std::set<fs::path>& a, std::set<fs::path>& b) {
  std::set<fs::path> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(common, common.end()));
  for (const fs::path& name : common) {
    a.erase(name);
    b.erase(name);
  }
  return common;
}

// Those whose name without the extension no other of them has.
std::map<fs::path, fs::path> byStem(const std::set<fs::path>& names) {
  std::map<fs::path, std::vector<fs::path>> all;
  for (const fs::path& name : names) all[fs::path(name).replace_extension()].push_back(name);
  std::map<fs::path, fs::path> result;
  for (const auto& [stem, of] : all) {
    if (of.size() == 1) result.emplace(stem, of.front());
  }
  return result;
}

}  // namespace

std::vector<Pair> pairsOfFolders(const fs::path& images, const fs::path& references) {
  std::set<fs::path> left = imagesIn(images);
  std::set<fs::path> right = imagesIn(references);
  std::vector<Pair> pairs;
  const auto add = [&](const fs::path& image, const fs::path& reference) {
    const fs::path& name = image.empty() ? reference : image;
    pairs.push_back({name.string(),
                     image.empty() ? image : images / image,
                     reference.empty() ? reference : references / reference,
                     {},
                     {}});
  };
  for (const fs::path& name : takeCommon(left, right)) add(name, name);
  const std::map<fs::path, fs::path> others = byStem(right);
  for (const auto& [stem, name] : byStem(left)) {
    const auto other = others.find(stem);
    if (other == others.end()) continue;
    add(name, other->second);
    left.erase(name);
    right.erase(other->second);
  }
  for (const fs::path& name : left) add(name, {});
  for (const fs::path& name : right) add({}, name);
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.name < b.name; });
  return pairs;
}

}  // namespace lavaray
