#include "scene/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <exception>
#include <mutex>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "base/parallel.hpp"
#include "base/text_blocks.hpp"
#include "base/text_lines.hpp"
#include "base/text_location.hpp"
#include "base/vector_math.hpp"
#include "scene/obj_part.hpp"
#include "scene/obj_triangles.hpp"

namespace lavaray {
namespace {

// Reads the parts of a text, in order.
class PartsReader {
 public:
  PartsReader(ReadBytes read, std::size_t partBytes) : blocks_(std::move(read), partBytes) {}

  std::deque<ObjPart> read() {
    readSome(true);  // a small file needs no threads
    if (!blocks_.isAtEnd()) {
      const unsigned threads = hardwareThreads();
      parallelFor(threads, threads, [this](std::size_t) { readSome(false); });
    }
    if (error_) std::rethrow_exception(error_);
    return std::move(parts_);
  }

 private:
  void readSome(bool onlyOne) {
    try {
      std::vector<char> buffer;
      ObjPart part;
      while (const auto block = isNoText_ ? std::nullopt : blocks_.next(buffer)) {
        scanObjPart(block->text, block->number == 0, part);
        // The blocks before this one are being read already; what follows may never end, as with a device.
        if (part.lineOfNul) isNoText_ = true;
        // Keeps a copy, because a copy has no spare capacity.
        slot(block->number) = part;
        if (onlyOne) return;
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      error_ = std::current_exception();
    }
  }

  ObjPart& slot(std::size_t number) {
    const std::scoped_lock lock(mutex_);
    if (parts_.size() <= number) parts_.resize(number + 1);
    return parts_[number];
  }

  TextBlocks blocks_;
  std::atomic<bool> isNoText_{false};
  std::mutex mutex_;
  std::deque<ObjPart> parts_;  // a deque: its elements do not move as it grows
  std::exception_ptr error_;
};

std::vector<ObjCounts> countBefore(const std::deque<ObjPart>& parts) {
  std::vector<ObjCounts> counts(1);
  for (const ObjPart& part : parts) {
    const ObjCounts& last = counts.back();
    counts.push_back({last.lines + part.lines, last.positions + part.positions.size(),
                      last.normals + part.normals.size(), last.triangles + maxTriangles(part)});
  }
  return counts;
}

// Throws the first error in the file that can be found without following an index. But a NUL byte takes
// precedence over everything else, since it means that the file is not text.
void failIfWrong(const std::deque<ObjPart>& parts, const std::vector<ObjCounts>& before,
                 const std::filesystem::path& file) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].lineOfNul) failAtNulByte({file, before[i].lines + *parts[i].lineOfNul});
  }
  const auto wrong = std::ranges::find_if(parts, [](const ObjPart& part) { return part.error != nullptr; });
  if (wrong == parts.end()) return;
  const auto last = static_cast<std::size_t>(wrong - parts.begin());
  for (std::size_t i = 0; i <= last; ++i) checkBackReferences(parts[i], before[i], file);
  try {
    std::rethrow_exception(wrong->error);
  } catch (const ObjProblem& problem) {
    failAt({file, before[last].lines + problem.line}, problem.message);
  }
}

// Moves all positions and normals out of the parts.
ObjWhole join(std::deque<ObjPart>& parts, const ObjCounts& counts, const std::filesystem::path& file) {
  ObjWhole whole;
  whole.mesh.file = file;
  whole.mesh.positions.reserve(counts.positions);
  whole.mesh.normals.reserve(counts.normals);
  for (ObjPart& part : parts) {
    const std::vector<glm::dvec3> positions = std::move(part.positions);
    const std::vector<glm::dvec3> normals = std::move(part.normals);
    whole.mesh.positions.insert(whole.mesh.positions.end(), positions.begin(), positions.end());
    whole.mesh.normals.insert(whole.mesh.normals.end(), normals.begin(), normals.end());
    whole.hasInfinitePositions = whole.hasInfinitePositions || part.hasInfinitePositions;
    whole.hasZeroNormals = whole.hasZeroNormals || part.hasZeroNormals;
  }
  return whole;
}

