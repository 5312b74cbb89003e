#include "sampling/discoveries.hpp"

namespace lavaray {
namespace {

// Before anything is measured.
constexpr double kUsualShare = 0.05;
// What is known of fewer samples counts as much as so many trials, since finds are rare.
constexpr double kUsualTrials = 64.0;
// What is suspected falls as n^-2: a doubling takes three quarters of it away.
constexpr double kFallOfDoubling = 0.75;

}  // namespace

void Discoveries::add(int sampleStep, double suspected, double squaredDifference) {
  const auto step = static_cast<std::size_t>(sampleStep);
  suspected_[step] += suspected;
  squares_[step] += suspected * suspected;
  found_[step] += squaredDifference / kFallOfDoubling;
}

Discoveries::Sums Discoveries::shares() const {
  Sums shares{};
  double share = kUsualShare;
  for (std::size_t step = 0; step < shares.size(); ++step) {
    if (suspected_[step] > 0.0) {
      const double usual = kUsualTrials * squares_[step] / suspected_[step];
      share = (found_[step] + usual * share) / (suspected_[step] + usual);
    }
    shares[step] = share;
  }
  return shares;
}

}  // namespace lavaray
