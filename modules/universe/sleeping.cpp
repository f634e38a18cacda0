// What a universe tells the table of sleeping parts, and asks it.
module;
#include "../core/check.hpp"
module abut.universe;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.universe.checks;
import abut.universe.pairs;
import abut.universe.sleep;

namespace abut {

Result<void> Universe::set_sleep(std::span<const PartId> parts, std::span<const std::optional<Sleep>> thresholds) {
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

Result<void> Universe::wake(std::span<const PartId> parts) {
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (const PartId part : parts) {
    sleep_.wake(part.slot);
  }
  return {};
}

Result<bool> Universe::is_asleep(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return sleep_.is_asleep(part.slot);
}

void Universe::disturb(PartId part) {
  if (sleep_.is_used()) {
    sleep_.disturb({part.slot, parts_.at(part).motion == MotionKind::dynamic});
  }
}

// After the contacts are known. Of pairs that are lost, a side whose geometry is gone has been disturbed when that
// went.
void Universe::update_sleep(Real dt) {
  if (dt > 0) {
    sleep_.measure(dt, [&](PartId part) -> const Placement& { return parts_.at(part).placement; });
  }
  const auto unsettle = [&](std::uint32_t place, std::uint32_t generation) {
    if (infos_[place].generation == generation) {
      sleep_.unsettle(infos_[place].part);
    }
  };
  const auto unsettle_both = [&](const Pair& pair) {
    unsettle(pair.low, pair.generation_low);
    unsettle(pair.high, pair.generation_high);
  };
  for (const Pair& pair : pairs_.lost()) {
    if (pair.is_bearing) {
      unsettle_both(pair);
    }
  }
  for (Pair& pair : pairs_.all()) {
    const bool is_bearing = bears(pair);
    if (is_bearing != pair.is_bearing) {
      pair.is_bearing = is_bearing;
      unsettle_both(pair);
    }
    if (is_bearing) {
      const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
      sleep_.touch({low.part, low.is_moving}, {high.part, high.is_moving});
    }
  }
  sleep_.settle(dt > 0, island_links_);
}

// The pair touches, but none of its dynamic parts is awake.
bool Universe::is_asleep(const Pair& pair) const {
  if (sleep_.asleep_count() == 0 || !pair.is_touching) {
    return false;
  }
  const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
  return (!low.is_moving || sleep_.is_asleep(low.part)) && (!high.is_moving || sleep_.is_asleep(high.part));
}

}  // namespace abut
