// SPDX-License-Identifier: Apache-2.0
module abut.scene.rest.velocity;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.turn;
import abut.scene.state.options;

namespace abut {
namespace {

Vec3 over(const Vec3& v, Real divisor) {
  const auto quotient = [&](Real number) {
    return std::clamp(number / divisor, -largest_coordinate, largest_coordinate);
  };
  return {quotient(v.x), quotient(v.y), quotient(v.z)};
}

}  // namespace

Velocity velocity_between(const Placement& before, const Placement& after, Real dt) {
  return {over(after.position - before.position, dt), over(turn_between(before.orientation, after.orientation), dt)};
}

void VelocityTable::make_room(std::uint32_t highest, std::size_t measuring) {
  if (entries_.size() < highest) {
    moves_.resize(highest);
    entries_.resize(highest);
  }
  if (measured_.capacity() < measured_.size() + measuring) {
    measured_.reserve(std::max(2 * measured_.capacity(), measured_.size() + measuring));
  }
}

void VelocityTable::turn_to(Entry& entry, VelocitySource source) {
  if (entry.source != VelocitySource::none) {
    --counts_[static_cast<std::size_t>(entry.source)];
  }
  if (entry.source == VelocitySource::poses && source != VelocitySource::poses) {
    measured_[entry.place] = measured_.back();
    entries_[measured_[entry.place].part.slot - 1].place = entry.place;
    measured_.pop_back();
  }
  if (source != VelocitySource::none) {
    ++counts_[static_cast<std::size_t>(source)];
  }
  entry.source = source;
}

void VelocityTable::mark(std::uint32_t slot) {
  const Entry& its = entries_[slot - 1];
  moves_[slot - 1] = its.source != VelocitySource::none || its.acceleration != Acceleration{} ? 1 : 0;
}

// False where an entry is no velocity, or what is measured and the entries do not fit each other.
bool VelocityTable::count_all() {
  counts_ = {};
  accelerated_ = 0;
  moves_.assign(entries_.size(), 0);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& its = entries_[i];
    if (its.source > VelocitySource::poses || !is_finite(its.velocity.linear) || !is_finite(its.velocity.angular) ||
        !is_finite(its.acceleration.linear) || !is_finite(its.acceleration.angular)) {
      return false;
    }
    accelerated_ += its.acceleration == Acceleration{} ? 0 : 1;
    counts_[static_cast<std::size_t>(its.source)] += its.source == VelocitySource::none ? 0 : 1;
    mark(static_cast<std::uint32_t>(i + 1));
    const bool is_measured = its.source == VelocitySource::poses;
    if (is_measured && (its.place >= measured_.size() || measured_[its.place].part.slot != i + 1)) {
      return false;
    }
  }
  return count(VelocitySource::poses) == measured_.size();
}

void VelocityTable::give(std::uint32_t slot, const Velocity& velocity) {
  make_room(slot, 0);
  turn_to(entries_[slot - 1], VelocitySource::given);
  entries_[slot - 1].velocity = velocity;
  mark(slot);
}

void VelocityTable::accelerate(std::uint32_t slot, const Acceleration& acceleration) {
  if (acceleration == acceleration_of(slot)) {
    return;
  }
  make_room(slot, 0);
  accelerated_ -= entries_[slot - 1].acceleration == Acceleration{} ? 0 : 1;
  accelerated_ += acceleration == Acceleration{} ? 0 : 1;
  entries_[slot - 1].acceleration = acceleration;
  mark(slot);
}

Motion VelocityTable::motion_within(Real dt, std::uint32_t slot) const {
  if (slot > entries_.size()) {
    return {};
  }
  const auto& [velocity, acceleration, source, place] = entries_[slot - 1];
  const Motion constant{dt * velocity.linear, dt * velocity.angular};
  if (source == VelocitySource::poses) {
    return constant;
  }
  return {constant.velocity, constant.angular_velocity, dt * (dt * acceleration.linear),
          dt * (dt * acceleration.angular)};
}

Fault VelocityTable::check_motions(Real dt) const {
  // Bounds that need no square root spare most parts the rest.
  constexpr Real short_way = 1e69, small_angle = 32;
  for (std::uint32_t slot = 1; slot <= entries_.size(); ++slot) {
    if (is_still(slot)) {
      continue;
    }
    const Motion its = motion_within(dt, slot);
    const Real way = largest_magnitude(its.velocity) + largest_magnitude(its.acceleration);
    const Real angle = largest_magnitude(its.angular_velocity) + largest_magnitude(its.angular_acceleration);
    if (way <= short_way && angle <= small_angle) {
      continue;
    }
    const auto path = Path::along(Pose::identity(), {0, 0, 0}, its, 1);
    if (!path) {
      return Error{path.error().code, "dt is " + to_text(dt) + ", in which, of the part in slot " +
                                          std::to_string(slot) + ", " + path.error().message};
    }
  }
  return std::nullopt;
}

void VelocityTable::measure(PartId part, const Placement& now) {
  make_room(part.slot, 1);
  Entry& entry = entries_[part.slot - 1];
  if (entry.source == VelocitySource::poses) {
    return;
  }
  turn_to(entry, VelocitySource::poses);
  mark(part.slot);
  entry.velocity = {};
  entry.place = static_cast<std::uint32_t>(measured_.size());
  measured_.push_back({part, now});
}

void VelocityTable::forget(std::uint32_t slot) {
  if (slot <= entries_.size()) {
    turn_to(entries_[slot - 1], VelocitySource::none);
    entries_[slot - 1].velocity = {};
    mark(slot);
  }
}

std::size_t VelocityTable::bytes() const {
  return entries_.capacity() * sizeof(Entry) + moves_.capacity() + measured_.capacity() * sizeof(Measured);
}

}  // namespace abut
