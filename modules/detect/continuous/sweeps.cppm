// SPDX-License-Identifier: Apache-2.0
// The broad phase of those that look at their path through a step: whom they may meet on it.
//
// The broad phase holds no swept boxes: a long box in the tree would slow down queries and other pairs. Instead, fast
// geometries search the tree of present poses with pieces of their paths, grown by the distance that slow ones travel.
// Geometries that travel further than the mean size of fast ones are compared with each other.
export module abut.detect.continuous.sweeps;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.refresh;
import abut.detect.paths;
import abut.math;
import abut.pairs.taken_apart.convex_part;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.state.space;

export namespace abut {

// Boxes of the broad phase stay those of the present poses, so that other pairs and queries do not hear of paths. A
// geometry with a sweeping asks the broad phase for whom its swept box meets, grown by how far slow ones get. Whoever
// is quicker is in a list of movers, which are tried with each other.
//
// A coarse box of the way is tried first: where it meets nothing, as of most that fly through open space, no path is
// made. A long way is halved again and again, and those met are asked again by each half: a long diagonal motion does
// not meet all that is in its box.
class Sweeps {
 public:
  // A geometry that has a sweeping, or gets far, and whose coarse box meets another one.
  struct Mover {
    std::uint32_t place;
    bool has_sweeping;
    Path path;
    Pose end;                        // of the path
    Real margin;                     // around its shape
    std::optional<ConvexPart> part;  // its shape, if that is convex
    Aabb own;                        // the box of its shape in its own frame
    Reach reach;                     // of the core of its shape
    Real radius;                     // of its shape around the centre of the path
    Real size;                       // the largest side of its box at the start
    Aabb box;                        // of its whole way
  };

  // Notes happened_on_path of the geometries with a sweeping that show. Whether the pairs are others than before.
  [[nodiscard]] bool run(const Workers& workers, const Paths& paths, const BoxFrame& frame, const Space& space,
                         std::span<const std::uint32_t> swept_places, Places& places);
  void clear() { pairs_.clear(); }

  // Of which one geometry at least has a sweeping, and that may come together within the step; in order. Never of one
  // part, never of two that are not dynamic.
  [[nodiscard]] std::span<const ProxyPair> pairs() const [[clang::lifetimebound]] { return pairs_; }
  // These and those of the broad phase, each once, in order. Until the next call, each of these is at one of `numbers`.
  [[nodiscard]] std::span<const ProxyPair> with(std::span<const ProxyPair> near) [[clang::lifetimebound]];
  [[nodiscard]] std::span<const std::uint32_t> numbers() const [[clang::lifetimebound]] { return numbers_; }
  // Of a geometry of one of the pairs; null where it is none.
  [[nodiscard]] const Mover* mover_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return mover_at_[place] == no_index ? nullptr : &movers_[mover_at_[place]];
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // A geometry that has a sweeping, or gets far.
  struct Candidate {
    std::uint32_t place;
    bool has_sweeping, is_mover;
    CompactAabb box;  // coarse, of its whole way
  };
  struct Near {
    std::uint32_t place;
    CompactAabb box;  // of all its path
  };
  // What one task finds, and what it remembers of the mover that it looks at.
  struct Task {
    std::vector<ProxyPair> pairs;
    std::vector<Near> near;
    std::vector<std::uint32_t> seen_by;  // the last mover that has met a place, by place
  };

  void add_mover(const Paths& paths, const BoxFrame& frame, std::uint32_t place, const Places& places);
  void find_candidates(const Paths& paths, const BoxFrame& frame, const Space& space,
                       std::span<const std::uint32_t> swept_places, Places& places);
  void pair_candidates(const Places& places);
  void find_movers(const Workers& workers, const Paths& paths, const BoxFrame& frame, const Space& space,
                   const Places& places);
  void meet_slow(std::uint32_t number, const Paths& paths, const BoxFrame& frame, const Space& space,
                 const Places& places, Task& task) const;
  void halve(std::uint32_t number, const TimeSpan& span, std::size_t first, int depth, const BoxFrame& frame,
             const Places& places, Task& task) const;
  void meet_movers(const Places& places);
  [[nodiscard]] bool may_meet(const Mover& a, const Mover& b, const TimeSpan& span, int depth,
                              const Places& places) const;

  std::vector<Candidate> candidates_;                     // first those with a sweeping
  std::size_t swept_ = 0;                                 // how many of these have one
  std::vector<bool> is_candidate_;                        // by place
  bool has_others_ = false;                               // whether anything is no candidate
  std::vector<std::pair<float, std::uint32_t>> by_side_;  // low sides of candidates and their numbers, in order
  std::vector<CompactAabb> side_boxes_;                   // in that order
  std::vector<ProxyPair> coarse_pairs_;                   // places of candidates whose boxes meet
  std::vector<Mover> movers_;
  std::vector<std::uint32_t> mover_at_;  // by place; no_index where there is none
  Real slow_way_ = 0;                    // of those that are no candidates
  std::vector<Task> tasks_;
  std::vector<ProxyPair> pairs_, pairs_before_, joined_, scratch_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace abut
