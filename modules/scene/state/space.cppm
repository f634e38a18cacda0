// SPDX-License-Identifier: Apache-2.0
// Where the geometries of a scene are: their boxes in a broad phase.
export module abut.scene.state.space;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.math;
import abut.scene.state.places;

export namespace abut {

// Boxes by place. A place is absent, or present and shown or hidden; a hidden one keeps its box but is in no pair and
// no query.
class [[gsl::Pointer]] Space {
 public:
  [[nodiscard]] bool is_shown(std::uint32_t place) const { return seats_[place].presence == Presence::shown; }
  // So that places below `count` can be asked for.
  void make_room(std::size_t count) { seats_.resize(std::max(seats_.size(), count)); }
  // One that is absent, or hidden already, stays so.
  void leave(std::uint32_t place);
  void hide(std::uint32_t place);
  // The places get the boxes that they have now and are shown. Those in `rejoining` leave first, since they may no
  // longer be dynamic, or have become so. The broad phase is of the kind asked for, or of one that suits the scene.
  void update(const Workers& workers, const Places& places, BroadphaseKind wanted,
              std::span<const std::uint32_t> rejoining, std::span<const std::uint32_t> queue);

  // All pairs of shown boxes that overlap, in order; never of one part.
  void find_pairs(const Workers& workers, std::vector<ProxyPair>& out);
  // The seats as numbers, by place, for those who keep them as bytes, and back into a space that is new.
  [[nodiscard]] std::vector<std::uint8_t> presences() const;
  [[nodiscard]] static bool is_presence(std::uint8_t number) { return number <= 2; }
  void restore(const Workers& workers, const Places& places, BroadphaseKind kind,
               std::span<const std::uint8_t> presences);

  // Set by whatever changes boxes or who is shown. Cleared by who has taken the pairs.
  [[nodiscard]] bool has_changed() const { return has_changed_; }
  void set_changed(bool has_changed) { has_changed_ = has_changed; }

  // These may run on several threads at once, as those of the broad phases.
  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_place) const {
    std::visit([&](const auto& its) { its.visit(box, visit_place); }, broadphase_);
  }
  template <class Visitor>
  void sweep(const Vec3& centre, const Vec3& half, const Vec3& displacement, Real most, Visitor&& visit_place) const {
    std::visit([&](const auto& its) { its.sweep(centre, half, displacement, most, visit_place); }, broadphase_);
  }

  [[nodiscard]] BroadphaseKind kind() const { return kind_; }
  [[nodiscard]] std::string_view reason() const { return reason_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  enum class Presence : std::uint8_t { absent, hidden, shown };
  struct Seat {
    Presence presence = Presence::absent;
    bool is_moving = false;  // in the broad phase
  };
  void join_all(const Places& places);
  void choose(const Places& places, BroadphaseKind wanted, std::span<const std::uint32_t> queue);
  void join(const Places& places, std::uint32_t place);

  AnyBroadPhase broadphase_;
  BroadphaseKind kind_ = BroadphaseKind::brute;
  std::string_view reason_ = "nothing to look at yet";
  std::vector<Seat> seats_;
  std::size_t moving_count_ = 0;        // of those present
  std::vector<std::uint32_t> updates_;  // scratch
  bool has_changed_ = false;
};

}  // namespace abut
