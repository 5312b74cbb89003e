#include "lavaray/step_times.hpp"

#include <iomanip>
#include <sstream>

namespace lavaray {

void StepTimes::endStep(const std::string& name, Clock::duration ofNext) {
  const Clock::time_point now = Clock::now() - ofNext;
  steps_.emplace_back(name, now - last_);
  last_ = now;
}

std::string StepTimes::inOneLine() const {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  for (const auto& [name, duration] : steps_) {
    text << (text.tellp() > 0 ? ", " : "") << name << ' ' << milliseconds(duration) << " ms";
  }
  return text.str();
}

}  // namespace lavaray
