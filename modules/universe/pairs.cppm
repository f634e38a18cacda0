// What is kept of a pair of geometries while their boxes overlap.
export module abut.universe.pairs;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.math;
import abut.narrow.warm.pair_memory;
import abut.universe.options;

export namespace abut {

inline constexpr std::uint32_t no_patch = 0xffffffff;

// What has happened to a geometry since the last detection, by its place. All pairs ask for that in every detection, so
// it is one byte, apart from all that only some pairs ask for.
enum Happened : std::uint8_t {
  happened_to_box = 1,      // it moved, is new, or changed
  happened_to_filters = 2,  // what filters ask about
  happened_to_shape = 4,    // another shape: contacts of the detection before are of the one before
  happened_to_surface = 8,  // the same shape, but not as it was
  happened_to_tag = 16,     // the focus has given it another one
};

// What pairs ask about a geometry, by its place: one cache line.
struct PlaceInfo {
  std::uint64_t layers = 0, mask = 0, exclusion = 0;
  Real tolerance = 0;
  std::uint32_t generation = 0, part = 0;  // slot of the part
  std::uint32_t tag = 0, material = 0;
  std::uint8_t kind = 0;  // place in the registry
  bool is_sensor = false;
  bool is_at_part = false;    // its pose is that of its part
  bool is_box_stale = false;  // moved or changed while it was parked
  bool is_queued = false;     // waits for its box
  bool is_moving = false;     // in the broad phase as a moving one
  bool has_self_pairs = false;
  std::uint32_t patch = no_patch;  // where alone it has changed since the last detection, if that is known
};
static_assert(sizeof(PlaceInfo) <= 64);

// Where in the world a geometry that has not moved is not as it was, as far as its box reaches.
struct Patch {
  std::uint32_t place;
  Aabb box;
  CompactAabb compact_box;
};

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
};
inline constexpr std::uint32_t no_job = 0xffffffff;

[[nodiscard]] inline bool is_self_pair(const Pair& pair) { return pair.low == pair.high; }

// Whether one side may carry the other: what sensors meet, what is only seen as boxes, and what meets itself holds
// nothing.
[[nodiscard]] inline bool bears(const Pair& pair) {
  return pair.contact_count > 0 && !pair.is_sensor && !is_self_pair(pair);
}

// The kept pairs, in order of their places. A detection merges them with the pairs that the broad phase finds.
class PairStore {
 public:
  [[nodiscard]] inline std::span<Pair> all() [[clang::lifetimebound]] { return pairs_; }
  [[nodiscard]] inline std::span<const Pair> all() const [[clang::lifetimebound]] { return pairs_; }
  // Those that touched and are no longer near, or whose slots others live in, in order: of this detection.
  [[nodiscard]] inline std::span<const Pair> lost() const [[clang::lifetimebound]] { return lost_; }
  inline void forget_lost() { lost_.clear(); }
  // Adds pairs that end though they stay near, in any order.
  void lose(std::span<const Pair> pairs);

  // What the narrow phase keeps of pairs; a place is given to a pair that has none yet, and ends with the pair.
  [[nodiscard]] inline std::span<PairMemory> memories() [[clang::lifetimebound]] { return memories_; }
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
  std::vector<PairMemory> memories_;
  std::vector<std::uint32_t> free_memories_;
  std::vector<Part> parts_;
};

}  // namespace abut
