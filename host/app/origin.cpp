#include "app/origin.hpp"

#include <sstream>

#include "app/version.hpp"

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

TextEntries describeOrigin(const Options& options, const RenderSettings& settings,
                           const RenderStatistics& result, const std::string& device, double seconds) {
  TextEntries entries = {
      {"Software", std::string("lavaray ") + kVersion},
      {"Scene", options.scene.filename().string()},  // without the folders of who made it
      {"Size", describe(settings.size, options.crop)},
      // In the mean; a render to a target error, or one that was stopped, takes them where they help most.
      {"Samples per pixel", describe(result.samplesPerPixel)},
      {"Seed", std::to_string(settings.seed)},
      {"Device", device},
      {"Seconds", describe(seconds)}};
  if (result.stopReason != StopReason::kFinished)
    entries.emplace_back("Stopped", stopReasonName(result.stopReason));
  if (options.view != View::kColor) entries.emplace_back("View", viewName(options.view));
  return entries;
}

}  // namespace lavaray
