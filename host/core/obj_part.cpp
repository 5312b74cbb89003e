#include "core/obj_part.hpp"

#include <istream>
#include <streambuf>
#include <string>
#include <string_view>

#include <tiny_obj_loader.h>

#include "core/errors.hpp"
#include "core/obj_statement.hpp"
#include "core/place.hpp"
#include "core/text_file.hpp"

namespace lavaray {
namespace {

// Gives tinyobjloader the text line by line, each of them checked first. Its callbacks then run while the
// line is the current one, which is how they come to know the line number.
class LineSource : public std::streambuf {
 public:
  LineSource(std::span<char> text, std::size_t linesBefore, const std::filesystem::path& file)
      : text_(text), lines_({text.data(), text.size()}, linesBefore), file_(file) {}

  [[nodiscard]] const ObjLine& checked() const { return checked_; }
  [[nodiscard]] std::size_t lineNumber() const { return lines_.lineNumber(); }

 protected:
  int_type underflow() override {
    if (!lines_.next()) return traits_type::eof();
    const std::string_view line = withoutComment(lines_.line());
    checked_ = checkObjLine(line, {file_, lines_.lineNumber()});
    char* const begin = text_.data() + (line.data() - text_.data());
    char* const end = begin + line.size();
    *end = '\n';  // in place of the line's own end or of its comment
    setg(begin, begin, end + 1);
    return traits_type::to_int_type(*begin);
  }

 private:
  std::span<char> text_;
  Lines lines_;
  const std::filesystem::path& file_;
  ObjLine checked_;
};

struct Reading {
  const LineSource& source;
  ObjPart& part;
};

void addCorner(ObjPart& part, const std::array<int, 3>& indices) {
  const std::array<std::size_t, 3> counts{part.positions.size(), part.texcoords, part.normals.size()};
  ObjCorner corner{};
  for (const ObjArray array : {kObjPosition, kObjTexcoord, kObjNormal}) {
    const int index = indices[array];
    if (index < 0) {
      part.backReferences.push_back({part.faces.size() - 1, part.corners.size(), array, index});
      corner[array] = static_cast<std::uint32_t>(counts[array]);
    } else {
      corner[array] = index == 0 ? kObjAbsent : static_cast<std::uint32_t>(index - 1);
    }
  }
  part.corners.push_back(corner);
}

// The numbers of the current line. Those that tinyobjloader hands to its callbacks can be off by some units
// in the last place, as it adds up decimal digits one by one.
glm::dvec3 currentVector(const Reading& reading) {
  const ObjLine& line = reading.source.checked();
  return {line.numbers[0], line.numbers[1], line.numbers[2]};
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t result;
  result.vertex_cb = [](void* user, double, double, double, double) {
    const auto& to = *static_cast<Reading*>(user);
    to.part.positions.push_back(currentVector(to));
  };
  result.normal_cb = [](void* user, double, double, double) {
    const auto& to = *static_cast<Reading*>(user);
    to.part.normals.push_back(currentVector(to));
  };
  result.texcoord_cb = [](void* user, double, double, double) {
    ++static_cast<Reading*>(user)->part.texcoords;
  };
  result.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
    const auto& to = *static_cast<Reading*>(user);
    to.part.faces.push_back({to.part.corners.size(), to.source.lineNumber()});
    for (const tinyobj::index_t& index : std::span(indices, static_cast<std::size_t>(count))) {
      addCorner(to.part, {index.vertex_index, index.texcoord_index, index.normal_index});
    }
  };
  return result;
}

}  // namespace

ObjPart readObjPart(std::span<char> text, std::size_t linesBefore, const std::filesystem::path& file) {
  ObjPart part;
  part.linesBefore = linesBefore;
  LineSource source(text, linesBefore, file);
  Reading reading{source, part};
  std::istream stream(&source);
  stream.exceptions(std::ios::badbit);  // else it would swallow the errors thrown by the source
  try {
    // Without a reader of materials no .mtl file is opened.
    tinyobj::LoadObjWithCallback(stream, callbacks(), &reading, nullptr, nullptr, nullptr);
  } catch (...) {
    part.error = std::current_exception();
  }
  part.lastLine = source.lineNumber();
  return part;
}

}  // namespace lavaray
