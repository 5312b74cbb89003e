#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/difference.hpp"
#include "image/image.hpp"
#include "image/mean_flip.hpp"

namespace lavaray {

// This room compares pairs of image files and tells of them: as JSON, and on a page that shows the pictures.
// It decides nothing about exit codes and prints nothing.

// Only limits that are given count; if there are none, no pixel may differ.
struct Limits {
  std::optional<double> tolerance;  // in 1/255
  std::optional<std::size_t> maxDiffering;
  std::optional<double> maxRmse;
  std::optional<double> maxFlip;
};

// Two image files to be compared. A path that is empty is a partner that is missing.
struct Pair {
  std::string name;
  std::filesystem::path image;
  std::filesystem::path reference;
  std::string driver;  // that rendered the image, in words; may be empty
  Limits limits;
};

enum class Verdict { kAlike, kDiffers, kSizesDiffer, kImageMissing, kReferenceMissing, kUnreadable };

struct ComparedPair {
  Pair pair;
  Verdict verdict = Verdict::kUnreadable;
  std::string problem;  // why a file cannot be read
  // As they were compared. Each is there if it could be read.
  std::optional<Image> image;
  std::optional<Image> reference;
  // In words, if one image has floats and the other integers: how they were compared.
  std::string comparedAs;
  // Only of images that were compared: alike or differing.
  Difference difference;
  SeenDifference seen;
  DifferenceHistogram histogram{};

  [[nodiscard]] bool isCompared() const { return verdict == Verdict::kAlike || verdict == Verdict::kDiffers; }
};

// Reads and compares the two. What is wrong with a file becomes the result's `problem`; only a lack of memory
// is thrown.
ComparedPair comparePair(const Pair& pair);

// The pairs of two folders and of the folders in them, in the order of their names. Only files with an
// extension of an image format count. Two are partners if their names are the same or, where neither has such
// a partner, differ in the extension only. Throws Error(kInput) if a folder cannot be read.
std::vector<Pair> pairsOfFolders(const std::filesystem::path& images,
                                 const std::filesystem::path& references);

}  // namespace lavaray
