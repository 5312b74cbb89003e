#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace lavaray {

// The wall-clock time of each step of a run, in order.
class StepTimes {
 public:
  using Clock = std::chrono::steady_clock;

  // Ends the step that began with the last call, or with the construction. `ofNext` of that time counts
  // towards the next step.
  void endStep(const std::string& name, Clock::duration ofNext = {});

  using Step = std::pair<std::string, Clock::duration>;
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  // Up to the end of the last step.
  [[nodiscard]] Clock::duration all() const { return last_ - begin_; }
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(all()).count(); }
  // Like `read scene 3 ms, render 250 ms`.
  [[nodiscard]] std::string inOneLine() const;

 private:
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  std::vector<Step> steps_;
};

inline double milliseconds(StepTimes::Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace lavaray
