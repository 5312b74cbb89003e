#include "lavaray/checkpoint.hpp"

#include <iostream>

#include "base/errors.hpp"

namespace lavaray {
namespace {

std::string describe(const Rectangle& crop) {
  return std::to_string(crop.x0) + ',' + std::to_string(crop.y0) + " to " + std::to_string(crop.x1) + ',' +
         std::to_string(crop.y1);
}

std::string describe(const SampleRange& range) {
  return std::to_string(range.first) + ':' + std::to_string(range.end);
}

}  // namespace

void resume(const std::filesystem::path& file, const Identity& identity, const RenderSettings& settings,
            const std::string& device, Render& render) {
  FilmReader film(file);
  const FilmHeader& header = film.header();
  std::string difference = describeDifference(identity, header.identity);
  const auto add = [&](const std::string& what, const std::string& here, const std::string& there) {
    difference += (difference.empty() ? "" : "; ") + what + ' ' + here + " here and " + there + " there";
  };
  if (!(header.crop == settings.crop)) add("the crop is", describe(settings.crop), describe(header.crop));
  const SampleRange range = settings.range.value_or(SampleRange{0, header.samples});
  if (header.range != range) add("--sample-range is", describe(range), describe(header.range));
  if (!difference.empty()) {
    throw Error(ExitCode::kInput, file.string() + " is of another picture: " + difference);
  }
  if (header.device != device) {
    std::cerr << "warning: " << file.string() << " was rendered on " << header.device << ", this is "
              << device << "; their pixels may differ in the last bits\n";
  }
  render.resumeFrom(film);
}

Checkpoint::Checkpoint(const OutputName& file, double everySeconds, const Identity& identity)
    : file_(file), every_(everySeconds), identity_(identity) {
  // Tried now, not after an hour; the file stays as it is.
  if (!file_.file.empty()) OutputFile attempt(file_);
}

void Checkpoint::saveIfDue(const Render& render) {
  if (!file_.file.empty() && Clock::now() - last_ >= every_) save(render);
}

void Checkpoint::save(const Render& render) {
  if (file_.file.empty()) return;
  hasFailed_ = false;
  try {
    OutputFile output(file_);
    render.writeFilm(output.stream(), identity_);
    output.commit();
  } catch (const Error& error) {
    hasFailed_ = true;
    if (reasons_.insert(error.what()).second)
      std::cerr << "warning: the checkpoint " << error.what() << "; the render goes on\n";
  }
  last_ = Clock::now();
}

}  // namespace lavaray
