#include "render/view.hpp"

#include <array>
#include <cassert>
#include <utility>

namespace lavaray {
namespace {

constexpr std::array<std::pair<const char*, View>, 8> kNames = {{{"color", View::kColor},
                                                                 {"normal", View::kNormal},
                                                                 {"depth", View::kDepth},
                                                                 {"object", View::kObject},
                                                                 {"shadow", View::kShadow},
                                                                 {"cost", View::kCost},
                                                                 {"samples", View::kSamples},
                                                                 {"error", View::kError}}};

}  // namespace

std::optional<View> viewNamed(const std::string& name) {
  for (const auto& [known, view] : kNames) {
    if (name == known) return view;
  }
  return std::nullopt;
}

std::string viewName(View view) {
  const auto& [name, named] = kNames[static_cast<std::size_t>(view)];
  assert(named == view);
  return name;
}

gpu::uint tracedView(View view) {
  switch (view) {
    case View::kNormal:
      return gpu::kViewNormal;
    case View::kDepth:
      return gpu::kViewDepth;
    case View::kObject:
      return gpu::kViewObject;
    case View::kShadow:
      return gpu::kViewShadow;
    case View::kCost:
      return gpu::kViewCost;
    case View::kColor:
    case View::kSamples:
    case View::kError:
      break;
  }
  return gpu::kViewColor;
}

bool tracesMirrors(View view) {
  return tracedView(view) == gpu::kViewColor || view == View::kCost;
}

bool tracesLights(View view) {
  return tracesMirrors(view) || view == View::kShadow;
}

bool isMeasure(View view) {
  return view == View::kDepth || view == View::kCost;
}

double measure(View view, const glm::dvec3& sum, std::uint32_t samples) {
  if (view == View::kCost) return samples > 0 ? sum.x / samples : 0.0;
  // Samples that hit nothing have no distance; the background's is 0.
  return sum.y > 0.0 ? sum.x / sum.y : 0.0;
}

}  // namespace lavaray
