#include "device/render_scene.hpp"

#include <algorithm>

#include "bvh/flatten.hpp"
#include "device/test_device.hpp"

namespace lavaray {

RenderResult renderScene(const Scene& scene, std::optional<ImageSize> size, std::optional<Rectangle> crop) {
  const ImageSize whole = size.value_or(imageSize(scene.camera).value());
  RenderSettings settings;
  settings.size = whole;
  settings.crop = crop.value_or(Rectangle{0, 0, whole.width, whole.height});
  return renderScene(scene, settings);
}

RenderResult renderScene(const Scene& scene, RenderSettings settings) {
  return renderScene(testDevice(), scene, settings);
}

RenderResult renderScene(vulkan::Device& device, const Scene& scene, RenderSettings settings) {
  settings.countRays = true;
  return render(device, flatten(scene, 2), settings);
}

ImageSize reducedSize(const Camera& camera, int longest) {
  const ImageSize full = imageSize(camera).value();
  const double scale = std::min(1.0, static_cast<double>(longest) / std::max(full.width, full.height));
  return {std::max(1, static_cast<int>(full.width * scale)),
          std::max(1, static_cast<int>(full.height * scale))};
}

}  // namespace lavaray
