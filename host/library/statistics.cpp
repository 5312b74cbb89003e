#include <lavaray/statistics.h>

#include "interface.h"
#include "library/guarded.hpp"
#include "library/job_state.hpp"
#include "library/tuning_file.hpp"

namespace lavaray::v0 {
namespace {

HierarchyStatistics hierarchyOf(const GpuScene& scene) {
  HierarchyStatistics hierarchy;
  hierarchy.primitives = scene.primitives.size();
  hierarchy.droppedDuplicates = scene.droppedDuplicates;
  hierarchy.innerNodes = scene.bvhQuality.innerNodes;
  hierarchy.leaves = scene.bvhQuality.leaves;
  hierarchy.primitivesPerLeaf = scene.bvhQuality.leafSize;
  hierarchy.depth = scene.bvhQuality.depth;
  hierarchy.maxDepth = gpu::kMaxBvhDepth;
  hierarchy.sahCost = scene.bvhQuality.sahCost;
  hierarchy.isTraversed = !scene.hasFewPrimitives;
  hierarchy.traversedNodes = scene.hasFewPrimitives ? 0 : scene.nodes.size();
  hierarchy.traversedDepth = scene.bvhDepth;
  hierarchy.nodeWidth = gpu::kNodeWidth;
  return hierarchy;
}

DeviceActivity activityOf(const vulkan::Activity& activity) {
  DeviceActivity result{
      activity.byDeviceClock, activity.seconds, activity.deviceIdleSeconds, activity.hostWaitSeconds, {}};
  for (const vulkan::SubmissionSpan& span : activity.first)
    result.first.push_back({span.submitted, span.begin, span.end, span.waitBegin, span.waitEnd});
  return result;
}

Statistics statisticsOf(const RenderStatistics& render) {
  Statistics result;
  result.stopReason = render.stopReason;
  result.samplesPerPixel = render.samplesPerPixel;
  result.estimatedError = render.estimatedError;
  result.maxSamples = render.maxSamples;
  result.skippedPixels = render.skippedPixels;
  result.rays = {render.counts.samples,           render.counts.skippedSamples,
                 render.counts.mirrorRays,        render.counts.shadowRays,
                 render.counts.skippedShadowRays, render.counts.nearestHitLanesInUse(),
                 render.counts.shadowLanesInUse()};
  result.dispatches = render.counts.dispatches;
  result.deviceBytes = render.deviceBytes;
  result.sceneReadAs = sceneReadAs(render.tuning.sceneInStorage);
  result.raysPerInvocation = render.tuning.raysPerLane;
  result.activity = activityOf(render.activity);
  result.largestMeasure = render.largestMeasure;
  return result;
}

}  // namespace

Statistics RenderJob::statistics() const {
  return guarded([&] {
    Statistics statistics;
    if (state_->render) statistics = statisticsOf(state_->render->statistics());
    if (state_->flat) statistics.hierarchy = hierarchyOf(*state_->flat);
    return statistics;
  });
}

}  // namespace lavaray::v0
