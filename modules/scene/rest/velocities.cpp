// SPDX-License-Identifier: Apache-2.0
// Velocities of the parts of a universe.
module;
#include "../../core/check.hpp"
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.scene.meetings.checks;
import abut.scene.rest.velocity;

namespace abut {
namespace {

// Of a Velocity or an Acceleration.
template <class Rates>
Fault check_rates(const Rates& rates, std::string_view array, std::size_t index) {
  const auto& [linear, angular] = rates;
  for (const auto& [name, value] :
       {std::pair{".linear.x", linear.x}, std::pair{".linear.y", linear.y}, std::pair{".linear.z", linear.z},
        std::pair{".angular.x", angular.x}, std::pair{".angular.y", angular.y}, std::pair{".angular.z", angular.z}}) {
    if (Fault fault = check_finite(name, value)) {
      return Error{fault->code, name_at(array, index) + fault->message};
    }
  }
  return std::nullopt;
}

std::uint32_t highest_slot(std::span<const PartId> parts) {
  std::uint32_t highest = 0;
  for (const PartId part : parts) {
    highest = std::max(highest, part.slot);
  }
  return highest;
}

}  // namespace

Result<void> Scene::set_velocities(std::span<const PartId> parts, std::span<const std::optional<Velocity>> velocities) {
  ABUT_CHECK(parts.size() == velocities.size());
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  bool is_any_given = false;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    if (Fault fault = velocities[i] ? check_rates(*velocities[i], "velocities", i) : std::nullopt) {
      return *fault;
    }
    is_any_given = is_any_given || velocities[i];
  }
  if (is_any_given) {
    velocities_.make_room(highest_slot(parts), 0);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (velocities[i]) {
      velocities_.give(parts[i].slot, *velocities[i]);
    } else {
      velocities_.forget(parts[i].slot);
    }
  }
  return {};
}

Result<void> Scene::set_accelerations(std::span<const PartId> parts, std::span<const Acceleration> accelerations) {
  ABUT_CHECK(parts.size() == accelerations.size());
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    if (Fault fault = check_rates(accelerations[i], "accelerations", i)) {
      return *fault;
    }
  }
  velocities_.make_room(highest_slot(parts), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    velocities_.accelerate(parts[i].slot, accelerations[i]);
  }
  return {};
}

Result<Acceleration> Scene::acceleration(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return velocities_.acceleration_of(part.slot);
}

Result<void> Scene::measure_velocities(std::span<const PartId> parts) {
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  velocities_.make_room(highest_slot(parts), parts.size());
  for (const PartId part : parts) {
    velocities_.measure(part, parts_.at(part).placement);
  }
  return {};
}

Result<Velocity> Scene::velocity(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return velocities_.of(part.slot);
}

Result<VelocitySource> Scene::velocity_source(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return velocities_.source_of(part.slot);
}

}  // namespace abut
