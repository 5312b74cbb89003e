#pragma once

// Embree (https://www.embree.org), of the version that CMakeLists.txt has found.
#include LAVARAY_EMBREE_HEADER

namespace lavaray::bench {

// Traces rays. Embree 3 and 4 differ in the name of a query's arguments, and in where they take them.
class EmbreeTracer {
 public:
#if RTC_VERSION_MAJOR >= 4
  // Coherence makes packets of such rays faster; it makes no difference to single rays.
  explicit EmbreeTracer(bool isCoherent = false) {
    rtcInitIntersectArguments(&intersect_);
    rtcInitOccludedArguments(&occluded_);
    if (isCoherent) intersect_.flags = occluded_.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  }
  void intersect(RTCScene scene, RTCRayHit* ray) {
    rtcIntersect1(scene, ray, &intersect_);
  }
  void occluded(RTCScene scene, RTCRay* ray) {
    rtcOccluded1(scene, ray, &occluded_);
  }
  void intersect(const int* valid, RTCScene scene, RTCRayHit8* packet) {
    rtcIntersect8(valid, scene, packet, &intersect_);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay8* packet) {
    rtcOccluded8(valid, scene, packet, &occluded_);
  }

 private:
  RTCIntersectArguments intersect_;
  RTCOccludedArguments occluded_;
#else
  // Coherence makes packets of such rays faster; it makes no difference to single rays.
  explicit EmbreeTracer(bool isCoherent = false) {
    rtcInitIntersectContext(&context_);
    if (isCoherent) context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }
  void intersect(RTCScene scene, RTCRayHit* ray) {
    rtcIntersect1(scene, &context_, ray);
  }
  void occluded(RTCScene scene, RTCRay* ray) {
    rtcOccluded1(scene, &context_, ray);
  }
  void intersect(const int* valid, RTCScene scene, RTCRayHit8* packet) {
    rtcIntersect8(valid, scene, &context_, packet);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay8* packet) {
    rtcOccluded8(valid, scene, &context_, packet);
  }

 private:
  RTCIntersectContext context_;
#endif
};

}  // namespace lavaray::bench
