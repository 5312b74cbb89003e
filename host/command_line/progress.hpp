#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace lavaray {

enum class ProgressStyle {
  kNone,
  kLines,  // at most one for each tenth of the work
  kBar,    // on a terminal: one line, drawn again and again
};

// The style for stderr, which is a terminal or not.
ProgressStyle progressStyle(bool quiet);

// Like 0:07, 12:30 or 1:05:00.
std::string hoursAndMinutes(std::chrono::duration<double> duration);
// How long a piece of work of which `share`, above 0, took `elapsed` goes on.
std::chrono::duration<double> remainingTime(std::chrono::duration<double> elapsed, double share);

// Tells on stderr how far a step is that takes more than half a second. Nobody else writes there during a
// step.
class Progress {
 public:
  explicit Progress(ProgressStyle style);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // The steps that follow are of piece `index` of `count` of all the work, and what is told is about that.
  void beginPiece(std::size_t index, std::size_t count);
  // Begins a step, of which nothing but the time is known before update() is called.
  void begin(const std::string& step);
  // `share` of the step is done, 0..1; `detail` says more, or is empty.
  void update(double share, const std::string& detail);
  // Ends the step and takes the bar away.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double shareOfAll() const;  // below 0 it is not known
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
  Clock::time_point begin_;  // of the step, or of the first of several pieces
  double share_ = -1.0;      // of the step; below 0 it is not known
  int tenths_ = 0;           // told of in lines
  std::string detail_;
  bool isShown_ = false;
  std::thread drawer_;  // of the bar
};

}  // namespace lavaray
