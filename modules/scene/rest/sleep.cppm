// SPDX-License-Identifier: Apache-2.0
// Which parts have come to rest.
export module abut.scene.rest.sleep;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.state.options;
import abut.scene.rest.velocity;

export namespace abut {

// Parts that may fall asleep, by the slot of the part, and what they need for it. A detection calls, in this order,
// measure if time has passed, touch and unsettle for what it found, and settle. A part that was never set costs
// nothing.
class SleepTable {
 public:
  // One of two parts that touch.
  struct Side {
    std::uint32_t slot;
    bool is_dynamic;
  };

  // Whether a detection has anything to ask or to take back.
  [[nodiscard]] inline bool is_used() const { return !members_.empty() || !changes_.empty(); }
  [[nodiscard]] inline std::size_t asleep_count() const { return asleep_count_; }
  [[nodiscard]] bool is_asleep(std::uint32_t slot) const;
  // Of the last detection, by slot.
  [[nodiscard]] inline std::span<const SleepChange> changes() const [[clang::lifetimebound]] { return changes_; }

  // So that the next `count` calls of set cannot fail.
  void make_room(std::size_t count, std::uint32_t highest_slot);
  // What is equal to what is there changes nothing; all else wakes. No thresholds: the part never sleeps by itself.
  void set(PartId part, bool is_dynamic, const std::optional<Sleep>& thresholds);
  void set_dynamic(std::uint32_t slot, bool is_dynamic);
  void forget(std::uint32_t slot);
  // Wakes it with its island at the next detection, and counts its steps anew.
  void wake(std::uint32_t slot);
  // After a change of the part, of its pose or of its geometries. What is not dynamic wakes whatever it touches.
  void disturb(const Side& part);

  // Speeds and accelerations of a step that took dt: from where parts are, and where they were in the steps before.
  template <class PlacementOf>
  void measure(Real dt, PlacementOf&& placement_of) {
    for (Member& member : members_) {
      // A sleeping part that nobody has disturbed lies where it was.
      if (!member.is_asleep || member.unrest != Unrest::none) {
        measure_one(member, placement_of(member.part), dt);
      }
    }
  }
  // Two parts that touch: one that never sleeps, or moves though it is not dynamic, keeps the other awake.
  void touch(const Side& a, const Side& b);
  // A part of which a touch begins or ends.
  void unsettle(std::uint32_t slot);
  // Decides island by island, by the lowest slot of the island of each part, which stands at its slot less one. Parts
  // only fall asleep in steps in which time passes.
  void settle(bool has_time_passed, std::span<const std::uint32_t> lowest_slots);

  [[nodiscard]] std::size_t bytes() const;

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.members_, self.moved_, self.changes_);
  }
  // What follows from what was read, of parts with slots up to `highest`. Whether all of it may be so; `is_there` tells
  // whether there is a part of an id.
  template <class IsThere>
  [[nodiscard]] bool restore(std::uint32_t highest, IsThere&& is_there) {
    return std::ranges::all_of(members_, [&](const Member& its) { return is_there(its.part) && is_right(its); }) &&
           std::ranges::all_of(moved_, [&](std::uint32_t slot) { return slot > 0 && slot <= highest; }) &&
           place_all(highest);
  }

 private:
  // Why a part does not sleep in this step; the greater one counts.
  enum class Unrest : std::uint8_t {
    none,
    touch,  // a touch began or ended
    call,   // the caller has changed it: it has to be calm for all of its steps again
  };
  struct Member {
    PartId part;
    Sleep thresholds;
    Placement before;   // in the step before
    Velocity velocity;  // there
    std::uint32_t calm_steps = 0;
    std::uint32_t measured = 0;  // steps, up to two, which it takes to know speeds
    Unrest unrest = Unrest::none;
    bool is_dynamic;
    bool has_thresholds = true;
    bool is_asleep = false;
    bool is_kept_awake = false;  // by what it touches
  };

  [[nodiscard]] static bool is_right(const Member& member);
  [[nodiscard]] bool place_all(std::uint32_t highest);
  [[nodiscard]] std::uint32_t member_at(std::uint32_t slot) const;
  [[nodiscard]] std::uint32_t dynamic_member_at(const Side& side) const;
  [[nodiscard]] bool keeps_awake(const Side& side) const;
  [[nodiscard]] static bool is_ready(const Member& member, bool has_time_passed);
  static void measure_one(Member& member, const Placement& placement, Real dt);
  void turn_to(Member& member, bool is_asleep);
  void drop(std::uint32_t member);

  static constexpr std::uint32_t no_member = 0xffffffff;

  std::vector<Member> members_;
  std::vector<std::uint32_t> places_;  // in members_, by slot less one
  std::vector<bool> has_moved_;        // by slot less one, of parts that are not dynamic, since the last step with time
  std::vector<std::uint32_t> moved_;   // their slots
  std::vector<bool> is_island_awake_;  // by its lowest slot, less one
  std::vector<SleepChange> changes_;
  std::size_t asleep_count_ = 0;
};

// The first number of thresholds that is not one that they may have.
[[nodiscard]] Fault check_sleep(const Sleep& sleep);

}  // namespace abut
