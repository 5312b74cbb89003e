#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/rectangle.hpp"
#include "sampling/discoveries.hpp"
#include "sampling/sample_range.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {

// A film is what a render has gathered so far of a picture or a part of it: enough to resume as if it had
// never stopped, and to merge parts into the very picture that one render of the whole makes.

// Names and values of everything that determines a picture's pixels, except which of them a film has: the
// scene, the meshes, the options, the shader. Films with equal identities are parts of one picture.
using Identity = std::vector<std::pair<std::string, std::string>>;

// How two identities differ, in words; empty if they are equal.
std::string describeDifference(const Identity& mine, const Identity& other);

struct FilmHeader {
  Identity identity;
  std::string device;  // another one may not give the same bits
  SumKind kind = SumKind::kCenter;
  ImageSize size{};  // of the whole picture
  Rectangle crop;    // the part of the picture that the film is of
  Rectangle traced;  // the part of the crop whose pixels the film has; all others are black
  // Which of each pixel's `samples` the film has. A render to a target error counts as one sample.
  SampleRange range{0, 1};
  std::uint32_t samples = 1;
  bool isComplete = false;  // everything that was asked for is in it
  // The pass under way: its samples (kMean), how many of its work items are done, and how many that are not
  // follow the pixels in the file (kHalves).
  std::uint32_t roundFirst = 0;
  std::uint32_t roundSize = 0;
  std::uint64_t itemsDone = 0;
  std::uint64_t itemsPending = 0;
  Discoveries discoveries;  // of the passes before (kHalves)
};

}  // namespace lavaray
