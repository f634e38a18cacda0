// SPDX-License-Identifier: Apache-2.0
// Which geometries changed last, for those who follow a scene from outside.
export module abut.scene.journal;
import abut.core.standard;
import abut.scene.state.options;

export namespace abut {

// The last changes, by the slot of the geometry, in a ring of fixed size: nothing here allocates after the beginning.
// Edits are told apart by the sum of both counters of the revision after them, which grows with each.
class Journal {
 public:
  Journal() : slots_(capacity), times_(capacity) {}

  [[nodiscard]] static std::uint64_t time_of(const Revision& revision) { return revision.geometries + revision.poses; }

  void note(std::uint32_t slot, std::uint64_t time);
  // Nothing up to this time is known any more.
  void forget(std::uint64_t time);
  // Whether that many changes fit in at once.
  [[nodiscard]] static bool holds(std::size_t count) { return count <= capacity; }

  // The slots that have changed after a time, each once, in order. None where more has changed than is known.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> slots_after(std::uint64_t time) const;

  [[nodiscard]] std::size_t bytes() const {
    return slots_.capacity() * sizeof(std::uint32_t) + times_.capacity() * sizeof(std::uint64_t);
  }

 private:
  static constexpr std::size_t capacity = 512;

  std::vector<std::uint32_t> slots_;
  std::vector<std::uint64_t> times_;
  std::size_t next_ = 0;          // where the next one goes
  std::size_t count_ = 0;         // of those in the ring
  std::uint64_t known_from_ = 0;  // all later changes are in the ring
};

}  // namespace abut
