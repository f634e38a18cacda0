module abut.universe.sleep;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.shape;
import abut.universe.options;

namespace abut {
namespace {

Vec3 over(const Vec3& v, Real divisor) { return {v.x / divisor, v.y / divisor, v.z / divisor}; }

// For |t| below 0.1, where what the series leaves out is below rounding.
Real small_arc_tangent(Real t) {
  const Real s = t * t;
  return t * (1 - s * (1. / 3 - s * (1. / 5 - s * (1. / 7 - s * (1. / 9 - s * (1. / 11 - s * (1. / 13 - s / 15)))))));
}

}  // namespace

// The quaternion of the turn is (cos h, sin h * axis) for half of its angle, h. The tangent of half an angle is t / (1 + sqrt(1 +
// t^2)), and square roots are the same on every platform, unlike the functions of the library that would answer at once.
Vec3 turn_between(const Quat& before, const Quat& after) {
  const Quat &a = after, &b = before;
  Real w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  Vec3 v{a.x * b.w - a.w * b.x + (a.z * b.y - a.y * b.z), a.y * b.w - a.w * b.y + (a.x * b.z - a.z * b.x),
         a.z * b.w - a.w * b.z + (a.y * b.x - a.x * b.y)};
  if (w < 0) {
    w = -w;
    v = -v;
  }
  const Real sine = norm(v);
  if (sine == 0) {
    return {0, 0, 0};
  }
  Real t = sine / (w + std::sqrt(w * w + sine * sine));  // of a quarter of the angle, at most 1
  for (int i = 0; i < 3; ++i) {
    t = t / (1 + std::sqrt(1 + t * t));
  }
  return (32 * small_arc_tangent(t) / sine) * v;
}

Fault check_sleep(const Sleep& sleep) {
  if (sleep.steps == 0) {
    return error_about(Errc::out_of_range, "steps", std::uint64_t{0}, "at least 1");
  }
  for (const auto& [name, value] : {std::pair{"linear_speed", sleep.linear_speed},
                                    std::pair{"linear_acceleration", sleep.linear_acceleration},
                                    std::pair{"angular_speed", sleep.angular_speed},
                                    std::pair{"angular_acceleration", sleep.angular_acceleration}}) {
    if (Fault fault = check_not_negative(name, value)) {
      return fault;
    }
  }
  return std::nullopt;
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
      members_.push_back({.part = part,
                          .thresholds = *thresholds,
                          .before = {},
                          .velocity = {},
                          .spin = {},
                          .island = places_[part.slot - 1],
                          .is_dynamic = is_dynamic});
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
  const Vec3 velocity = over(placement.position - member.before.position, dt);
  const Vec3 spin = over(turn_between(member.before.orientation, placement.orientation), dt);
  const bool is_calm = member.measured == 2 && norm(velocity) <= limits.linear_speed && norm(spin) <= limits.angular_speed &&
                       norm(velocity - member.velocity) / dt <= limits.linear_acceleration &&
                       norm(spin - member.spin) / dt <= limits.angular_acceleration;
  member.calm_steps = is_calm ? std::min(member.calm_steps + 1, limits.steps) : 0;
  member.before = placement;
  member.velocity = velocity;
  member.spin = spin;
  member.measured = std::min(member.measured + 1, 2u);
}

void SleepTable::start_islands() {
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    members_[i].island = i;
    members_[i].is_kept_awake = members_[i].is_island_awake = false;
  }
}

// What does not move is in nobody's island, or the ground would be in all of them.
void SleepTable::touch(const Side& a, const Side& b) {
  const std::uint32_t one = dynamic_member_at(a), other = dynamic_member_at(b);
  if (one != no_member && other != no_member) {
    const std::uint32_t low = std::min(island_of(one), island_of(other)), high = std::max(island_of(one), island_of(other));
    members_[high].island = low;
  } else if (one != no_member) {
    members_[one].is_kept_awake = members_[one].is_kept_awake || keeps_awake(b);
  } else if (other != no_member) {
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

void SleepTable::settle(bool has_time_passed) {
  changes_.clear();
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    Member& island = members_[island_of(i)];
    island.is_island_awake = island.is_island_awake || !is_ready(members_[i], has_time_passed);
  }
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    Member& member = members_[i];
    turn_to(member, !members_[island_of(i)].is_island_awake);
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
    member.velocity = member.spin = {0, 0, 0};
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

std::uint32_t SleepTable::member_at(std::uint32_t slot) const { return slot <= places_.size() ? places_[slot - 1] : no_member; }

std::uint32_t SleepTable::dynamic_member_at(const Side& side) const { return side.is_dynamic ? member_at(side.slot) : no_member; }

// A dynamic part that never sleeps, and what is not dynamic but moves.
bool SleepTable::keeps_awake(const Side& side) const {
  return side.is_dynamic || (side.slot <= has_moved_.size() && has_moved_[side.slot - 1]);
}

// Each member points to one before it in the list, or to itself. Paths are halved on the way.
std::uint32_t SleepTable::island_of(std::uint32_t member) {
  while (members_[member].island != member) {
    members_[member].island = members_[members_[member].island].island;
    member = members_[member].island;
  }
  return member;
}

std::size_t SleepTable::bytes() const {
  return members_.capacity() * sizeof(Member) + (places_.capacity() + moved_.capacity()) * sizeof(std::uint32_t) +
         has_moved_.capacity() / 8 + changes_.capacity() * sizeof(SleepChange);
}

}  // namespace abut
