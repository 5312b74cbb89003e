// When a device was busy, from what is known of each submission. The times are sums of powers of two, so that
// all comparisons are exact.
#include "vulkan/activity.hpp"

#include <gtest/gtest.h>

namespace lavaray::vulkan {
namespace {

TEST(Activity, IsNothingWithoutSubmissions) {
  const Activity activity = ActivityLog().activity();
  EXPECT_EQ(activity.seconds, 0.0);
  EXPECT_EQ(activity.deviceIdleSeconds, 0.0);
  EXPECT_EQ(activity.hostWaitSeconds, 0.0);
  EXPECT_TRUE(activity.first.empty());
}

TEST(Activity, CountsGapsBetweenSubmissionsAsIdle) {
  ActivityLog log;
  log.add({.submitted = 100.0, .waitBegin = 100.5, .waitEnd = 102.0, .onDevice = {{7.0, 8.0}}});
  log.add({.submitted = 103.0, .waitBegin = 104.0, .waitEnd = 107.0, .onDevice = {{10.0, 13.0}}});
  const Activity activity = log.activity();
  EXPECT_TRUE(activity.byDeviceClock);
  EXPECT_EQ(activity.seconds, 6.0);
  EXPECT_EQ(activity.deviceIdleSeconds, 2.0);
  EXPECT_EQ(activity.hostWaitSeconds, 4.5);
}

// A device may begin with the second while it ends the first.
TEST(Activity, CountsTimeOnceInWhichSubmissionsOverlap) {
  ActivityLog log;
  log.add({.submitted = 0.0, .waitBegin = 0.0, .waitEnd = 4.0, .onDevice = {{0.0, 4.0}}});
  log.add({.submitted = 0.5, .waitBegin = 4.0, .waitEnd = 6.0, .onDevice = {{1.0, 6.0}}});
  log.add({.submitted = 0.75, .waitBegin = 6.0, .waitEnd = 6.0, .onDevice = {{2.0, 5.0}}});
  EXPECT_EQ(log.activity().seconds, 6.0);
  EXPECT_EQ(log.activity().deviceIdleSeconds, 0.0);
}

// The first submission shows that the device's clock is at most 93 behind, the second that it is at
// least 92.5.
TEST(Activity, FindsHowFarTheClocksAreApart) {
  ActivityLog log;
  log.add({.submitted = 99.0, .waitBegin = 99.5, .waitEnd = 101.0, .onDevice = {{7.0, 8.0}}});
  log.add({.submitted = 102.5, .waitBegin = 102.75, .waitEnd = 107.0, .onDevice = {{10.0, 13.0}}});
  const Activity activity = log.activity();
  ASSERT_EQ(activity.first.size(), 2U);
  EXPECT_EQ(activity.first[0].begin, 0.0);
  EXPECT_EQ(activity.first[0].submitted, 99.0 - (7.0 + 92.75));
  EXPECT_EQ(activity.first[1].begin, 3.0);
  EXPECT_EQ(activity.first[1].end, 6.0);
  EXPECT_EQ(activity.first[1].waitEnd, 107.0 - (7.0 + 92.75));
}

TEST(Activity, IsOfTheHostsClockWhereTheDeviceHasNone) {
  ActivityLog log;
  log.add({.submitted = 10.0, .waitBegin = 10.5, .waitEnd = 12.0, .onDevice = {}});
  log.add({.submitted = 11.0, .waitBegin = 12.0, .waitEnd = 13.0, .onDevice = {}});  // while the first runs
  log.add({.submitted = 15.0, .waitBegin = 15.0, .waitEnd = 18.0, .onDevice = {}});
  const Activity activity = log.activity();
  EXPECT_FALSE(activity.byDeviceClock);
  EXPECT_EQ(activity.seconds, 8.0);
  EXPECT_EQ(activity.deviceIdleSeconds, 2.0);
  ASSERT_EQ(activity.first.size(), 3U);
  EXPECT_EQ(activity.first[1].submitted, 1.0);
  EXPECT_EQ(activity.first[1].begin, 2.0);
  EXPECT_EQ(activity.first[2].begin, 5.0);
}

TEST(Activity, KeepsTheFirstSubmissionsAndSumsUpAll) {
  ActivityLog log;
  for (int i = 0; i < 1500; ++i) {
    const double begin = i;
    log.add(
        {.submitted = begin, .waitBegin = begin, .waitEnd = begin + 0.5, .onDevice = {{begin, begin + 0.5}}});
  }
  const Activity activity = log.activity();
  EXPECT_EQ(activity.first.size(), ActivityLog::kMaxSpans);
  EXPECT_EQ(activity.seconds, 1499.5);
  EXPECT_EQ(activity.deviceIdleSeconds, 749.5);
}

}  // namespace
}  // namespace lavaray::vulkan
