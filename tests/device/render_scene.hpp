#pragma once

#include <optional>

#include "image/image.hpp"
#include "render/render.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace lavaray {

// The scene's image, or a part of it, from the test device; `size` is the camera's where it is not given.
RenderResult renderScene(const Scene& scene, std::optional<ImageSize> size = {},
                         std::optional<Rectangle> crop = {});

RenderResult renderScene(const Scene& scene, RenderSettings settings);

RenderResult renderScene(vulkan::Device& device, const Scene& scene, RenderSettings settings);

// The camera's size, reduced so that no side is longer than `longest`.
ImageSize reducedSize(const Camera& camera, int longest);

}  // namespace lavaray
