#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace lavaray {

enum class ProgressStyle {
  kNone,
  kLines,  // at most one line per tenth of the work
  kBar,    // one line, redrawn again and again; for a terminal
};

// The style that suits stderr, which may be a terminal.
ProgressStyle progressStyle(bool quiet);

// Like 0:07, 12:30 or 1:05:00.
std::string hoursAndMinutes(std::chrono::duration<double> duration);
// How much longer work takes of which `share`, above 0, took `elapsed`.
std::chrono::duration<double> remainingTime(std::chrono::duration<double> elapsed, double share);

// Reports on stderr the progress of steps that take more than half a second. Nothing else may write there
// during a step.
class Progress {
 public:
  explicit Progress(ProgressStyle style);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // The steps that follow belong to piece `index` of `count`, and progress is reported of all pieces
  // together.
  void beginPiece(std::size_t index, std::size_t count);
  // Begins a step. Until update() is called only its time is known.
  void begin(const std::string& step);
  // `share` of the step is done, in [0, 1]; `detail` says more, or is empty.
  void update(double share, const std::string& detail);
  // Ends the step and removes the bar.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double shareOfAll() const;  // negative if unknown
  void draw();                              // with the mutex held
  void drawUntilStopped();
  [[nodiscard]] std::string text(Clock::duration elapsed) const;

  ProgressStyle style_;
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool isStopped_ = false;
  std::size_t piece_ = 0;
  std::size_t pieces_ = 1;
  std::string step_;         // empty between steps
  Clock::time_point begin_;  // of the step, or of the first piece if there are several
  double share_ = -1.0;      // of the step; negative if unknown
  int tenths_ = 0;           // that a line has reported
  std::string detail_;
  bool isShown_ = false;
  std::thread drawer_;  // of the bar
};

}  // namespace lavaray
