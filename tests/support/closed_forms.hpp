#pragma once

#include <array>
#include <cstddef>

namespace lavaray {

// Answers in double precision that sampled images can be held against.

// A half-plane that ends in a straight edge covers of a light's cone what lies beyond the plane through the
// point and the edge: the share of a cone of half angle `a` whose axis is at the angle `b` to that plane.
double capBeyond(double a, double b);

// The share of the cone of half angle `a` that lies within the cone of half angle `b`, both with their tip in
// the same point and the angle `between` their axes: what a ball hides of a spherical light behind it.
double capWithin(double a, double b, double between);

// Area of the part of the square [x, x + 1] x [y, y + 1] in which normalX X + normalY Y >= distance.
double halfPlaneCoverage(double x, double y, double normalX, double normalY, double distance);

// Nodes and weights of Gauss's rule on [0, 1], exact for polynomials of degree 9.
inline constexpr std::array<double, 5> kGaussNodes = {0.046910077030668004, 0.23076534494715845, 0.5,
                                                      0.76923465505284155, 0.953089922969332};
inline constexpr std::array<double, 5> kGaussWeights = {
    0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.11846344252809454};

// Mean of a smooth function over the square [x, x + 1] x [y, y + 1].
template <typename Function>
double meanOverSquare(double x, double y, const Function& function) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
    for (std::size_t j = 0; j < kGaussNodes.size(); ++j) {
      sum += kGaussWeights[i] * kGaussWeights[j] * function(x + kGaussNodes[i], y + kGaussNodes[j]);
    }
  }
  return sum;
}

}  // namespace lavaray
