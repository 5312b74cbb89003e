#include "core/obj_statement.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "core/limits.hpp"
#include "core/numbers.hpp"
#include "core/text_file.hpp"

namespace lavaray {
namespace {

void readNumbers(std::string_view rest, std::string_view keyword,
                 std::initializer_list<std::size_t> allowedCounts, const Place& place, ObjLine& result) {
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
    const double number = parseNumber(word, place);
    if (result.count < result.numbers.size()) result.numbers[result.count] = number;
    ++result.count;
  }
  if (std::ranges::find(allowedCounts, result.count) != allowedCounts.end()) return;
  std::string allowed;
  for (const std::size_t count : allowedCounts) {
    if (!allowed.empty()) allowed += count == *(allowedCounts.end() - 1) ? " or " : ", ";
    allowed += std::to_string(count);
  }
  failAt(place,
         ticked(keyword) + " has " + std::to_string(result.count) + " numbers, allowed are " + allowed);
}

void checkIndex(std::string_view text, std::string_view corner, const Place& place) {
  const bool isDigits = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  const auto index = parseInteger(text);
  if (index && *index != 0) return;
  if (index)
    failAt(place, "index 0 in " + quoted(corner) + ", allowed are 1, 2, ... or -1, -2, ... from the end");
  if (isDigits) failAt(place, "index " + quoted(text) + " is out of range");
  failAt(place, quoted(corner) + " is not a corner of a face, allowed are v, v/vt, v//vn and v/vt/vn");
}

void checkCorner(std::string_view corner, const Place& place) {
  const std::size_t slash = corner.find('/');
  checkIndex(corner.substr(0, slash), corner, place);
  if (slash == std::string_view::npos) return;
  const std::string_view rest = corner.substr(slash + 1);
  const std::size_t secondSlash = rest.find('/');
  if (secondSlash != 0) checkIndex(rest.substr(0, secondSlash), corner, place);
  if (secondSlash != std::string_view::npos) checkIndex(rest.substr(secondSlash + 1), corner, place);
}

}  // namespace

std::string_view withoutComment(std::string_view line) {
  for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1)) {
    if (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t') return line.substr(0, i);
  }
  return line;
}

ObjLine checkObjLine(std::string_view line, const Place& place) {
  ObjLine result;
  std::string_view rest = line;
  const std::string_view keyword = takeWord(rest);
  if (keyword == "v") {
    // x y z, then w or a colour or both: only x y z matter here.
    result.statement = ObjStatement::kVertex;
    readNumbers(rest, keyword, {3, 4, 6, 7}, place, result);
  } else if (keyword == "vt") {
    result.statement = ObjStatement::kTexcoord;
    readNumbers(rest, keyword, {1, 2, 3}, place, result);
  } else if (keyword == "vn") {
    result.statement = ObjStatement::kNormal;
    readNumbers(rest, keyword, {3}, place, result);
  } else if (keyword == "f") {
    result.statement = ObjStatement::kFace;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      checkCorner(word, place);
      ++result.count;
    }
    if (result.count < 3 || result.count > kMaxFaceCorners) {
      failAt(place, "a face of " + std::to_string(result.count) + " corners, allowed are 3 to " +
                        std::to_string(kMaxFaceCorners));
    }
  }
  return result;
}

}  // namespace lavaray
