#pragma once

#include <lavaray/statistics.h>
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

using v0::Verdict;
using Limits = v0::DifferenceLimits;
using Pair = v0::ImagePair;

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
