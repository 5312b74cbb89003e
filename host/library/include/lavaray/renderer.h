#ifndef LAVARAY_RENDERER_H
#define LAVARAY_RENDERER_H

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <lavaray/device.h>
#include <lavaray/files.h>
#include <lavaray/image.h>
#include <lavaray/scene.h>
#include <lavaray/statistics.h>
#include <lavaray/types.h>

namespace lavaray::v0 {

// The words for them, and what a word stands for, if anything.
LAVARAY_API std::string name(View view);
LAVARAY_API std::string name(Layer layer);
LAVARAY_API std::string name(PixelFilter filter);
LAVARAY_API std::string name(Sampler sampler);
LAVARAY_API std::string name(StopReason reason);
LAVARAY_API std::optional<View> viewNamed(const std::string& name);
LAVARAY_API std::optional<PixelFilter> filterNamed(const std::string& name);
LAVARAY_API std::optional<Sampler> samplerNamed(const std::string& name);
// Of a list separated by commas. Throws Error(kUsage) saying which name is wrong and what is allowed.
LAVARAY_API std::vector<Layer> layersNamed(const std::string& names);

inline constexpr std::uint32_t kMaxSamplesPerPixel = 1U << 22U;
inline constexpr std::uint32_t kMaxMirrorBounces = 1000;

struct RenderOptions : SamplingOptions {
  // Of the whole picture, 1 to 65535 pixels a side; 0 is the scene's size, or what goes with the other side
  // by its aspect ratio. The view stays the same.
  int width = 0;
  int height = 0;
  std::optional<Rectangle> crop;  // render only this part; its pixels are those of the whole
  bool normalize = false;         // stretch so that the largest value of the whole picture is 1
  bool falseColors = true;        // for the view cost, whose numbers are grey otherwise
  bool countRays = false;         // Statistics: rays by kind, and when the device was busy
  bool keepsPicture = true;       // see RenderJob::run
  bool keepsFilm = false;         // RenderJob::writeFilm and resume are to be called
  std::shared_ptr<const CompiledShader> shader;  // in place of the built-in one
};

// Throws Error(kUsage) if an option is out of range, or two of them contradict each other.
LAVARAY_API void checkOptions(const RenderOptions& options);

// Called some 10s of times a second with the share that is done, in [0, 1]; returns whether to go on. What it
// throws ends the render and is thrown on.
using OnProgress = std::function<bool(double share)>;

// The size of the whole picture. Throws Error(kUsage) if a side is out of range.
LAVARAY_API ImageSize pictureSize(const Scene& scene, const RenderOptions& options);

struct Picture {
  Image image;  // of the crop; black where no sample was taken
  Statistics statistics;
};

// Renders one picture after the other on one device.
class LAVARAY_API Renderer {
 public:
  explicit Renderer(Device device = Device()) : device_(std::move(device)) {}

  // Throws Error(kUsage) if an option is out of range, Error(kMemory) before the first ray where there is too
  // little memory, Error(kDevice) if the device fails. Where `progress` stops it, the picture holds what was
  // rendered.
  Picture render(const Scene& scene, const RenderOptions& options = {},
                 const OnProgress& progress = {}) const;

  // Runs a shader of the user's own for each pixel of the crop. Returns its values, which need not be in
  // [0, 1]; 0 where `progress` stopped it. Of the options only width, height, crop, seed and maxDepth may be
  // given. Throws as render().
  Image run(const Shader& shader, const Scene& scene, const RenderOptions& options = {},
            const OnProgress& progress = {}) const;

  const Device& device() const { return device_; }

 private:
  Device device_;
};

// A render step by step: it can be looked at, kept and stopped. Its functions are for one thread at a time.
class LAVARAY_API RenderJob {
 public:
  // Throws Error(kUsage) if an option is out of range.
  RenderJob(const Device& device, const Scene& scene, const RenderOptions& options);
  ~RenderJob();
  RenderJob(RenderJob&&) noexcept;
  RenderJob& operator=(RenderJob&&) noexcept;

  const Rectangle& part() const;  // of the whole picture, which image() has
  const ImageSize& size() const;  // of the whole

  // The steps before the first ray; whoever does not call them has run() do it. The first builds the
  // hierarchy, while another thread makes the pipeline. The second waits for the device, finds out whether
  // there is enough memory, and measures the device where TuningOptions ask for that. The third takes what
  // the picture needs of the device.
  void buildHierarchy();
  void prepare();
  void begin();
  // With RenderOptions::keepsFilm goes on from a film of the same picture, before run(). Returns warnings.
  // Throws Error(kInput) naming what differs there: scene, options, crop, samples.
  std::vector<std::string> resume(const std::filesystem::path& film);

  // Takes a row of part(), three values per pixel, from the top.
  using TakeRow = std::function<void(const float* rgb)>;
  // Called between batches of work; returns whether to go on.
  using Proceed = std::function<bool()>;
  // Renders. Without RenderOptions::keepsPicture and where canStream(), each row is taken as soon as it is
  // complete, and there is nothing to look at, keep or resume.
  void run(const Proceed& proceed = {}, const TakeRow& take = {});
  bool canStream() const;
  // Hands over the rows that run() has not: all of them, where the picture is kept.
  void takeRows(const TakeRow& take);

  // So far, also while run() calls back.
  Image image();
  double shareDone() const;        // in [0, 1]; estimated where there is a target or a time limit
  double secondsElapsed() const;   // since begin()
  double samplesPerPixel() const;  // averaged over the pixels in which something can show
  double estimatedError() const;   // RMSE, where there is a target, else 0
  Statistics statistics() const;

  // The layer's values of part(), pixel by pixel: three for normals, else one. `take` gets the next `count`
  // of them. Normals, depths and objects are traced, before run() or after it; false where `progress` stopped
  // that. The others are of the samples so far.
  using TakeValues = std::function<void(const float* values, std::size_t count)>;
  bool takeLayer(Layer layer, const TakeValues& take, const OnProgress& progress = {});
  static bool isTraced(Layer layer);

  // Everything that it takes to resume, or to merge; with RenderOptions::keepsFilm.
  void writeFilm(OutputFile& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lavaray::v0

#endif
