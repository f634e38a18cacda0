// SPDX-License-Identifier: Apache-2.0
// Contacts of runs of pairs of the same two kinds, which look up their kernel once.
export module abut.pairs.two_shapes.runs;
import abut.capability;
import abut.core.standard;
import abut.math;
export import abut.pairs.pair_job;
import abut.pairs.routes;
import abut.pairs.shape_handle;

export namespace abut {

// How the pair of kinds at two places is answered, the lower place first.
[[nodiscard]] Route route_of(std::size_t row, std::size_t column);
// Whether contacts of the pair are found sooner with a memory.
[[nodiscard]] bool gains_from_memory(std::size_t row, std::size_t column);

// The kinds of a run, by their places: the first one of each pair is of the lower place.
struct RunKinds {
  std::size_t row, column;
};

// What kernels keep of many pairs, by places. What one memory holds is theirs alone: those who keep them are not
// compiled again where it changes.
class PairMemories {
 public:
  PairMemories();
  PairMemories(PairMemories&&) noexcept;
  PairMemories& operator=(PairMemories&&) noexcept;
  ~PairMemories();

  // The place of one more, which knows nothing.
  [[nodiscard]] std::uint32_t add();
  void forget(std::uint32_t place);
  [[nodiscard]] bool knows_nothing(std::uint32_t place) const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Room;
  std::unique_ptr<Room> room_;

  friend void contacts_of_run(const RunKinds& kinds, std::span<const ShapeHandle> shapes, std::span<const Pose> poses,
                              std::span<const PairJob> jobs, const QuerySettings& common, PairMemories& memories,
                              Manifold& out, std::span<PairResult> results);
};

// Contacts of a run, in the frames of the first shapes: much of that is dropped before it is moved.
void contacts_of_run(const RunKinds& kinds, std::span<const ShapeHandle> shapes, std::span<const Pose> poses,
                     std::span<const PairJob> jobs, const QuerySettings& common, PairMemories& memories, Manifold& out,
                     std::span<PairResult> results);

// Of one pair of a run: b, placed by `ab`, with a.
[[nodiscard]] Outcome contacts_in_frame(const AnyShape& a, const AnyShape& b, const Pose& ab,
                                        const QuerySettings& settings, Manifold& out);

}  // namespace abut
