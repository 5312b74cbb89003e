#include "vulkan/activity.hpp"

#include <algorithm>

namespace lavaray::vulkan {
namespace {

// Without a clock of the device, its work is taken to begin as soon as it can, and to end when the host
// learns of that.
SubmissionTimes::OnDevice timesOnDevice(const SubmissionTimes& times, double previousEnd) {
  return times.onDevice.value_or(
      SubmissionTimes::OnDevice{std::max(times.submitted, previousEnd), times.waitEnd});
}

}  // namespace

void ActivityLog::add(const SubmissionTimes& times) {
  const auto [begin, end] = timesOnDevice(times, end_);
  // No work begins before it is submitted, nor does the host learn of its end before that.
  const double minOffset = times.submitted - begin;
  const double maxOffset = times.waitEnd - end;
  if (count_ == 0) {
    byDeviceClock_ = times.onDevice.has_value();
    begin_ = begin;
    end_ = begin;
    minOffset_ = minOffset;
    maxOffset_ = maxOffset;
  }
  // A device may begin with the next one before it has ended the one before.
  busy_ += std::max(0.0, end - std::max(begin, end_));
  end_ = std::max(end_, end);
  waited_ += times.waitEnd - times.waitBegin;
  minOffset_ = std::max(minOffset_, minOffset);
  maxOffset_ = std::min(maxOffset_, maxOffset);
  if (first_.size() < kMaxSpans) first_.push_back(times);
  ++count_;
}

Activity ActivityLog::activity() const {
  Activity result{.byDeviceClock = byDeviceClock_,
                  .seconds = end_ - begin_,
                  .deviceIdleSeconds = end_ - begin_ - busy_,
                  .hostWaitSeconds = waited_,
                  .first = {}};
  const double offset = byDeviceClock_ ? (minOffset_ + maxOffset_) / 2.0 : 0.0;
  const double hostBegin = begin_ + offset;
  double end = begin_;
  for (const SubmissionTimes& times : first_) {
    const SubmissionTimes::OnDevice onDevice = timesOnDevice(times, end);
    end = onDevice.end;
    result.first.push_back({.submitted = times.submitted - hostBegin,
                            .begin = onDevice.begin - begin_,
                            .end = onDevice.end - begin_,
                            .waitBegin = times.waitBegin - hostBegin,
                            .waitEnd = times.waitEnd - hostBegin});
  }
  return result;
}

}  // namespace lavaray::vulkan
