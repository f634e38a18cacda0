// SPDX-License-Identifier: Apache-2.0
module abut.scene.rest.sleep;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.state.options;
import abut.scene.rest.velocity;

namespace abut {

Fault check_sleep(const Sleep& sleep) {
  if (sleep.steps == 0) {
    return error_about(Errc::out_of_range, "steps", std::uint64_t{0}, "at least 1");
  }
  for (const auto& [name, value] :
       {std::pair{"linear_speed", sleep.linear_speed}, std::pair{"linear_acceleration", sleep.linear_acceleration},
        std::pair{"angular_speed", sleep.angular_speed},
        std::pair{"angular_acceleration", sleep.angular_acceleration}}) {
    if (Fault fault = check_not_negative(name, value)) {
      return fault;
    }
  }
  return std::nullopt;
}

bool SleepTable::is_right(const Member& member) {
  return !check_sleep(member.thresholds) && member.measured <= 2 && member.unrest <= Unrest::call &&
         is_finite(member.before.position) && is_finite(member.velocity.linear) && is_finite(member.velocity.angular);
}

// False where a part is there twice.
bool SleepTable::place_all(std::uint32_t highest) {
  places_.assign(highest, no_member);
  has_moved_.assign(highest, false);
  asleep_count_ = 0;
  for (std::uint32_t member = 0; member < members_.size(); ++member) {
    if (std::exchange(places_[members_[member].part.slot - 1], member) != no_member) {
      return false;
    }
    asleep_count_ += members_[member].is_asleep ? 1 : 0;
  }
  for (const std::uint32_t slot : moved_) {
    has_moved_[slot - 1] = true;
  }
  changes_.reserve(members_.capacity());
  return true;
}

bool SleepTable::is_asleep(std::uint32_t slot) const {
  const std::uint32_t place = member_at(slot);
  return place != no_member && members_[place].is_asleep;
}

void SleepTable::make_room(std::size_t count, std::uint32_t highest_slot) {
  if (members_.capacity() < members_.size() + count) {
    members_.reserve(std::max(2 * members_.capacity(), members_.size() + count));
  }
  changes_.reserve(members_.capacity());
  if (places_.size() < highest_slot) {
    places_.resize(highest_slot, no_member);
  }
}

void SleepTable::set(PartId part, bool is_dynamic, const std::optional<Sleep>& thresholds) {
  const std::uint32_t place = member_at(part.slot);
  if (place == no_member) {
    if (thresholds) {
      make_room(1, part.slot);
      places_[part.slot - 1] = static_cast<std::uint32_t>(members_.size());
      members_.push_back(
          {.part = part, .thresholds = *thresholds, .before = {}, .velocity = {}, .is_dynamic = is_dynamic});
    }
    return;
  }
  Member& member = members_[place];
  if (!thresholds && !member.is_asleep) {
    drop(place);
  } else if (member.has_thresholds != thresholds.has_value() || (thresholds && member.thresholds != *thresholds)) {
    member.has_thresholds = thresholds.has_value();
    member.thresholds = thresholds.value_or(member.thresholds);
    member.unrest = Unrest::call;
  }
}

void SleepTable::set_dynamic(std::uint32_t slot, bool is_dynamic) {
  if (const std::uint32_t place = member_at(slot); place != no_member) {
    members_[place].is_dynamic = is_dynamic;
  }
  disturb({slot, is_dynamic});
}

void SleepTable::forget(std::uint32_t slot) {
  if (const std::uint32_t place = member_at(slot); place != no_member) {
    drop(place);
  }
}

void SleepTable::wake(std::uint32_t slot) {
  if (const std::uint32_t place = member_at(slot); place != no_member) {
    members_[place].unrest = Unrest::call;
  }
}

void SleepTable::disturb(const Side& part) {
  wake(part.slot);
  if (part.is_dynamic) {
    return;
  }
  if (has_moved_.size() < part.slot) {
    has_moved_.resize(part.slot);
  }
  if (!has_moved_[part.slot - 1]) {
    moved_.push_back(part.slot);
    has_moved_[part.slot - 1] = true;
  }
}

void SleepTable::measure_one(Member& member, const Placement& placement, Real dt) {
  const Sleep& limits = member.thresholds;
  const Velocity now = velocity_between(member.before, placement, dt), &last = member.velocity;
  const bool is_calm = member.measured == 2 && norm(now.linear) <= limits.linear_speed &&
                       norm(now.angular) <= limits.angular_speed &&
                       norm(now.linear - last.linear) / dt <= limits.linear_acceleration &&
                       norm(now.angular - last.angular) / dt <= limits.angular_acceleration;
  member.calm_steps = is_calm ? std::min(member.calm_steps + 1, limits.steps) : 0;
  member.before = placement;
  member.velocity = now;
  member.measured = std::min(member.measured + 1, 2u);
}

void SleepTable::touch(const Side& a, const Side& b) {
  const std::uint32_t one = dynamic_member_at(a), other = dynamic_member_at(b);
  if (one != no_member && other == no_member) {
    members_[one].is_kept_awake = members_[one].is_kept_awake || keeps_awake(b);
  } else if (other != no_member && one == no_member) {
    members_[other].is_kept_awake = members_[other].is_kept_awake || keeps_awake(a);
  }
}

void SleepTable::unsettle(std::uint32_t slot) {
  if (const std::uint32_t place = member_at(slot); place != no_member) {
    members_[place].unrest = std::max(members_[place].unrest, Unrest::touch);
  }
}

bool SleepTable::is_ready(const Member& member, bool has_time_passed) {
  const bool has_come_to_rest = has_time_passed && member.calm_steps >= member.thresholds.steps;
  return member.is_dynamic && member.has_thresholds && !member.is_kept_awake && member.unrest == Unrest::none &&
         (member.is_asleep || has_come_to_rest);
}

void SleepTable::settle(bool has_time_passed, std::span<const std::uint32_t> lowest_slots) {
  changes_.clear();
  is_island_awake_.assign(places_.size(), false);
  for (const Member& member : members_) {
    if (!is_ready(member, has_time_passed)) {
      is_island_awake_[lowest_slots[member.part.slot - 1] - 1] = true;
    }
  }
  for (Member& member : members_) {
    turn_to(member, !is_island_awake_[lowest_slots[member.part.slot - 1] - 1]);
    member.is_kept_awake = false;
    if (has_time_passed) {
      // Until then it is remembered, so that nobody falls asleep in the step after a detection that saw it.
      member.calm_steps = member.unrest == Unrest::call ? 0 : member.calm_steps;
      member.unrest = Unrest::none;
    }
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(members_.size()); i-- > 0;) {
    if (!members_[i].has_thresholds) {
      drop(i);
    }
  }
  if (has_time_passed) {
    for (const std::uint32_t slot : moved_) {
      has_moved_[slot - 1] = false;
    }
    moved_.clear();
  }
  std::ranges::sort(changes_, {}, [](const SleepChange& change) { return change.part.slot; });
}

// A part that sleeps has no speed, whatever it had when it fell asleep; one that wakes counts from the beginning.
void SleepTable::turn_to(Member& member, bool is_asleep) {
  if (member.is_asleep == is_asleep) {
    return;
  }
  member.is_asleep = is_asleep;
  member.calm_steps = 0;
  if (is_asleep) {
    member.velocity = {};
    ++asleep_count_;
  } else {
    --asleep_count_;
  }
  changes_.push_back({member.part, is_asleep});
}

void SleepTable::drop(std::uint32_t member) {
  asleep_count_ -= members_[member].is_asleep ? 1 : 0;
  places_[members_[member].part.slot - 1] = no_member;
  if (member + 1 < members_.size()) {
    members_[member] = members_.back();
    places_[members_[member].part.slot - 1] = member;
  }
  members_.pop_back();
}

std::uint32_t SleepTable::member_at(std::uint32_t slot) const {
  return slot <= places_.size() ? places_[slot - 1] : no_member;
}

std::uint32_t SleepTable::dynamic_member_at(const Side& side) const {
  return side.is_dynamic ? member_at(side.slot) : no_member;
}

// A dynamic part that never sleeps, and what is not dynamic but moves.
bool SleepTable::keeps_awake(const Side& side) const {
  return side.is_dynamic || (side.slot <= has_moved_.size() && has_moved_[side.slot - 1]);
}

std::size_t SleepTable::bytes() const {
  return members_.capacity() * sizeof(Member) + (places_.capacity() + moved_.capacity()) * sizeof(std::uint32_t) +
         (has_moved_.capacity() + is_island_awake_.capacity()) / 8 + changes_.capacity() * sizeof(SleepChange);
}

}  // namespace abut
