// SPDX-License-Identifier: Apache-2.0
// Pairs whose policy asks for vertices, edges and faces: closest features, or first touches on the ways of vertices.
export module abut.detect.elements;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.contact_index;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.math;
import abut.proximity.body;
import abut.proximity.closest;
import abut.proximity.first_touches;
import abut.proximity.stencil;
import abut.scene.state.lent_vertices;
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
  std::uint32_t begun;  // the age of the pair when the contact began
};

class ElementStage {
 public:
  // Once boxes are up to date: reads the vertices of what is fresh, and finds the pairs that may touch on the ways of
  // vertices. What is fast and has `lent` vertices moves from the present ones to those. All else moves from where it
  // was in the last step with time to the present ones. Returns whether these pairs are others than before.
  // O(geometries that may have such pairs), and O(n) of those that are fresh; with time also O(fast ones * all of
  // them).
  [[nodiscard]] bool follow(const BoxFrame& frame, const PolicyTable& policies, const Space& space,
                            std::span<const std::uint32_t> fresh, const LentVertices& lent, bool has_time,
                            Places& places);
  // Outside of a detection, with boxes up to date: the first touch of what is fast and has `lent` vertices, of those
  // that do not touch at the start. Geometries go on straight ways to the poses that `end_of` tells, and to lent
  // vertices there. `holds_up`: whether a pair counts.
  struct FirstTouch {
    std::uint32_t low, high;
    Real toi;
  };
  [[nodiscard]] std::optional<FirstTouch> first_touch(
      const Workers& workers, const BoxFrame& frame, const PolicyTable& policies, const Space& space,
      std::span<const std::uint32_t> fresh, const LentVertices& lent, const Places& places,
      const std::function<Pose(std::uint32_t)>& end_of,
      const std::function<bool(std::uint32_t, std::uint32_t)>& holds_up);
  // These pairs and those of the broad phase, each once, in order, until the next call.
  [[nodiscard]] std::span<const ProxyPair> with(std::span<const ProxyPair> near) [[clang::lifetimebound]];
  // Answers the jobs of such pairs; pairs without a job keep what they have. Ends the ways of a step.
  void run(const Workers& workers, const PolicyTable& policies, Places& places, std::span<const Pair> pairs,
           JobList& jobs);

  // Of the last detection, in the order of the pairs.
  [[nodiscard]] std::span<const ElementContact> all() const [[clang::lifetimebound]] { return contacts_; }
  [[nodiscard]] std::size_t contact_count() const { return contacts_.size(); }
  // Calls visit(contact, age) for them, in order. The age is the number of detections that covered the pair since the
  // contact began.
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (const Run& run : runs_) {
      for (const ElementContact& its : std::span(contacts_).subspan(run.first, run.count)) {
        visit(its, run.age - its.begun);
      }
    }
  }
  // The contacts of a pair in the last detection, by their ids, and where the first one is. O(log pairs).
  [[nodiscard]] std::span<const ContactHistory> histories_of(const Pair& pair) const [[clang::lifetimebound]];
  [[nodiscard]] std::size_t first_of(const Pair& pair) const;
  // Those of the detection before; of a pair that is lost, if it has gone or has another shape now.
  [[nodiscard]] std::span<const ContactHistory> histories_before_of(const Pair& pair, bool is_lost) const
      [[clang::lifetimebound]];
  // Their bits, after those of another hash.
  [[nodiscard]] std::uint64_t hash_after(std::uint64_t hash) const;

  // Between detections.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    if constexpr (Archive::is_reading) {
      archive(self.had_time_, self.saved_, self.contacts_);
    } else {
      archive(self.had_time_, self.saved_bodies(), self.saved_contacts());
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
    bool has_moved = false;         // since then, or does so on its way to `next`
    bool goes_ahead = false;        // to `next`
    bool is_too_far = false;        // for sixth powers of its coordinates
    bool lies_on_way = false;       // in the elements
    bool is_laid = false;           // in the elements
    std::vector<Vec3> rest;         // where the first detection saw the vertices
    std::vector<Vec3> now, before;  // in the world; `before` in the last step with time
    std::vector<Vec3> next;         // in the world; where lent vertices lead
    std::vector<std::uint32_t> triangles;
    CompactAabb way{};                      // around both
    std::unique_ptr<ElementBody> elements;  // from the first job on

    [[nodiscard]] std::span<const Vec3> start() const [[clang::lifetimebound]] { return goes_ahead ? now : before; }
    [[nodiscard]] std::span<const Vec3> end() const [[clang::lifetimebound]] { return goes_ahead ? next : now; }
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
    std::uint32_t age;         // detections that covered the pair
    bool is_reshaped = false;  // with nothing before
  };

  [[nodiscard]] static bool is_of(const Run& run, const Pair& pair);
  [[nodiscard]] bool may_have_pairs(std::uint32_t place, const Places& places) const;
  static void read(std::uint32_t place, const Places& places, Body& body);
  Body& body_at(std::uint32_t place, const Places& places);
  void find_ways(const BoxFrame& frame, const PolicyTable& policies, const Space& space, const Places& places);
  void read_fresh(const PolicyTable& policies, const Space& space, std::span<const std::uint32_t> fresh,
                  const Places& places);
  static void look_ahead(std::span<const Vec3> next, const Pose& world, Body& body);
  static void look_back(Body& body);
  static void find_way(const BoxFrame& frame, std::uint32_t place, const Places& places, Body& body);
  [[nodiscard]] bool keeps_all(std::span<const Pair> pairs, const Places& places) const;
  void keep_all(std::span<const Pair> pairs);
  void answer_pairs(const Workers& workers, const PolicyTable& policies, const Places& places,
                    std::span<const Pair> pairs, JobList& jobs);
  [[nodiscard]] static const Run* find_run(std::span<const Run> runs, const Pair& pair);
  [[nodiscard]] std::span<const ContactHistory> histories_before(const Run& run) const [[clang::lifetimebound]];
  static ElementBody& laid(Body& body, bool on_way, const Workers& workers);
  void find(const Workers& workers, const Policy& policy, Real reach, bool on_way, Body& low, Body& high);
  void append(const Policy& policy, const Pair& pair, std::span<const ContactHistory> before, std::uint32_t age);
  void end_ways(Places& places);
  void make_runs();
  [[nodiscard]] std::vector<SavedBody> saved_bodies() const;
  [[nodiscard]] std::vector<ElementContact> saved_contacts() const;

  Bodies bodies_;
  std::uint64_t tags_ = 0;  // of the bodies
  bool had_time_ = false;   // the last detection
  std::vector<ProxyPair> pairs_, pairs_before_, joined_;
  ClosestFeatures closest_;
  FirstTouches first_touches_;
  std::vector<Stencil> stencils_;
  std::vector<ElementContact> contacts_, contacts_before_;
  std::vector<ContactHistory> histories_, histories_before_;  // of the contacts
  std::vector<Run> runs_, runs_before_;
  bool has_kept_all_ = false;  // what is called `before` is what there is
  ContactIndex index_;
  std::vector<SavedBody> saved_;  // only between reading and restoring
};

}  // namespace abut
