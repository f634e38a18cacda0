// SPDX-License-Identifier: Apache-2.0
// abut_universe: a universe of the modules, and what the C interface lends out of it.
#ifndef ABUT_CAPI_UNIVERSE_HANDLE_HPP
#define ABUT_CAPI_UNIVERSE_HANDLE_HPP

#include "prelude.hpp"

#include "convert.hpp"
#include "universe/extension.hpp"
#include "guard.hpp"
#include "shapes/shape_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.universe;

namespace abut::capi {

// What a step found, in the words of the C interface: converted when it is first asked for, by one of the threads that
// ask, into memory that stays from step to step.
template <class Value>
class Lent {
 public:
  // For [exclusive] calls, after what was converted has changed.
  void forget() { is_current_.store(false, std::memory_order_relaxed); }

  template <class Found, class Convert>
  [[nodiscard]] std::span<const Value> get(std::span<const Found> found, Convert&& convert) const {
    return get_filled(found.size(),
                      [&](std::span<Value> out) { std::transform(found.begin(), found.end(), out.begin(), convert); });
  }
  // fill(values) writes them all.
  template <class Fill>
  [[nodiscard]] std::span<const Value> get_filled(std::size_t count, Fill&& fill) const {
    if (!is_current_.load(std::memory_order_acquire)) {
      const std::scoped_lock lock(mutex_);
      if (!is_current_.load(std::memory_order_relaxed)) {
        values_.resize(count);
        fill(std::span<Value>(values_));
        is_current_.store(true, std::memory_order_release);
      }
    }
    return values_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> is_current_{false};
  mutable std::vector<Value> values_;
};

}  // namespace abut::capi

struct abut_universe {
  // Out of line: every unit would compile what all members do when they come and go.
  abut_universe(const abut::UniverseOptions& options, std::uint32_t number);
  ~abut_universe();

  abut::Universe universe;
  mutable std::atomic<bool> poisoned{false};
  bool has_told_findings = false;  // to the log
  // By slot of the geometry, less one: what abut_geometry_describe lends out.
  std::vector<abut::capi::ShapeOwner> shapes;
  // Of the focus that was set last. Stays from call to call, so that centres may move in each step without an
  // allocation.
  std::vector<abut::Vec3> centres;
  // Of the back end: what it is asked, and its present answer. They stay from step to step as well.
  std::vector<abut_backend_pair> backend_pairs;
  std::vector<abut::ContactPoint> backend_contacts;
  // Of the last step.
  abut::capi::Lent<abut_contact> contacts;
  abut::capi::Lent<abut_local_points> local_points;
  abut::capi::Lent<abut_element_contact> element_contacts;
  abut::capi::Lent<abut_event> events;
  abut::capi::Lent<abut_step_impact> impacts;
  abut::capi::Lent<abut_sleep_change> sleep_changes;
  abut::capi::Lent<abut_island> islands;
  abut::capi::Lent<abut_part_id> island_parts;
  // Changed by [const] calls, together with others.
  mutable abut::capi::Extensions extensions;
  // The creator, and each object of an extension library.
  mutable std::atomic<std::size_t> owners{1};
};

namespace abut::capi {

// Takes an owner away. The last one destroys the universe, also where a [const] call does so.
void let_go(const abut_universe& universe) noexcept;

// Tells the ids of one universe from those of the others.
[[nodiscard]] std::uint32_t next_universe_number();

// Every call on a universe, except the one that destroys it, goes through one of these three. This one is for [const]
// calls and for those that a callback may make.
template <class Handle, class Body>
  requires std::is_same_v<std::remove_const_t<Handle>, abut_universe>
[[nodiscard]] inline abut_status guard_callable_in_step(Handle* universe, Body&& body) noexcept {
  if (universe == nullptr) [[unlikely]] {
    return refuse(ABUT_NULL_ARGUMENT, "universe is null");
  }
  return guard(universe->poisoned, [&] { return std::forward<Body>(body)(*universe); });
}

template <class Body>
[[nodiscard]] inline abut_status guard(const abut_universe* universe, Body&& body) noexcept {
  return guard_callable_in_step(universe, std::forward<Body>(body));
}

// [exclusive] calls. From a callback they would change what the step is walking over.
template <class Body>
[[nodiscard]] inline abut_status guard(abut_universe* universe, Body&& body) noexcept {
  const abut_status status = guard_callable_in_step(universe, [&](abut_universe& its) -> abut_status {
    if (its.universe.is_stepping()) [[unlikely]] {
      return refuse(ABUT_BUSY,
                    "the universe is in a step; functions that are [exclusive] cannot be called from its callbacks");
    }
    return std::forward<Body>(body)(its);
  });
  if (status == ABUT_OUT_OF_MEMORY && universe->universe.is_torn()) [[unlikely]] {
    universe->poisoned.store(true, std::memory_order_relaxed);
  }
  return status;
}

[[nodiscard]] inline PartId to_part(const abut_part_id& id) { return {id.slot, id.generation}; }
[[nodiscard]] inline GeometryId to_geometry(const abut_geometry_id& id) { return {id.slot, id.generation}; }
[[nodiscard]] inline abut_part_id from_part(const PartId& id) { return {id.slot, id.generation}; }
[[nodiscard]] inline abut_geometry_id from_geometry(const GeometryId& id) { return {id.slot, id.generation}; }

[[nodiscard]] inline std::vector<PartId> to_parts(std::span<const abut_part_id> ids) {
  std::vector<PartId> parts(ids.size());
  std::transform(ids.begin(), ids.end(), parts.begin(), to_part);
  return parts;
}
[[nodiscard]] inline std::vector<GeometryId> to_geometries(std::span<const abut_geometry_id> ids) {
  std::vector<GeometryId> geometries(ids.size());
  std::transform(ids.begin(), ids.end(), geometries.begin(), to_geometry);
  return geometries;
}

// A checked pose as a placement. A quaternion of length one within rounding stays as it is, so that it
// reads back as it was set.
[[nodiscard]] inline Placement to_placement(const abut_pose& pose) {
  const Quat q = to_quat(pose.orientation);
  const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const bool is_unit = std::fabs(square - 1) <= 4 * epsilon;
  return {to_vec3(pose.position), is_unit ? q : normalized(q).value_or(q)};
}
[[nodiscard]] inline abut_pose from_placement(const Placement& placement) {
  return {from_vec3(placement.position), from_quat(placement.orientation)};
}

// The word for an id that names nothing.
template <class CId>
[[gnu::cold]] [[nodiscard]] abut_status refuse_stale(const Where& where, const CId& id) {
  return refuse(ABUT_STALE_ID, where.with(id.slot == 0 ? " is null" : " is stale or of another universe") + " (slot " +
                                   std::to_string(id.slot) + ", generation " + std::to_string(id.generation) + ")");
}

[[nodiscard]] inline bool exists(const Universe& universe, const abut_part_id& id) {
  return universe.user_data(to_part(id)).has_value();
}
[[nodiscard]] inline bool exists(const Universe& universe, const abut_geometry_id& id) {
  return universe.world_pose(to_geometry(id)).has_value();
}

// An error about a batch in the words of the call: which id was stale, with its numbers.
template <class CId>
[[gnu::cold]] [[nodiscard]] abut_status refuse_batch(const Universe& universe, std::string_view name,
                                                     std::span<const CId> ids, const Error& error) {
  if (error.code == Errc::stale_id) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!exists(universe, ids[i])) {
        return refuse_stale({name, i}, ids[i]);
      }
    }
  }
  return refuse(error);
}

}  // namespace abut::capi

#endif
