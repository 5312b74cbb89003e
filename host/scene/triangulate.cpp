#include "scene/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/vector_math.hpp"

namespace lavaray {
namespace {

// The power of two that scales a length > 0 into [0.5, 1), so that products of two such lengths neither
// underflow nor overflow. It changes no digit. Kept as two factors, because the one for the smallest double
// is not itself a double.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(double length) {
    const int exponent = -std::ilogb(length) - 1;
    const int first = std::min(exponent, std::numeric_limits<double>::max_exponent - 1);
    first_ = std::ldexp(1.0, first);
    second_ = std::ldexp(1.0, exponent - first);
  }
  glm::dvec3 operator*(const glm::dvec3& v) const { return first_ * v * second_; }

 private:
  double first_;
  double second_;
};

// Twice the signed area of the triangle, positive if it runs anticlockwise.
double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The border counts as inside. The triangle must run anticlockwise.
bool contains(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p) {
  return twiceArea(a, b, p) >= 0.0 && twiceArea(b, c, p) >= 0.0 && twiceArea(c, a, p) >= 0.0;
}

}  // namespace

bool hasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 zero(0.0);
  if (glm::cross(ab, ac) != zero) return true;
  // For a tiny triangle the products underflow.
  const double largestAb = largestComponent(ab);
  const double largestAc = largestComponent(ac);
  if (largestAb == 0.0 || largestAc == 0.0) return false;
  return glm::cross(PowerOfTwo(largestAb) * ab, PowerOfTwo(largestAc) * ac) != zero;
}

// Ear clipping: G. H. Meisters, "Polygons Have Ears" (1975), with the bookkeeping of J. O'Rourke,
// "Computational Geometry in C" (1998): clipping an ear changes the shape of its two neighbours only, and if
// any corner lies in a triangle, one that is not convex does. O(corners x corners that are not convex).
const std::vector<Triangulator::Corners>& Triangulator::triangulate(std::span<const glm::dvec3> polygon) {
  triangles_.clear();
  if (polygon.size() == 3) {
    if (hasArea(polygon[0], polygon[1], polygon[2])) triangles_.push_back({0, 1, 2});
    return triangles_;
  }
  if (!project(polygon)) return triangles_;
  link();
  classifyAll();
  bool isFresh = true;
  bool crossesItself = false;
  while (left_ >= 3) {
    if (clipEars()) {
      isFresh = false;
    } else if (!isFresh && !crossesItself) {
      // A corner that touches the border elsewhere may have hidden an ear that was not its neighbour.
      classifyAll();
      isFresh = true;
    } else {
      const std::uint32_t corner = fallbackCorner();
      crossesItself = crossesItself || twiceAreaAt(corner) != 0.0;
      clip(corner);
    }
  }
  // Coincident and collinear corners got triangles too, because what looks collinear in the projection need
  // not be.
  std::erase_if(triangles_,
                [&](const Corners& t) { return !hasArea(polygon[t[0]], polygon[t[1]], polygon[t[2]]); });
  return triangles_;
}

// Fills points_ with the polygon projected onto an axis plane, anticlockwise. False if it has no area.
bool Triangulator::project(std::span<const glm::dvec3> polygon) {
  // Relative to a corner, so that a small face far from the origin loses no digits.
  relative_.resize(polygon.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    relative_[i] = polygon[i] - polygon[0];
    largest = std::max(largest, largestComponent(relative_[i]));
  }
  if (largest == 0.0) return false;
  const PowerOfTwo scale(largest);
  for (glm::dvec3& corner : relative_) corner = scale * corner;

  // Twice the area as a vector: M. E. Newell's method, in I. E. Sutherland, R. F. Sproull, R. A. Schumacker,
  // "A Characterization of Ten Hidden-Surface Algorithms" (1974).
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) normal += glm::cross(relative_[i], relative_[i + 1]);
  if (normal == glm::dvec3(0.0)) return false;

  const glm::dvec3 size = glm::abs(normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  int u = (dropped + 1) % 3;
  int v = (dropped + 2) % 3;
  if (normal[dropped] < 0.0) std::swap(u, v);
  points_.clear();
  for (const glm::dvec3& corner : relative_) points_.emplace_back(corner[u], corner[v]);
  return true;
}

