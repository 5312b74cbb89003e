#include "command_line/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace lavaray {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 500ms;
constexpr auto kRedraw = 100ms;
constexpr int kBarWidth = 24;
// Erases the line and returns to its beginning.
constexpr const char* kClearLine = "\r\x1b[K";

std::size_t terminalColumns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

std::string hoursAndMinutes(std::chrono::duration<double> duration) {
  const auto seconds = static_cast<long long>(std::min(std::round(duration.count()), 1e9));
  std::ostringstream text;
  text << std::setfill('0');
  if (seconds >= 3600) text << seconds / 3600 << ':' << std::setw(2);
  text << seconds / 60 % 60 << ':' << std::setw(2) << seconds % 60;
  return text.str();
}

std::chrono::duration<double> remainingTime(std::chrono::duration<double> elapsed, double share) {
  return elapsed * ((1.0 - share) / share);
}

ProgressStyle progressStyle(bool quiet) {
  if (quiet) return ProgressStyle::kNone;
  return isatty(STDERR_FILENO) == 1 ? ProgressStyle::kBar : ProgressStyle::kLines;
}

Progress::Progress(ProgressStyle style) : style_(style) {
  if (style_ == ProgressStyle::kBar) drawer_ = std::thread([this] { drawUntilStopped(); });
}

Progress::~Progress() {
  end();
  {
    const std::lock_guard lock(mutex_);
    isStopped_ = true;
  }
  stopped_.notify_all();
  if (drawer_.joinable()) drawer_.join();
}

void Progress::beginPiece(std::size_t index, std::size_t count) {
  const std::lock_guard lock(mutex_);
  piece_ = index;
  pieces_ = count;
  if (index > 0) return;
  begin_ = Clock::now();
  tenths_ = 0;
}

void Progress::begin(const std::string& step) {
  end();
  const std::lock_guard lock(mutex_);
  step_ = step;
  share_ = -1.0;
  detail_.clear();
  if (pieces_ > 1) {
    if (style_ == ProgressStyle::kBar) draw();  // again, as the end of each short step erases it
    return;
  }
  begin_ = Clock::now();
  tenths_ = 0;
}

double Progress::shareOfAll() const {
  if (pieces_ == 1) return share_;
  return (static_cast<double>(piece_) + std::max(share_, 0.0)) / static_cast<double>(pieces_);
}

void Progress::update(double share, const std::string& detail) {
  const std::lock_guard lock(mutex_);
  share_ = share;
  detail_ = detail;
  const Clock::duration elapsed = Clock::now() - begin_;
  const int tenths = static_cast<int>(10.0 * shareOfAll());
  if (style_ != ProgressStyle::kLines || elapsed < kPatience || tenths <= tenths_) return;
  tenths_ = tenths;
  std::fprintf(stderr, "%s\n", text(elapsed).c_str());
}

void Progress::end() {
  const std::lock_guard lock(mutex_);
  step_.clear();
  if (isShown_) std::fputs(kClearLine, stderr);
  isShown_ = false;
}

// Like `rendering  37 %  0:12 elapsed, 0:20 left, 14 spp`, preceded by `2 of 40: ` if there are 40 pieces.
std::string Progress::text(Clock::duration elapsed) const {
  std::ostringstream text;
  if (pieces_ > 1) text << piece_ + 1 << " of " << pieces_ << ": ";
  text << step_;
  const double share = shareOfAll();
  if (share >= 0.0) text << "  " << std::setw(3) << static_cast<int>(100.0 * share) << " %";
  text << "  " << hoursAndMinutes(elapsed) << " elapsed";
  if (share > 0.0) text << ", " << hoursAndMinutes(remainingTime(elapsed, share)) << " left";
  if (!detail_.empty()) text << ", " << detail_;
  return text.str();
}

void Progress::draw() {
  const Clock::duration elapsed = Clock::now() - begin_;
  if (step_.empty() || elapsed < kPatience) return;
  std::string line;
  if (const double share = shareOfAll(); share >= 0.0) {
    const auto full = static_cast<std::size_t>(kBarWidth * std::min(share, 1.0));
    line = '[' + std::string(full, '#') + std::string(kBarWidth - full, ' ') + "] ";
  }
  line += text(elapsed);
  // A line that wraps could not be erased.
  std::fprintf(stderr, "%s%s", kClearLine, line.substr(0, terminalColumns() - 1).c_str());
  std::fflush(stderr);
  isShown_ = true;
}

// Not left to update(), which some steps never call: the time would stand still.
void Progress::drawUntilStopped() {
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, kRedraw, [this] { return isStopped_; })) draw();
}

}  // namespace lavaray
