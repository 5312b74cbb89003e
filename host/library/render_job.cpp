#include <algorithm>
#include <utility>

#include "base/errors.hpp"
#include "film/film_file.hpp"
#include "library/callbacks.hpp"
#include "library/guarded.hpp"
#include "library/identity.hpp"
#include "library/job_state.hpp"
#include "render/layer.hpp"

namespace lavaray::v0 {
RenderJob::RenderJob(const Device& device, const Scene& scene, const RenderOptions& options)
    : state_(guarded([&] { return std::make_unique<State>(device, scene, options); })) {}
RenderJob::~RenderJob() = default;
RenderJob::RenderJob(RenderJob&&) noexcept = default;
RenderJob& RenderJob::operator=(RenderJob&&) noexcept = default;

const Rectangle& RenderJob::part() const {
  return state_->plan.part;
}

const ImageSize& RenderJob::size() const {
  return state_->plan.settings.size;
}

void RenderJob::buildHierarchy() {
  guarded([&] { state_->buildHierarchy(); });
}

void RenderJob::prepare() {
  guarded([&] { state_->prepare(); });
}

void RenderJob::begin() {
  guarded([&] { state_->begin(); });
}

std::vector<std::string> RenderJob::resume(const std::filesystem::path& film) {
  return guarded([&] {
    state_->checkKeepsFilm();
    Render& render = state_->begin();
    FilmReader reader(film);
    checkSame(reader, state_->identity, state_->plan.settings);
    std::vector<std::string> warnings;
    const std::string& here = state_->device.state().open().device.description().name;
    const std::string& there = reader.header().device;
    if (here != there) {
      warnings.push_back(film.string() + " was rendered on " + there + ", this is " + here +
                         "; their pixels may differ in the last bits");
    }
    render.resumeFrom(reader);
    return warnings;
  });
}

bool RenderJob::canStream() const {
  return !state_->plan.settings.keepsPicture;
}

void RenderJob::run(const Proceed& proceed, const TakeRow& take) {
  Callbacks callbacks;
  guarded([&] {
    state_->begin().run([&] { return callbacks.call(proceed); },
                        [&](std::span<const float> row) { callbacks.call(take, row.data()); });
  });
  callbacks.rethrow();
}

void RenderJob::takeRows(const TakeRow& take) {
  Callbacks callbacks;
  guarded([&] {
    State& state = *state_;
    Render& render = state.begin();
    float largest = 0.0F;
    if (state.options.normalize) {
      render.handOverRows(
          [&](std::span<const float> row) { largest = std::max(largest, *std::ranges::max_element(row)); });
    }
    int y = state.plan.settings.crop.y0;
    render.handOverRows([&](std::span<const float> row) {
      const bool isShown = state.plan.part.y0 <= y && y < state.plan.part.y1;
      ++y;
      if (isShown) state.show(row, largest, [&](const float* rgb) { callbacks.call(take, rgb); });
    });
  });
  callbacks.rethrow();
}

Image RenderJob::image() {
  Image image{part().width(), part().height(), {}};
  const std::size_t rowValues = 3 * static_cast<std::size_t>(image.width);
  guarded([&] { image.rgb.reserve(rowValues * image.height); });
  takeRows([&](const float* rgb) { image.rgb.insert(image.rgb.end(), rgb, rgb + rowValues); });
  return image;
}

double RenderJob::shareDone() const {
  return state_->render ? state_->render->shareDone() : 0.0;
}

double RenderJob::secondsElapsed() const {
  return state_->render ? state_->render->elapsed().count() : 0.0;
}

double RenderJob::samplesPerPixel() const {
  return state_->render ? state_->render->samplesPerPixel() : 0.0;
}

double RenderJob::estimatedError() const {
  return state_->render ? state_->render->estimatedError() : 0.0;
}

bool RenderJob::isTraced(Layer layer) {
  return lavaray::isTraced(layer);
}

bool RenderJob::takeLayer(Layer layer, const TakeValues& take, const OnProgress& progress) {
  Callbacks callbacks;
  const auto pass = [&](std::span<const float> values) {
    callbacks.call(take, values.data(), values.size());
  };
  const bool isWhole = guarded([&] {
    State& state = *state_;
    const Rectangle& part = state.plan.part;
    if (lavaray::isTraced(layer)) {
      state.prepare();
      RenderSettings settings = state.plan.settings;
      settings.crop = part;
      return traceLayer(state.device.state().open().device, *state.flat, settings, layer, pass,
                        [&](double share) { return callbacks.call(progress, share); });
    }
    const Render& render = state.begin();
    const Rectangle& whole = state.plan.settings.crop;
    const auto width = static_cast<std::size_t>(whole.width());
    const std::vector<float> values = layer == Layer::kSamples ? render.pixelSamples() : render.pixelErrors();
    for (int y = part.y0; y < part.y1; ++y) {
      const std::size_t first = static_cast<std::size_t>(y - whole.y0) * width + (part.x0 - whole.x0);
      pass(std::span(values).subspan(first, static_cast<std::size_t>(part.width())));
    }
    return true;
  });
  callbacks.rethrow();
  return isWhole;
}

void RenderJob::writeFilm(OutputFile& file) {
  guarded([&] {
    state_->checkKeepsFilm();
    state_->begin().writeFilm(file.stream(), state_->identity);
  });
}

}  // namespace lavaray::v0
