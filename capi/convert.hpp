// SPDX-License-Identifier: Apache-2.0
// Values of the C interface into checked values of the modules, and back.
#ifndef ABUT_CAPI_CONVERT_HPP
#define ABUT_CAPI_CONVERT_HPP

#include "prelude.hpp"

#include "border.hpp"

import abut.capability;
import abut.core;
import abut.math;

namespace abut::capi {

[[nodiscard]] inline Vec3 to_vec3(const abut_vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Quat to_quat(const abut_quat& q) { return {q.w, q.x, q.y, q.z}; }
[[nodiscard]] inline abut_vec3 from_vec3(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline abut_quat from_quat(const Quat& q) { return {q.w, q.x, q.y, q.z}; }

// The first fault of a vector or pose, in words.
[[gnu::cold]] [[nodiscard]] abut_status refuse_vec3(const Where& where, std::string_view field, const abut_vec3& v);
[[gnu::cold]] [[nodiscard]] abut_status refuse_pose(const Where& where, const abut_pose& pose);

[[nodiscard]] inline bool is_coordinate(double value) { return std::fabs(value) <= largest_coordinate; }
[[nodiscard]] [[gnu::always_inline]] inline bool is_position(const abut_vec3& v) {
  return is_coordinate(v.x) && is_coordinate(v.y) && is_coordinate(v.z);
}

// Lengths off 1 by at most 1e-3. False for NaN.
[[nodiscard]] [[gnu::always_inline]] inline bool is_orientation(const abut_quat& q) {
  constexpr double slack = 1e-3;
  const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  return square >= (1 - slack) * (1 - slack) && square <= (1 + slack) * (1 + slack);
}

// `field`: "" for the argument itself, or such as ".origin".
[[nodiscard]] inline abut_status check_position(const Where& where, std::string_view field, const abut_vec3& v) {
  if (is_position(v)) [[likely]] {
    return ABUT_OK;
  }
  return refuse_vec3(where, field, v);
}

[[nodiscard]] [[gnu::always_inline]] inline abut_status check_pose(const Where& where, const abut_pose& pose) {
  if (is_position(pose.position) && is_orientation(pose.orientation)) [[likely]] {
    return ABUT_OK;
  }
  return refuse_pose(where, pose);
}

// The pose of a checked argument. The matrix comes out orthonormal also if the quaternion is not quite
// of length one.
[[nodiscard]] [[gnu::always_inline]] inline Pose to_pose(const abut_pose& pose) {
  return {Rotation::from(to_quat(pose.orientation)), to_vec3(pose.position)};
}

[[nodiscard]] inline abut_feature from_feature(const Feature& feature) {
  return {static_cast<abut_feature_kind>(feature.kind), feature.index};
}

[[nodiscard]] inline abut_contact from_contact(const ContactPoint& contact) {
  return {{},
          {},
          contact.id,
          from_feature(contact.feature_a),
          from_feature(contact.feature_b),
          contact.child_a,
          contact.child_b,
          from_vec3(contact.point_a),
          from_vec3(contact.point_b),
          from_vec3(contact.normal),
          contact.distance,
          0,
          0,
          0,
          0,
          0,
          0,
          from_vec3(tangents_of(contact.normal).first),
          0};
}

static_assert(static_cast<abut_feature_kind>(FeatureKind::whole) == ABUT_FEATURE_WHOLE);
static_assert(static_cast<abut_feature_kind>(FeatureKind::vertex) == ABUT_FEATURE_VERTEX);
static_assert(static_cast<abut_feature_kind>(FeatureKind::edge) == ABUT_FEATURE_EDGE);
static_assert(static_cast<abut_feature_kind>(FeatureKind::face) == ABUT_FEATURE_FACE);
static_assert(static_cast<abut_algorithm>(Algorithm::automatic) == ABUT_ALGORITHM_AUTO);
static_assert(static_cast<abut_algorithm>(Algorithm::analytic) == ABUT_ALGORITHM_ANALYTIC);
static_assert(static_cast<abut_algorithm>(Algorithm::sat) == ABUT_ALGORITHM_SAT);
static_assert(static_cast<abut_algorithm>(Algorithm::gjk_epa) == ABUT_ALGORITHM_GJK_EPA);
static_assert(static_cast<abut_algorithm>(Algorithm::libccd_gjk) == ABUT_ALGORITHM_LIBCCD_GJK);
static_assert(static_cast<abut_algorithm>(Algorithm::libccd_mpr) == ABUT_ALGORITHM_LIBCCD_MPR);
static_assert(static_cast<abut_algorithm>(Algorithm::flat_ground) == ABUT_ALGORITHM_FLAT_GROUND);
static_assert(static_cast<abut_algorithm>(Algorithm::separating_translation) == ABUT_ALGORITHM_SEPARATING_TRANSLATION);
static_assert(static_cast<abut_algorithm>(Algorithm::solid) == ABUT_ALGORITHM_SOLID);
static_assert(static_cast<abut_algorithm>(Algorithm::field) == ABUT_ALGORITHM_FIELD);
static_assert(static_cast<abut_algorithm>(Algorithm::hole) == ABUT_ALGORITHM_HOLE);
static_assert(static_cast<abut_algorithm>(Algorithm::rims) == ABUT_ALGORITHM_RIMS);

}  // namespace abut::capi

#endif
