// SPDX-License-Identifier: Apache-2.0
// The one file that knows which Embree this is: 3 and 4 differ in the folder of the headers and in
// the signatures of the queries. Only implementation units include it.
#ifndef ABUT_PICKING_EMBREE_HPP
#define ABUT_PICKING_EMBREE_HPP

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace abut::picking::embree {

struct Release {
  void operator()(RTCDevice device) const noexcept { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const noexcept { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const noexcept { rtcReleaseGeometry(geometry); }
};

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release>;

#if RTC_VERSION_MAJOR >= 4

using NativeContext = RTCRayQueryContext;
inline constexpr RTCSceneFlags filtered_scene = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

// Context of one query; derive from it to hand data to callbacks.
struct Query : NativeContext {
  RTCIntersectArguments arguments;
  RTCOccludedArguments any;  // of queries for any hit

  explicit Query(bool coherent) noexcept : NativeContext{}, arguments{}, any{} {
    rtcInitRayQueryContext(this);
    rtcInitIntersectArguments(&arguments);
    rtcInitOccludedArguments(&any);
    arguments.context = any.context = this;
    arguments.flags = any.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
  // The arguments point to the context, which is this object.
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  // Sets the function that sees each hit on a triangle; null for none.
  void filter_hits(RTCFilterFunctionN function) noexcept {
    arguments.filter = any.filter = function;
    arguments.flags = any.flags =
        function != nullptr ? RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
};

// Nearest hits. Those of `occlude` are any hits: a ray that has one gets a limit below 0.
inline void intersect(RTCScene scene, Query& query, RTCRayHit& ray) { rtcIntersect1(scene, &ray, &query.arguments); }
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit4& rays) {
  rtcIntersect4(valid, scene, &rays, &query.arguments);
}
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit8& rays) {
  rtcIntersect8(valid, scene, &rays, &query.arguments);
}
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &rays, &query.arguments);
}

inline void occlude(RTCScene scene, Query& query, RTCRay& ray) { rtcOccluded1(scene, &ray, &query.any); }
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay4& rays) {
  rtcOccluded4(valid, scene, &rays, &query.any);
}
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay8& rays) {
  rtcOccluded8(valid, scene, &rays, &query.any);
}
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay16& rays) {
  rtcOccluded16(valid, scene, &rays, &query.any);
}

#else

using NativeContext = RTCIntersectContext;
inline constexpr RTCSceneFlags filtered_scene = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

// Context of one query; derive from it to hand data to callbacks.
struct Query : NativeContext {
  explicit Query(bool coherent) noexcept : NativeContext{} {
    rtcInitIntersectContext(this);
    flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  // Sets the function that sees each hit on a triangle; null for none.
  void filter_hits(RTCFilterFunctionN function) noexcept { filter = function; }
};

// Nearest hits. Those of `occlude` are any hits: a ray that has one gets a limit below 0.
inline void intersect(RTCScene scene, Query& query, RTCRayHit& ray) { rtcIntersect1(scene, &query, &ray); }
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit4& rays) {
  rtcIntersect4(valid, scene, &query, &rays);
}
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit8& rays) {
  rtcIntersect8(valid, scene, &query, &rays);
}
inline void intersect(RTCScene scene, Query& query, const int* valid, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &query, &rays);
}

inline void occlude(RTCScene scene, Query& query, RTCRay& ray) { rtcOccluded1(scene, &query, &ray); }
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay4& rays) {
  rtcOccluded4(valid, scene, &query, &rays);
}
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay8& rays) {
  rtcOccluded8(valid, scene, &query, &rays);
}
inline void occlude(RTCScene scene, Query& query, const int* valid, RTCRay16& rays) {
  rtcOccluded16(valid, scene, &query, &rays);
}

#endif

}  // namespace abut::picking::embree

#endif
