#include <lavaray/renderer.h>

#include <utility>

namespace lavaray::v0 {

Picture Renderer::render(const Scene& scene, const RenderOptions& options, const OnProgress& progress) const {
  RenderOptions kept = options;
  kept.keepsPicture = true;
  RenderJob job(device_, scene, kept);
  job.run(progress ? RenderJob::Proceed([&] { return progress(job.shareDone()); }) : RenderJob::Proceed());
  return {job.image(), job.statistics()};
}

}  // namespace lavaray::v0
