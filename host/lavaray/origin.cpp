#include "lavaray/origin.hpp"

#include <limits>
#include <sstream>

#include "command_line/version.hpp"

namespace lavaray {
namespace {

std::string describe(const ImageSize& size, const std::optional<Rectangle>& crop) {
  std::ostringstream text;
  text << size.width << " x " << size.height;
  if (crop) text << ", pixels " << crop->x0 << ',' << crop->y0 << " to " << crop->x1 << ',' << crop->y1;
  return text.str();
}

std::string describe(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

std::optional<std::string> describeScale(View view, const Statistics& result) {
  if (view != View::kCost) return std::nullopt;
  if (result.largestMeasure <= 0.0) return "no ray tests a node or a primitive";
  std::ostringstream text;
  // The very number that the values were divided by.
  text.precision(std::numeric_limits<float>::max_digits10);
  text << "white is " << result.largestMeasure << " nodes and primitives tested for a sample";
  return text.str();
}

TextEntries describeOrigin(const Options& options, const ImageSize& size, const std::string& device) {
  const RenderOptions& render = options.render;
  TextEntries entries = {{"Software", std::string("lavaray ") + kVersion},
                         {"Scene", options.scene.filename().string()},  // without the user's folders
                         {"Size", describe(size, render.crop)},
                         {"Seed", std::to_string(render.seed)},
                         {"Device", device}};
  if (render.view != View::kColor) entries.emplace_back("View", name(render.view));
  return entries;
}

TextEntries describeOutcome(View view, const Statistics& result, double seconds) {
  TextEntries entries = {
      // The mean: a render to a target error, or one that was stopped, takes them where they help most.
      {"Samples per pixel", describe(result.samplesPerPixel)},
      {"Seconds", describe(seconds)}};
  if (result.stopReason != StopReason::kFinished) entries.emplace_back("Stopped", name(result.stopReason));
  if (const auto scale = describeScale(view, result)) entries.emplace_back("Scale", *scale);
  return entries;
}

}  // namespace lavaray
