// SPDX-License-Identifier: Apache-2.0
// Pairs whose policy asks for vertices, edges and faces: closest features, or first touches on the ways of vertices.
export module abut.detect.elements;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.math;
import abut.proximity.body;
import abut.proximity.closest;
import abut.proximity.first_touches;
import abut.proximity.stencil;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

export namespace abut {

inline constexpr bool finds_elements = true;

// Whether shapes of a kind have triangles, and so elements.
[[nodiscard]] bool has_elements(std::size_t kind);

// Two features of a pair, in the world.
struct ElementContact {
  GeometryId geometry_a, geometry_b;
  Stencil stencil;
  Real gap;
  std::uint64_t id;
};

class ElementStage {
 public:
  // Once boxes are up to date: reads the vertices of what is fresh, and finds the pairs that may touch on the ways of
  // vertices. Returns whether these pairs are others than before. O(geometries that may have such pairs), and O(n) of
  // those that are fresh; with time also O(fast ones * all of them).
  [[nodiscard]] bool follow(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                            std::span<const std::uint32_t> fresh, bool has_time, Places& places);
  // These pairs and those of the broad phase, each once, in order, until the next call.
  [[nodiscard]] std::span<const ProxyPair> with(std::span<const ProxyPair> near) [[clang::lifetimebound]];
  // Answers the jobs of such pairs; pairs without a job keep what they have. Ends the ways of a step.
  void run(const Workers& workers, const PolicyTable& policies, Places& places, std::span<const Pair> pairs,
           JobList& jobs);

  // Of the last detection, in the order of the pairs.
  [[nodiscard]] std::span<const ElementContact> all() const [[clang::lifetimebound]] { return contacts_; }
  // Their bits, after those of another hash.
  [[nodiscard]] std::uint64_t hash_after(std::uint64_t hash) const;

  // Between detections.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    if constexpr (Archive::is_reading) {
      archive(self.had_time_, self.saved_, self.contacts_);
    } else {
      archive(self.had_time_, self.saved_bodies(), self.contacts_);
    }
  }
  // Of a stage that was read: reads the vertices. Whether the contacts are of places that are there, in order.
  [[nodiscard]] bool restore(const Places& places, const PolicyTable& policies);
  [[nodiscard]] std::size_t bytes() const;

 private:
  // A geometry that may have such pairs.
  struct Body {
    std::uint32_t generation = 0;
    bool is_shown = true;
    bool was_on_way = false;        // in the last step with time
    bool has_moved = false;         // since then
    bool is_too_far = false;        // for sixth powers of its coordinates
    bool lies_on_way = false;       // in the elements
    bool is_laid = false;           // in the elements
    std::vector<Vec3> rest;         // where the first detection saw the vertices
    std::vector<Vec3> now, before;  // in the world; `before` in the last step with time
    std::vector<std::uint32_t> triangles;
    CompactAabb way{};                      // around both
    std::unique_ptr<ElementBody> elements;  // from the first job on
  };
  using Bodies = std::map<std::uint32_t, Body>;  // by place
  struct SavedBody {
    std::uint32_t place, generation;
    bool was_on_way;
    std::vector<Vec3> rest, before;
  };
  // The contacts of a pair.
  struct Run {
    std::uint32_t low, high, generation_low, generation_high;
    std::size_t first, count;
  };

  [[nodiscard]] static bool is_of(const Run& run, const Pair& pair);
  [[nodiscard]] bool may_have_pairs(std::uint32_t place, const Places& places) const;
  static void read(std::uint32_t place, const Places& places, Body& body);
  Body& body_at(std::uint32_t place, const Places& places);
  void find_ways(const BoxFrame& frame, const PolicyTable& policies, const Space& space, const Places& places);
  [[nodiscard]] bool keeps_all(std::span<const Pair> pairs) const;
  static ElementBody& laid(Body& body, bool on_way, const Workers& workers);
  void find(const Workers& workers, const Policy& policy, Real reach, const Pair& pair, const Places& places);
  void append(const Policy& policy, const Pair& pair);
  void end_ways(Places& places);
  void make_runs();
  [[nodiscard]] std::vector<SavedBody> saved_bodies() const;

  Bodies bodies_;
  std::uint64_t tags_ = 0;  // of the bodies
  bool had_time_ = false;   // the last detection
  std::vector<ProxyPair> pairs_, pairs_before_, joined_;
  ClosestFeatures closest_;
  FirstTouches first_touches_;
  std::vector<Stencil> stencils_;
  std::vector<ElementContact> contacts_, contacts_before_;
  std::vector<Run> runs_, runs_before_;
  std::vector<SavedBody> saved_;  // only between reading and restoring
};

}  // namespace abut
