// SPDX-License-Identifier: Apache-2.0
// What callers say about sleep.
module;
#include "../../core/check.hpp"
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.scene.meetings.checks;
import abut.scene.rest.sleep;

namespace abut {

Result<void> Scene::set_sleep(std::span<const PartId> parts, std::span<const std::optional<Sleep>> thresholds) {
  ABUT_CHECK(parts.size() == thresholds.size());
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    if (Fault fault = thresholds[i] ? check_sleep(*thresholds[i]) : std::nullopt) {
      return Error{fault->code, name_at("thresholds", i) + "." + fault->message};
    }
  }
  std::uint32_t highest = 0;
  for (const PartId part : parts) {
    highest = std::max(highest, part.slot);
  }
  sleep_.make_room(parts.size(), highest);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    sleep_.set(parts[i], parts_.at(parts[i]).motion == MotionKind::dynamic, thresholds[i]);
  }
  return {};
}

Result<void> Scene::wake(std::span<const PartId> parts) {
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (const PartId part : parts) {
    sleep_.wake(part.slot);
  }
  return {};
}

Result<bool> Scene::is_asleep(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return sleep_.is_asleep(part.slot);
}

void Scene::disturb(PartId part) {
  if (sleep_.is_used()) {
    sleep_.disturb({part.slot, parts_.at(part).motion == MotionKind::dynamic});
  }
}

}  // namespace abut
