// SPDX-License-Identifier: Apache-2.0
// What is kept of a pair of geometries while their boxes overlap.
export module abut.detect.pairs;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.pairs.two_shapes.runs;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

// Who sets and who clears the flags:
// - is_unasked: set when the pair begins; cleared by the selection, once the filters are asked.
// - is_admitted, is_supported, is_sensor: the selection, when it asks the filters.
// - is_stale: set when the pair begins and by the selection; cleared there, where the pair is examined or needs no job.
// - is_new: set as is_stale, by the focus and by a new shape; cleared as is_stale.
// - is_covered: the selection, by the scope.
// - is_touching: the contacts, by what the job found; the selection, of pairs that are seen as boxes or not admitted.
// - was_touching: the selection, from is_touching.
// - is_bearing: the sleep stage.
// - is_on_path: set before the selection by the impacts, of what they answer without contacts of present poses; cleared
//   by them.
// - is_by_elements: whenever the pair gets its policy.
struct Pair {
  std::uint32_t low, high;                             // places; low is less, or both are a geometry that meets itself
  std::uint32_t generation_low, generation_high;       // of the ids that live there
  std::uint32_t first_contact = 0, contact_count = 0;  // in the list of contacts; until they are there, in the chunk
  std::uint32_t first_before = 0, count_before = 0;    // in that of the detection before
  std::uint32_t job = 0;                               // of this detection, or no_job; once it is done, its chunk
  std::uint32_t memory = no_memory;                    // place in the memories of the store
  std::uint16_t policy = 0;
  std::uint16_t run = 0;          // of the two kinds, as jobs are sorted
  bool is_unasked : 1 = true;     // the filters have not been asked
  bool is_admitted : 1 = false;   // by the filters
  bool is_supported : 1 = false;  // the two kinds have an algorithm
  bool is_stale : 1 = true;       // what it has is not of the present poses
  bool is_new : 1 = true;         // not examined since it began or a tag switched: no period delays it
  bool is_covered : 1 = false;    // by this detection
  bool is_touching : 1 = false;
  bool was_touching : 1 = false;  // before this detection
  bool is_sensor : 1 = false;
  bool is_bearing : 1 = false;  // had contacts, without a sensor, when sleep was last looked at
  bool is_on_path : 1 = false;  // no contacts of its present poses are wanted
  bool is_by_elements : 1 = false;

  // What does not follow from the rest of the universe. Memories only spare searches: a pair that is read has none.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    std::array<bool, 7> flags{self.is_unasked,  self.is_admitted, self.is_stale,  self.is_new,
                              self.is_touching, self.is_sensor,   self.is_bearing};
    archive(self.low, self.high, self.generation_low, self.generation_high, self.contact_count, self.policy, flags);
    if constexpr (Archive::is_reading) {
      self.is_unasked = flags[0];
      self.is_admitted = flags[1];
      self.is_stale = flags[2];
      self.is_new = flags[3];
      self.is_touching = flags[4];
      self.is_sensor = flags[5];
      self.is_bearing = flags[6];
    }
  }
};
inline constexpr std::uint32_t no_job = 0xffffffff;

[[nodiscard]] inline bool is_self_pair(const Pair& pair) { return pair.low == pair.high; }

// Whether a pair by elements looks at the ways of vertices, in steps with time.
[[nodiscard]] inline bool follows_vertices(const Pair& pair, std::span<const PlaceInfo> infos) {
  return infos[pair.low].sweeping == Sweeping::impacts || infos[pair.high].sweeping == Sweeping::impacts;
}

// Whether one side may carry the other: what sensors meet, what is only seen as boxes, and what meets itself holds
// nothing. A pair by elements touches while it has element contacts.
[[nodiscard]] inline bool bears(const Pair& pair) {
  return (pair.contact_count > 0 || (pair.is_by_elements && pair.is_touching)) && !pair.is_sensor &&
         !is_self_pair(pair);
}

// The kept pairs, in order of their places. A detection merges them with the pairs that the broad phase finds.
class PairStore {
 public:
  [[nodiscard]] inline std::span<Pair> all() [[clang::lifetimebound]] { return pairs_; }
  [[nodiscard]] inline std::span<const Pair> all() const [[clang::lifetimebound]] { return pairs_; }
  // Those that touched and are no longer near, or whose slots others live in, in order: of this detection.
  [[nodiscard]] inline std::span<const Pair> lost() const [[clang::lifetimebound]] { return lost_; }
  inline void forget_lost() { lost_.clear(); }
  // Into a store that is new: in order, each pair once.
  void restore(std::vector<Pair> pairs) { pairs_ = std::move(pairs); }
  // Adds pairs that end though they stay near, in any order.
  void lose(std::span<const Pair> pairs);

  // What the narrow phase keeps of pairs; a place is given to a pair that has none yet, and ends with the pair.
  [[nodiscard]] inline PairMemories& memories() [[clang::lifetimebound]] { return memories_; }
  void give_memory(Pair& pair);

  // Takes what the broad phase found. New pairs are as a Pair starts. Kept pairs are only asked which geometries they
  // are of where slots may have been used again since the last merge. O(pairs).
  void merge(const Workers& workers, std::span<const ProxyPair> near, std::span<const PlaceInfo> infos,
             bool are_slots_reused);

  [[nodiscard]] std::size_t bytes() const;

 private:
  // What one task of a merge finds.
  struct Part {
    std::vector<Pair> lost;
    std::vector<std::uint32_t> free_memories;
  };
  void merge_part(std::span<const ProxyPair> near, std::span<const Pair> before, std::span<const PlaceInfo> infos,
                  bool are_slots_reused, std::span<Pair> out, Part& part) const;

  std::vector<Pair> pairs_, before_, lost_;
  PairMemories memories_;
  std::vector<std::uint32_t> free_memories_;
  std::vector<Part> parts_;
};

}  // namespace abut
