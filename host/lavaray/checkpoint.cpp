#include "lavaray/checkpoint.hpp"

#include <iostream>

namespace lavaray {

Checkpoint::Checkpoint(const OutputName& file, double everySeconds) : file_(file), every_(everySeconds) {
  // Tried now, not after an hour; the file stays as it is.
  if (!file_.file.empty()) OutputFile attempt(file_);
}

void Checkpoint::saveIfDue(RenderJob& job) {
  if (!file_.file.empty() && Clock::now() - last_ >= every_) save(job);
}

void Checkpoint::save(RenderJob& job) {
  if (file_.file.empty()) return;
  hasFailed_ = false;
  try {
    OutputFile output(file_);
    job.writeFilm(output);
    output.commit();
  } catch (const Error& error) {
    hasFailed_ = true;
    if (reasons_.insert(error.what()).second)
      std::cerr << "warning: the checkpoint " << error.what() << "; the render goes on\n";
  }
  last_ = Clock::now();
}

}  // namespace lavaray
