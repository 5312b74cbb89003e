#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace lavaray::vulkan {

// When a submission was given to the device and waited for, by the host's steady clock, and when the device
// worked on it, by a clock of its own; in seconds. Not every queue has such a clock.
struct SubmissionTimes {
  struct OnDevice {
    double begin;
    double end;
  };

  double submitted = 0.0;
  double waitBegin = 0.0;
  double waitEnd = 0.0;
  std::optional<OnDevice> onDevice;
};

// Seconds since the device began with the first of the submissions, by the host's clock.
struct SubmissionSpan {
  double submitted;
  double begin;  // of the device's work on it
  double end;
  double waitBegin;
  double waitEnd;
};

struct Activity {
  bool byDeviceClock = false;
  double seconds = 0.0;            // from the begin of the first submission to the end of the last
  double deviceIdleSeconds = 0.0;  // of these
  double hostWaitSeconds = 0.0;
  std::vector<SubmissionSpan> first;  // the first submissions, no more than kMaxSpans
};

// When device and host were busy with submissions.
class ActivityLog {
 public:
  static constexpr std::size_t kMaxSpans = 1000;

  // The submissions come in their order, either all of them with times of the device or none.
  void add(const SubmissionTimes& times);
  [[nodiscard]] Activity activity() const;

 private:
  bool byDeviceClock_ = false;
  std::uint64_t count_ = 0;
  double begin_ = 0.0;  // these three: of the device's work, by its clock if it has one
  double end_ = 0.0;
  double busy_ = 0.0;
  double waited_ = 0.0;
  // What is to be added to the device's times to get the host's lies between these.
  double minOffset_ = 0.0;
  double maxOffset_ = 0.0;
  std::vector<SubmissionTimes> first_;
};

}  // namespace lavaray::vulkan
