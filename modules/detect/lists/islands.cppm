// SPDX-License-Identifier: Apache-2.0
// Islands: dynamic parts that touch each other, directly or through others. What does not move is in no island, or
// the ground would join all of them.
export module abut.detect.lists.islands;
import abut.core;
import abut.core.standard;
import abut.scene.state.options;

export namespace abut {

// Which parts hang together in a detection, by their slots: a union-find (Galler and Fischer, "An improved equivalence
// algorithm", 1964). An island stands behind its lowest slot, so that no order of links changes anything.
class IslandLinks {
 public:
  // Slots up to `highest`, each by itself. O(links of the detection before), and O(slots) once.
  void start(std::uint32_t highest);
  void join(std::uint32_t slot_a, std::uint32_t slot_b);
  // The lowest slot of the island. Paths are halved on the way.
  [[nodiscard]] std::uint32_t root_of(std::uint32_t slot);
  // Of all slots, by slot less one. O(slots).
  [[nodiscard]] std::span<const std::uint32_t> lowest_slots() [[clang::lifetimebound]];

  [[nodiscard]] std::size_t bytes() const { return (parents_.capacity() + joined_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> parents_;  // a lower slot of the same island, or the own one, by slot less one
  std::vector<std::uint32_t> joined_;   // slots that no longer stand alone
};

struct Island {
  std::uint64_t id;            // not 0; never used again
  std::uint32_t first, count;  // of its parts, in the list of all
};

// The islands of a detection, under ids that stay. An id goes to the island that has the lowest slot of those parts
// which had it in the detection before. An island that gets several keeps the least, one that gets none is new. So
// the older of two that merge lives on, and of one that falls apart the piece with the lowest slot.
class IslandList {
 public:
  // The parts in order of their slots, each once. O(slots).
  void number(std::span<const PartId> parts, IslandLinks& links);
  void clear();

  // By their lowest slots.
  [[nodiscard]] std::span<const Island> islands() const [[clang::lifetimebound]] { return islands_; }
  // Island by island, by slot.
  [[nodiscard]] std::span<const PartId> parts() const [[clang::lifetimebound]] { return parts_; }
  // Nothing for a part that is in none.
  [[nodiscard]] std::optional<Island> of(PartId part) const;

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.next_id_, self.islands_, self.parts_, self.seats_);
    if constexpr (Archive::is_reading) {
      archive.require(self.is_whole(), "the islands and their parts do not fit each other");
    }
  }

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Seat {
    std::uint32_t generation = 0, island = none;  // place in islands_
  };
  static constexpr std::uint32_t none = 0xffffffff;

  [[nodiscard]] bool is_whole() const;
  void group(std::span<const PartId> parts, IslandLinks& links);
  void inherit();

  std::uint64_t next_id_ = 1;
  std::vector<Island> islands_, islands_before_;
  std::vector<PartId> parts_;
  std::vector<Seat> seats_, seats_before_;  // by slot less one
  std::vector<bool> is_inherited_;          // by place in islands_before_
};

}  // namespace abut
