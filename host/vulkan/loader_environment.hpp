#pragma once

#include <string>
#include <vector>

#include "vulkan/driver_survey.hpp"

namespace lavaray::vulkan {

// While it lives, the process has an environment in which the loader sees only what the survey found sound:
// drivers that work, layers that can be parsed. Only vkCreateInstance reads it.
//
// setenv() would change the table of variables while other threads may be calling getenv(). This leaves the
// table alone and replaces it by another, complete one with the store of a single pointer: a reader sees one
// or the other, and both live on. Only one thread may do this at a time, and no thread may call setenv()
// meanwhile; nothing in the program does.
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
