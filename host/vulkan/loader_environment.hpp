#pragma once

#include <string>
#include <vector>

#include "vulkan/driver_survey.hpp"

namespace lavaray::vulkan {

// While it lives, the process has an environment of its own in which the loader sees only what the survey
// found to be sound: the drivers that work, the layers that can be parsed. That is read by vkCreateInstance
// and by nothing later.
//
// setenv() would change the table of variables under the eyes of other threads that call getenv(). Here the
// table stays as it is and another, complete one takes its place by the store of one pointer: whoever reads
// sees the one or the other, and both live on. Only one thread may do so at a time, and none may call
// setenv() meanwhile, as nothing in the program does.
class LoaderEnvironment {
 public:
  explicit LoaderEnvironment(const DriverSurvey& survey);
  ~LoaderEnvironment();
  LoaderEnvironment(const LoaderEnvironment&) = delete;
  LoaderEnvironment& operator=(const LoaderEnvironment&) = delete;

 private:
  char** before_;
};

}  // namespace lavaray::vulkan
