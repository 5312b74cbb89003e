#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "bvh/flatten.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "vulkan/device.hpp"

namespace lavaray {

// Wall-clock time of the steps of a run, in their order.
class StepTimes {
 public:
  using Clock = std::chrono::steady_clock;

  // Ends the step that began with the last call, or with the construction. What took `ofNext` in it counts as
  // a part of the next step.
  void endStep(const std::string& name, Clock::duration ofNext = {});
  void print(std::ostream& out) const;
  [[nodiscard]] std::string inOneLine() const;
  using Step = std::pair<std::string, Clock::duration>;
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  // Up to the end of the last step.
  [[nodiscard]] double seconds() const;

 private:
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  std::vector<Step> steps_;
};

void printWarnings(std::ostream& out, const std::vector<std::string>& warnings);

// What is in the scene: --check.
void printScene(std::ostream& out, const Scene& scene);

void printDevices(std::ostream& out, const std::vector<vulkan::DeviceDescription>& devices);

std::size_t meshTriangles(const Scene& scene);

// Of this process, so far.
std::size_t peakMemoryBytes();

// Everything of --stats but the times.
void printStatistics(std::ostream& out, const Scene& scene, const GpuScene& gpuScene,
                     const vulkan::Device& device, const RenderStatistics& result);

}  // namespace lavaray
