#include "forms.hpp"

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <string>

namespace {

// The number of vertices around and along the torus, and of quads.
constexpr int kSide = 1000;
constexpr int kVertices = kSide * kSide;

template <typename... Values>
void print(std::ostream& out, const char* format, Values... values) {
  std::array<char, 128> line{};
  const int length = std::snprintf(line.data(), line.size(), format, values...);
  out.write(line.data(), length);
}

void writeVertices(bool onlyPositions, std::ostream& out) {
  constexpr double kStep = 2.0 * std::numbers::pi / kSide;
  for (int i = 0; i < kVertices; ++i) {
    const double around = kStep * (i / kSide);
    const double along = kStep * (i % kSide);
    const double radius = 0.4 + 0.02 * std::sin(37.0 * around) * std::sin(23.0 * along);
    const double distance = 1.0 + radius * std::cos(along);
    print(out, "v %.6f %.6f %.6f\n", distance * std::cos(around), distance * std::sin(around),
          radius * std::sin(along));
    if (onlyPositions) continue;
    print(out, "vt %.6f %.6f\n", around * std::numbers::inv_pi, along * std::numbers::inv_pi);
    print(out, "vn %.6f %.6f %.6f\n", std::cos(along) * std::cos(around), std::cos(along) * std::sin(around),
          std::sin(along));
  }
}

// Negative indices count back from the file's last vertex.
void writeFace(std::initializer_list<int> vertices, std::string_view form, std::ostream& out) {
  out << 'f';
  for (const int vertex : vertices) {
    const int index = form == "negative" ? vertex - kVertices : vertex + 1;
    if (form == "v") {
      print(out, " %d", index);
    } else {
      print(out, " %d/%d/%d", index, index, index);
    }
  }
  out << '\n';
}

}  // namespace

void writeMesh(std::string_view form, std::ostream& out) {
  writeVertices(form == "v", out);
  for (int i = 0; i < kVertices; ++i) {
    const int right = i % kSide + 1 == kSide ? i + 1 - kSide : i + 1;
    const int above = (i + kSide) % kVertices;
    const int opposite = (right + kSide) % kVertices;
    if (form == "quads") {
      writeFace({i, above, opposite, right}, form, out);
    } else {
      writeFace({i, above, opposite}, form, out);
      writeFace({i, opposite, right}, form, out);
    }
  }
}
