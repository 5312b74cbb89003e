#include "core/obj_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <istream>
#include <limits>
#include <span>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <tiny_obj_loader.h>

#include "core/obj_statement.hpp"
#include "core/place.hpp"
#include "core/text_file.hpp"
#include "core/triangulate.hpp"

namespace lavaray {
namespace {

constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

// Counted from 0. What they point at may come later in the file.
struct Corner {
  std::uint32_t position;
  std::uint32_t texcoord;  // or kAbsent, as is the normal
  std::uint32_t normal;
};

struct Face {
  std::size_t firstCorner;
  std::size_t line;
};

// Gives tinyobjloader the file line by line, each of them checked first. Its callbacks then run while the
// line is the current one, which is how they come to know the line number.
class LineSource : public std::streambuf {
 public:
  LineSource(std::string text, const std::filesystem::path& file)
      : text_(withFinalNewline(std::move(text))), lines_(text_), file_(file) {}

  [[nodiscard]] const ObjLine& checked() const { return checked_; }
  [[nodiscard]] Place place() const { return {file_, std::max<std::size_t>(lines_.lineNumber(), 1)}; }

 protected:
  int_type underflow() override {
    if (!lines_.next()) return traits_type::eof();
    const std::string_view line = withoutComment(lines_.line());
    checked_ = checkObjLine(line, place());
    char* const begin = text_.data() + (line.data() - text_.data());
    char* const end = begin + line.size();
    *end = '\n';  // in place of the line's own end or of its comment
    setg(begin, begin, end + 1);
    return traits_type::to_int_type(*begin);
  }

 private:
  static std::string withFinalNewline(std::string text) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    return text;
  }

  std::string text_;
  Lines lines_;
  const std::filesystem::path& file_;
  ObjLine checked_;
};

// What tinyobjloader's callbacks collect.
struct Content {
  const LineSource& source;
  std::vector<glm::dvec3> positions{};
  std::vector<glm::dvec3> normals{};
  std::size_t texcoordCount = 0;
  std::vector<Corner> corners{};
  std::vector<Face> faces{};
};

[[noreturn]] void failOutOfRange(const Place& place, std::string_view what, long long index,
                                 std::size_t count) {
  failAt(place, std::string(what) + " " + std::to_string(index) + " is out of range, there are " +
                    std::to_string(count));
}

// A negative index counts back from what has been read so far.
std::uint32_t resolve(int index, std::size_t countSoFar, std::string_view what, const Place& place) {
  if (index == 0) return kAbsent;
  if (index > 0) return static_cast<std::uint32_t>(index - 1);
  const long long resolved = static_cast<long long>(countSoFar) + index;
  if (resolved < 0) failOutOfRange(place, what, index, countSoFar);
  return static_cast<std::uint32_t>(resolved);
}

void addFace(Content& content, const tinyobj::index_t* indices, int count) {
  const Place place = content.source.place();
  content.faces.push_back({content.corners.size(), place.line});
  for (int i = 0; i < count; ++i) {
    content.corners.push_back(
        {resolve(indices[i].vertex_index, content.positions.size(), "vertex", place),
         resolve(indices[i].texcoord_index, content.texcoordCount, "texture coordinate", place),
         resolve(indices[i].normal_index, content.normals.size(), "normal", place)});
  }
}

// The numbers of the current line. Those that tinyobjloader hands to its callbacks can be off by some units
// in the last place, as it adds up decimal digits one by one.
glm::dvec3 currentVector(const Content& content) {
  const ObjLine& line = content.source.checked();
  return {line.numbers[0], line.numbers[1], line.numbers[2]};
}

void parse(LineSource& source, Content& content) {
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = [](void* user, double, double, double, double) {
    auto& to = *static_cast<Content*>(user);
    to.positions.push_back(currentVector(to));
  };
  callbacks.normal_cb = [](void* user, double, double, double) {
    auto& to = *static_cast<Content*>(user);
    to.normals.push_back(currentVector(to));
  };
  callbacks.texcoord_cb = [](void* user, double, double, double) {
    ++static_cast<Content*>(user)->texcoordCount;
  };
  callbacks.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
    addFace(*static_cast<Content*>(user), indices, count);
  };
  std::istream stream(&source);
  stream.exceptions(std::ios::badbit);  // else it would swallow the errors thrown by the source
  // Without a reader of materials no .mtl file is opened.
  tinyobj::LoadObjWithCallback(stream, callbacks, &content, nullptr, nullptr, nullptr);
}

void checkRange(const Content& content, const Corner& corner, const Place& place) {
  const auto check = [&](std::uint32_t index, std::size_t count, std::string_view what) {
    if (index != kAbsent && index >= count) failOutOfRange(place, what, index + 1LL, count);
  };
  check(corner.position, content.positions.size(), "vertex");
  check(corner.texcoord, content.texcoordCount, "texture coordinate");
  check(corner.normal, content.normals.size(), "normal");
}

void addTriangles(const Content& content, const std::filesystem::path& file, Mesh& mesh) {
  Triangulator triangulator;
  std::vector<glm::dvec3> polygon;
  for (std::size_t i = 0; i < content.faces.size(); ++i) {
    const Face& face = content.faces[i];
    const std::size_t end =
        i + 1 < content.faces.size() ? content.faces[i + 1].firstCorner : content.corners.size();
    const std::span corners(content.corners.data() + face.firstCorner, end - face.firstCorner);

    bool hasNormals = true;
    polygon.clear();
    for (const Corner& corner : corners) {
      checkRange(content, corner, {file, face.line});
      polygon.push_back(content.positions[corner.position]);
      hasNormals = hasNormals && corner.normal != kAbsent;
    }

    const auto& triangles = triangulator.triangulate(polygon);
    for (const auto& [a, b, c] : triangles) {
      MeshTriangle triangle{.positions = {corners[a].position, corners[b].position, corners[c].position}};
      if (hasNormals) triangle.normals = {corners[a].normal, corners[b].normal, corners[c].normal};
      mesh.triangles.push_back(triangle);
    }
    mesh.degenerateTriangles += corners.size() - 2 - triangles.size();
  }
}

std::string readText(const std::filesystem::path& file) {
  try {
    return readFile(file);
  } catch (const std::system_error& error) {
    throw UnreadableFile(ExitCode::kInput,
                         printable(file.native()) + ": cannot be read: " + error.code().message());
  }
}

}  // namespace

Mesh readObj(const std::filesystem::path& file) {
  return parseObj(readText(file), file);
}

Mesh parseObj(std::string text, const std::filesystem::path& file) {
  rejectNulBytes(text, file);
  LineSource source(std::move(text), file);
  Content content{.source = source};
  parse(source, content);

  Mesh mesh;
  mesh.file = file;
  addTriangles(content, file, mesh);
  if (mesh.triangles.empty())
    failAt(source.place(), "no face with an area, allowed is a mesh of at least one");
  mesh.positions = std::move(content.positions);
  mesh.normals = std::move(content.normals);
  return mesh;
}

}  // namespace lavaray
