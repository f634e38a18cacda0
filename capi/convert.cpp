// SPDX-License-Identifier: Apache-2.0
#include "convert.hpp"

namespace abut::capi {
namespace {

struct [[gsl::Pointer]] Component {
  std::string_view name;
  double value;
};

// The first component that is not a coordinate.
Fault fault_of(const Where& where, std::string_view field, std::span<const Component> components) {
  for (const Component& component : components) {
    if (Fault fault = check_finite(where.with(std::string(field) + std::string(component.name)), component.value)) {
      return fault;
    }
  }
  return std::nullopt;
}

}  // namespace

abut_status refuse_vec3(const Where& where, std::string_view field, const abut_vec3& v) {
  return to_status(fault_of(where, field, std::array<Component, 3>{{{".x", v.x}, {".y", v.y}, {".z", v.z}}}));
}

abut_status refuse_pose(const Where& where, const abut_pose& pose) {
  if (const abut_status status = refuse_vec3(where, ".position", pose.position); status != ABUT_OK) {
    return status;
  }
  const abut_quat& q = pose.orientation;
  for (const Component& component : std::array<Component, 4>{{{".w", q.w}, {".x", q.x}, {".y", q.y}, {".z", q.z}}}) {
    if (!std::isfinite(component.value)) {
      return refuse(error_about(Errc::not_finite, where.with(".orientation" + std::string(component.name)),
                                component.value, "finite"));
    }
  }
  // hypot neither overflows nor underflows on the way.
  const double length = std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z));
  if (length == 0) {
    return refuse(ABUT_ZERO_VECTOR, where.with(".orientation has length 0; it must be 1 within 1e-3"));
  }
  return refuse(ABUT_NOT_UNIT, where.with(".orientation has length ") + to_text(length) + "; it must be 1 within 1e-3");
}

}  // namespace abut::capi