std::vector<ObjTriangles> addTriangles(std::deque<ObjPart>& parts, const std::vector<ObjCounts>& before,
                                       ObjWhole& whole) {
  std::vector<MeshTriangle> triangles(before.back().triangles);
  std::vector<ObjTriangles> results(parts.size());
  parallelFor(parts.size(), hardwareThreads(), [&](std::size_t i) {
    const std::size_t max = before[i + 1].triangles - before[i].triangles;
    results[i] =
        makeTriangles(parts[i], before[i], whole, std::span(triangles).subspan(before[i].triangles, max));
    parts[i] = {};
  });
  // Closes the gaps that degenerate triangles leave.
  auto end = triangles.begin();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (results[i].error) std::rethrow_exception(results[i].error);
    const auto first = triangles.begin() + static_cast<std::ptrdiff_t>(before[i].triangles);
    const auto last = first + static_cast<std::ptrdiff_t>(results[i].count);
    end = first == end ? last : std::move(first, last, end);
    whole.mesh.degenerateTriangles += results[i].degenerate;
  }
  triangles.erase(end, triangles.end());
  whole.mesh.triangles = std::move(triangles);
  return results;
}

std::string changeText(ObjChange change, const ObjChanges& changes) {
  const bool isOne = changes.faces == 1;
  const std::string faces = std::to_string(changes.faces) + (isOne ? " face" : " faces");
  const std::string first = isOne ? "" : ", the first in this line";
  if (change == ObjChange::kFaceDropped)
    return faces + " of one or two corners " + (isOne ? "is" : "are") + " dropped" + first;
  const std::string own = faces + (isOne ? " has its" : " have their") + " own normal" + first + ": ";
  if (change == ObjChange::kNormalMissing) return own + "an index of a normal is 0 or out of range";
  if (change == ObjChange::kNormalZero) return own + "a normal is zero or not finite";
  return own + "only some corners have a normal";
}

void addWarnings(const std::vector<ObjTriangles>& parts, Mesh& mesh) {
  for (const ObjChange change : kObjChanges) {
    ObjChanges all;
    for (const ObjTriangles& part : parts) {
      if (all.faces == 0) all.firstLine = part.of(change).firstLine;
      all.faces += part.of(change).faces;
    }
    if (all.faces > 0)
      mesh.warnings.push_back(messageAt({mesh.file, all.firstLine}, changeText(change, all)));
  }
}

Mesh readMesh(const ReadBytes& read, const std::filesystem::path& file, std::size_t partBytes) {
  std::deque<ObjPart> parts = PartsReader(read, partBytes).read();
  const std::vector<ObjCounts> before = countBefore(parts);
  failIfWrong(parts, before, file);
  ObjWhole whole = join(parts, before.back(), file);
  const std::vector<ObjTriangles> triangles = addTriangles(parts, before, whole);
  Mesh mesh = std::move(whole.mesh);
  if (mesh.triangles.empty()) {
    const std::size_t lastLine = std::max<std::size_t>(before.back().lines, 1);
    failAt({file, lastLine}, "no face with an area, allowed is a mesh of at least one");
  }
  addWarnings(triangles, mesh);
  // No face uses a position that is not finite.
  if (whole.hasInfinitePositions)
    std::ranges::replace_if(
        mesh.positions, [](const glm::dvec3& p) { return !isFinite(p); }, glm::dvec3(0.0));
  return mesh;
}

}  // namespace

Mesh readObj(const std::filesystem::path& file) {
  // Catches only what opening and reading throw: a thread that cannot be started is not the file's fault.
  const auto orUnreadable = [&](const auto& read) {
    try {
      return read();
    } catch (const std::system_error& error) {
      failUnreadable(file, error);
    }
  };
  ByteReader reader = orUnreadable([&] { return ByteReader(file); });
  return readMesh([&](std::span<char> bytes) { return orUnreadable([&] { return reader.read(bytes); }); },
                  file, kObjPartBytes);
}

Mesh parseObj(std::string_view text, const std::filesystem::path& file, std::size_t partBytes) {
  const auto read = [&text](std::span<char> bytes) {
    const std::size_t count = text.copy(bytes.data(), bytes.size());
    text.remove_prefix(count);
    return count;
  };
  return readMesh(read, file, partBytes);
}

}  // namespace lavaray
