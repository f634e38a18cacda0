// SPDX-License-Identifier: Apache-2.0
// How fast parts move: as the caller says, or by their poses.
export module abut.scene.rest.velocity;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.motion.paths.path;
import abut.scene.state.options;

export namespace abut {

// In the world frame.
struct Velocity {
  Vec3 linear{0, 0, 0};   // of the origin of the part
  Vec3 angular{0, 0, 0};  // its axis times radians per second

  friend constexpr bool operator==(const Velocity&, const Velocity&) = default;
};

// As a Velocity, by the second.
struct Acceleration {
  Vec3 linear{0, 0, 0}, angular{0, 0, 0};

  friend constexpr bool operator==(const Acceleration&, const Acceleration&) = default;
};

enum class VelocitySource : std::uint32_t { none, given, poses };

// The constant velocity that leads from one placement to the other in a positive time, by the shorter turn. Numbers
// beyond the largest coordinate are cut to it.
[[nodiscard]] Velocity velocity_between(const Placement& before, const Placement& after, Real dt);

// Velocities of parts, by the slot of the part. Empty until one is set.
class VelocityTable {
 public:
  [[nodiscard]] inline bool is_empty() const {
    return count(VelocitySource::given) + count(VelocitySource::poses) + accelerated_ == 0;
  }
  [[nodiscard]] inline std::uint64_t count(VelocitySource source) const {
    return counts_[static_cast<std::size_t>(source)];
  }
  // Zero for a part that has none.
  [[nodiscard]] inline Velocity of(std::uint32_t slot) const {
    return slot <= entries_.size() ? entries_[slot - 1].velocity : Velocity{};
  }
  [[nodiscard]] inline VelocitySource source_of(std::uint32_t slot) const {
    return slot <= entries_.size() ? entries_[slot - 1].source : VelocitySource::none;
  }

  // Zero for a part that has none.
  [[nodiscard]] inline Acceleration acceleration_of(std::uint32_t slot) const {
    return slot <= entries_.size() ? entries_[slot - 1].acceleration : Acceleration{};
  }
  // How many have one.
  [[nodiscard]] inline std::uint64_t accelerated() const { return accelerated_; }
  // Where a part that is measured is when a step begins, until the step is settled; null for all others.
  [[nodiscard]] inline const Placement* start_of(std::uint32_t slot) const [[clang::lifetimebound]] {
    return !is_still(slot) && source_of(slot) == VelocitySource::poses ? &measured_[entries_[slot - 1].place].before
                                                                       : nullptr;
  }
  // Whether a part has neither a velocity nor an acceleration.
  [[nodiscard]] inline bool is_still(std::uint32_t slot) const { return slot > moves_.size() || moves_[slot - 1] == 0; }
  // The motion of a part within dt, with dt as the unit of time. What is measured has no acceleration.
  [[nodiscard]] Motion motion_within(Real dt, std::uint32_t slot) const;
  // The first part that moves too far or turns too often within dt.
  [[nodiscard]] Fault check_motions(Real dt) const;

  // So that calls for slots up to `highest` cannot fail, of which so many measure.
  void make_room(std::uint32_t highest, std::size_t measuring);
  void give(std::uint32_t slot, const Velocity& velocity);
  // Only of what is not measured it counts.
  void accelerate(std::uint32_t slot, const Acceleration& acceleration);
  // From where the part is now. One that is measured already goes on.
  void measure(PartId part, const Placement& now);
  void forget(std::uint32_t slot);

  // What is measured follows from where parts were when the last step with time was settled, and where they are.
  template <class PlacementOf>
  void update(Real dt, PlacementOf&& placement_of) {
    for (const Measured& its : measured_) {
      entries_[its.part.slot - 1].velocity = velocity_between(its.before, placement_of(its.part), dt);
    }
  }
  // The end of a step with time.
  template <class PlacementOf>
  void settle(PlacementOf&& placement_of) {
    for (Measured& its : measured_) {
      its.before = placement_of(its.part);
    }
  }

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.entries_, self.measured_);
  }
  // Counts what was read, of parts with slots up to `highest`. Whether all of it may be so; `is_there` tells whether
  // there is a part of an id.
  template <class IsThere>
  [[nodiscard]] bool restore(std::uint32_t highest, IsThere&& is_there) {
    const auto is_known = [&](const Measured& its) { return is_there(its.part) && is_finite(its.before.position); };
    return entries_.size() <= highest && std::ranges::all_of(measured_, is_known) && count_all();
  }

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    Velocity velocity;
    Acceleration acceleration;
    VelocitySource source = VelocitySource::none;
    std::uint32_t place = 0;  // in measured_, of one that is
  };
  struct Measured {
    PartId part;
    Placement before;
  };
  void turn_to(Entry& entry, VelocitySource source);
  void mark(std::uint32_t slot);
  [[nodiscard]] bool count_all();

  std::vector<Entry> entries_;  // by slot less one
  // Whether a part has a velocity or an acceleration, as entries have it. Most have none, and bytes stay in the cache.
  std::vector<std::uint8_t> moves_;
  std::vector<Measured> measured_;
  std::array<std::uint64_t, 3> counts_{};  // by source
  std::uint64_t accelerated_ = 0;
};

}  // namespace abut
