#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/rectangle.hpp"
#include "sampling/sample_range.hpp"
#include "sampling/sample_sums.hpp"

namespace lavaray {

// A film is what a render has gathered so far of a picture or a part of it: enough to resume as if it had
// never stopped, and to merge parts into the very picture that one render of the whole makes.

// Names and values of everything that determines a picture's pixels, except which of them a film has: the
// scene, the meshes, the options, the shader. Films with equal identities are parts of one picture.
using Identity = std::vector<std::pair<std::string, std::string>>;

// Where two identities differ, for a reader; empty where they are equal.
std::string describeDifference(const Identity& mine, const Identity& other);

struct FilmHeader {
  Identity identity;
  std::string device;  // Another one need not give the same bits.
  SumKind kind = SumKind::kCenter;
  ImageSize size{};  // of the whole picture
  Rectangle crop;    // of the picture: what the film is of
  Rectangle traced;  // of the crop: outside of it all pixels are black; the film has only these pixels
  // Of each pixel's `samples` in the picture those in the film. A render to a target error counts as one
  // sample.
  SampleRange range{0, 1};
  std::uint32_t samples = 1;
  bool isComplete = false;  // all that was asked for is in it
  // The pass that the render is in: its samples (kFixed), how many of its work items are done, and how many
  // of the others follow the pixels (kTarget).
  std::uint32_t roundFirst = 0;
  std::uint32_t roundSize = 0;
  std::uint64_t itemsDone = 0;
  std::uint64_t itemsPending = 0;
};

}  // namespace lavaray