void Triangulator::link() {
  left_ = static_cast<std::uint32_t>(points_.size());
  first_ = 0;
  previous_.resize(left_);
  next_.resize(left_);
  for (std::uint32_t i = 0; i < left_; ++i) {
    previous_[i] = i == 0 ? left_ - 1 : i - 1;
    next_[i] = i + 1 == left_ ? 0 : i + 1;
  }
  shapes_.resize(left_);
}

double Triangulator::twiceAreaAt(std::uint32_t corner) const {
  return twiceArea(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

void Triangulator::classifyAll() {
  notConvex_.clear();
  for (std::uint32_t i = 0, corner = first_; i < left_; ++i, corner = next_[corner]) {
    shapes_[corner] = twiceAreaAt(corner) > 0.0 ? Shape::kConvex : Shape::kNotConvex;
    if (shapes_[corner] == Shape::kNotConvex) notConvex_.push_back(corner);
  }
  for (std::uint32_t i = 0, corner = first_; i < left_; ++i, corner = next_[corner]) {
    if (shapes_[corner] == Shape::kConvex && !isBlocked(corner)) shapes_[corner] = Shape::kEar;
  }
}

void Triangulator::classify(std::uint32_t corner) {
  if (twiceAreaAt(corner) > 0.0) {
    shapes_[corner] = isBlocked(corner) ? Shape::kConvex : Shape::kEar;
  } else if (shapes_[corner] != Shape::kNotConvex) {
    shapes_[corner] = Shape::kNotConvex;
    notConvex_.push_back(corner);
  }
}

// Whether the triangle at a convex corner contains another corner, so that its third side would leave the
// polygon. Corners that coincide with one of the triangle's own do not count: otherwise nothing could be
// clipped where a polygon visits a point twice (at a bridge to a hole, say).
bool Triangulator::isBlocked(std::uint32_t corner) {
  const glm::dvec2 a = points_[previous_[corner]];
  const glm::dvec2 b = points_[corner];
  const glm::dvec2 c = points_[next_[corner]];
  for (std::size_t i = 0; i < notConvex_.size();) {
    const std::uint32_t other = notConvex_[i];
    if (shapes_[other] != Shape::kNotConvex) {
      notConvex_[i] = notConvex_.back();
      notConvex_.pop_back();
      continue;
    }
    ++i;
    const glm::dvec2 p = points_[other];
    if (p != a && p != b && p != c && contains(a, b, c, p)) return true;
  }
  return false;
}

void Triangulator::clip(std::uint32_t corner) {
  const std::uint32_t before = previous_[corner];
  const std::uint32_t after = next_[corner];
  triangles_.push_back({before, corner, after});
  shapes_[corner] = Shape::kClipped;
  next_[before] = after;
  previous_[after] = before;
  if (first_ == corner) first_ = after;
  --left_;
  classify(before);
  classify(after);
}

// False if there was none.
bool Triangulator::clipEars() {
  bool found = false;
  // Starting after the first corner turns a convex polygon into its fan.
  std::uint32_t corner = next_[first_];
  for (std::uint32_t misses = 0; left_ >= 3 && misses < left_;) {
    const std::uint32_t after = next_[corner];
    if (shapes_[corner] == Shape::kEar) {
      clip(corner);
      found = true;
      misses = 0;
    } else {
      ++misses;
    }
    corner = after;
  }
  return found;
}

// The corner to clip when no ear is left: preferably one that coincides with a neighbour or is collinear with
// both, which costs nothing. Otherwise sides cross, if only in the projection, and triangles are bound to
// overlap. Leaving one out instead would tear a hole into a mesh whose faces are not flat.
std::uint32_t Triangulator::fallbackCorner() const {
  std::optional<std::uint32_t> convex;
  for (std::uint32_t i = 0, corner = first_; i < left_; ++i, corner = next_[corner]) {
    const double area = twiceAreaAt(corner);
    if (area == 0.0) return corner;
    if (area > 0.0 && !convex) convex = corner;
  }
  return convex.value_or(first_);
}

}  // namespace lavaray
