// A space in which parts meet: parts with geometries, and steps that find their contacts.
export module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;
export import abut.universe.focus;
export import abut.universe.islands;
export import abut.universe.materials;
export import abut.universe.options;
export import abut.universe.velocity;
import abut.universe.jobs;
import abut.universe.pairs;
export import abut.universe.plan;
import abut.universe.policies;
import abut.universe.rules;
import abut.universe.sleep;

export namespace abut {

struct GeometryInfo {
  PartId part;
  ShapeHandle shape;
  Placement world;
  GeometryOptions options;
};

class Universe {
 public:
  // `number` tells universes of one process apart: their ids start at different generations.
  Universe(const UniverseOptions& options, std::uint32_t number);

  // Parts. Failures change nothing; batches take effect as a whole or not at all.
  [[nodiscard]] Result<std::vector<PartId>> create_parts(std::span<const PartOptions> options);
  [[nodiscard]] Result<void> destroy_parts(std::span<const PartId> parts);
  [[nodiscard]] Result<void> set_poses(std::span<const PartId> parts, std::span<const Placement> poses);
  [[nodiscard]] Result<void> set_motions(std::span<const PartId> parts, std::span<const MotionKind> motions);
  [[nodiscard]] Result<Placement> pose(PartId part) const;
  [[nodiscard]] Result<MotionKind> motion(PartId part) const;
  [[nodiscard]] Result<std::uint64_t> user_data(PartId part) const;
  [[nodiscard]] Result<std::vector<GeometryId>> geometries_of(PartId part) const;

  // How fast parts move: stored and handed out. Nothing is swept yet, and sleep goes by poses. None takes a velocity
  // away.
  [[nodiscard]] Result<void> set_velocities(std::span<const PartId> parts,
                                            std::span<const std::optional<Velocity>> velocities);
  // From now on by the poses: a step with time finds what leads from those of the step with time before to the
  // present ones.
  [[nodiscard]] Result<void> measure_velocities(std::span<const PartId> parts);
  // Zero for a part that has none.
  [[nodiscard]] Result<Velocity> velocity(PartId part) const;
  [[nodiscard]] Result<VelocitySource> velocity_source(PartId part) const;

  // Geometries. No options means the default ones for each.
  [[nodiscard]] Result<std::vector<GeometryId>> create_geometries(std::span<const PartId> parts,
                                                                  std::span<const ShapeHandle> shapes,
                                                                  std::span<const GeometryOptions> options);
  [[nodiscard]] Result<void> destroy_geometries(std::span<const GeometryId> geometries);
  // Changes a shape: for this geometry alone, and in place where nobody else holds it, else by a copy. Contacts live on
  // where their features do.
  [[nodiscard]] Result<void> edit_shape(GeometryId geometry, const Edit& edit);
  [[nodiscard]] Result<void> edit_shapes(std::span<const GeometryId> geometries, std::span<const Edit> edits);
  // Contacts with the shape before do not live on: features of another shape are other features.
  [[nodiscard]] Result<void> set_shapes(std::span<const GeometryId> geometries, std::span<const ShapeHandle> shapes);
  [[nodiscard]] Result<void> set_options(std::span<const GeometryId> geometries,
                                         std::span<const GeometryOptions> options);
  // From a filter callback it takes effect after the step.
  [[nodiscard]] Result<void> park(std::span<const GeometryId> geometries, Parking parking);
  [[nodiscard]] Result<GeometryInfo> describe(GeometryId geometry) const;
  [[nodiscard]] Result<Placement> world_pose(GeometryId geometry) const;

  [[nodiscard]] std::vector<PartId> parts() const;
  [[nodiscard]] std::vector<GeometryId> geometries() const;
  [[nodiscard]] inline const Revision& revision() const [[clang::lifetimebound]] { return revision_; }

  // Who meets whom. A geometry with self pairs meets itself, however its part moves, unless a rule or the filter
  // keeps it. Of two, in this order: geometries of one part never, two parts of which none is dynamic never, parked
  // ones never, common exclusion bits never, layers and masks both ways, rules, the filter. Answers are kept per pair
  // until something that they depend on changes.
  [[nodiscard]] Result<void> set_rule(const Collidable& a, const Collidable& b, Rule rule);
  void clear_rules();
  // Asked last, once for each pair that comes near, in order. It may ask the universe but not change it.
  using Filter = std::function<bool(GeometryId, GeometryId)>;
  void set_filter(Filter filter);
  // Asks everything again at the next step.
  void refilter();
  // How the pairs of two tags are treated, in either order.
  [[nodiscard]] Result<void> set_policy(std::uint32_t tag_a, std::uint32_t tag_b, const Policy& policy);
  [[nodiscard]] Result<Policy> policy(std::uint32_t tag_a, std::uint32_t tag_b) const;
  // From the next detection on, tags follow the distance of boxes from the centres; nothing ends that. A detection is
  // O(geometries) after a change, else O(moved).
  [[nodiscard]] Result<void> set_focus(const std::optional<Focus>& focus, std::span<const Vec3> centres);

  // When parts fall asleep: those that touch, all at once, after each has been calm for its steps. None: never, which
  // is the default. A sleeping part wakes, with all that it touches, when it or its geometries are changed, when
  // something else touches it or leaves it, and when what it touches moves; all of that with the next detection.
  // Detections cover sleeping parts like any others.
  [[nodiscard]] Result<void> set_sleep(std::span<const PartId> parts, std::span<const std::optional<Sleep>> thresholds);
  [[nodiscard]] Result<void> wake(std::span<const PartId> parts);
  [[nodiscard]] Result<bool> is_asleep(PartId part) const;
  // Of the last detection, by slot; parts may have been destroyed since.
  [[nodiscard]] std::span<const SleepChange> sleep_changes() const [[clang::lifetimebound]] { return sleep_.changes(); }

  // From the next detection on, or no longer: each one finds the islands, at a cost of O(pairs + parts).
  void follow_islands(bool are_followed);
  [[nodiscard]] bool follows_islands() const { return follows_islands_; }
  // Of the last detection; parts may have been destroyed since.
  [[nodiscard]] const IslandList& islands() const [[clang::lifetimebound]] { return islands_; }

  // What contacts of two materials are like, in either order: stored and handed out. Nothing takes a row away.
  [[nodiscard]] Result<void> set_material(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row);
  [[nodiscard]] ContactMaterial material(std::uint32_t a, std::uint32_t b) const { return materials_.of(a, b); }

  // Detects over [t, t + dt]; moves nothing. With a tolerance, an overlap has to exceed it, or a
  // separation to be below it, depending on the mode; without one, touching counts. Pairs of which nothing
  // has changed keep their contacts.
  [[nodiscard]] Result<void> step(Real dt);
  // The same without time. All: every pair anew. Changed: as a step does. Pairs and region: of what has changed only
  // the given pairs, or those that meet a box of the world; all others keep the contacts that they have, as old as they
  // are, and catch up whenever a detection covers them. Pairs that are given but not near each other are passed over.
  void detect_all();
  void detect_changed();
  [[nodiscard]] Result<void> detect_pairs(std::span<const std::pair<GeometryId, GeometryId>> pairs);
  [[nodiscard]] Result<void> detect_region(const Aabb& region);

  // Ordered by the slots of the two geometries, of which a has the lower one, then deepest first.
  [[nodiscard]] std::span<const Contact> contacts() const [[clang::lifetimebound]] { return contacts_; }
  // Of the contacts, in their order; empty where the options do not keep them.
  [[nodiscard]] std::span<const LocalPoints> local_points() const [[clang::lifetimebound]] { return locals_; }
  [[nodiscard]] bool keeps_local_points() const { return options_.keeps_local_points; }
  // One value per contact of the last step, in their order.
  [[nodiscard]] Result<void> set_contact_user_data(std::span<const std::uint64_t> user_data);
  // Of the last step: by the slots of the geometries; of one pair what ends comes before what begins, and the pair
  // before its contacts.
  [[nodiscard]] std::span<const Event> events() const [[clang::lifetimebound]] { return events_; }
  // Of the contacts, the events and the parts that fell asleep or woke in the last step: every bit of them counts, in
  // their order, but for generations.
  [[nodiscard]] std::uint64_t hash() const;
  [[nodiscard]] const StepStats& stats() const [[clang::lifetimebound]] { return stats_; }
  // `extensions`: libraries that stand on this universe, which only the caller knows.
  [[nodiscard]] std::string explain(std::span<const Plan::Extension> extensions = {}) const;
  [[nodiscard]] std::string explain_json(std::span<const Plan::Extension> extensions = {}) const;
  // What will surprise whoever built the scene, ordered by code, then by slots. O(geometries + kinds squared).
  [[nodiscard]] std::vector<Finding> validate() const;
  [[nodiscard]] bool is_stepping() const { return is_stepping_; }
  // Whether an exception, which is lack of memory, has ended a detection or a refresh half-way: its lists do not fit
  // each other then. All other calls leave things as they were.
  [[nodiscard]] bool is_torn() const { return is_torn_ && !is_stepping_; }

  // Brings boxes up to date with poses, as a step does first. Queries see boxes and poses as of the last step or
  // refresh.
  void refresh();
  // For queries: calls visit(place) for geometries that are not parked and whose boxes overlap, or
  // visit(place, entry) for those that a box meets while it moves by t * displacement, t up to `most`; the visitor
  // answers with the new limit of t. Safe from many threads at once.
  template <class Visitor>
  void visit(const Aabb& box, Visitor&& visit_place) const {
    std::visit([&](const auto& broadphase) { broadphase.visit(compact(box, options_.origin), visit_place); },
               broadphase_);
  }
  template <class Visitor>
  void sweep(const Aabb& box, const Vec3& displacement, Real most, Visitor&& visit_place) const {
    std::visit(
        [&](const auto& broadphase) {
          broadphase.sweep(box.centre() - options_.origin, 0.5 * (box.high - box.low), displacement, most, visit_place);
        },
        broadphase_);
  }
  [[nodiscard]] inline const AnyShape& shape_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return *shapes_[place];
  }
  [[nodiscard]] inline const ShapeHandle& handle_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return shapes_[place];
  }
  // A shape that no geometry has of its own.
  [[nodiscard]] inline const ShapeHandle& vacant_shape() const [[clang::lifetimebound]] { return vacant_; }
  [[nodiscard]] inline const Pose& world_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return worlds_[place];
  }
  // Of the part; jobs name geometries by the same places. A point p of the geometry moves by
  // linear + angular x (p - origin of the part).
  [[nodiscard]] inline Velocity velocity_at(std::uint32_t place) const { return velocities_.of(infos_[place].part); }
  // Of a geometry that is there.
  [[nodiscard]] inline GeometryId id_at(std::uint32_t place) const { return {place + 1, infos_[place].generation}; }
  [[nodiscard]] inline const PlaceInfo& info_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return infos_[place];
  }
  [[nodiscard]] bool contains(PartId part) const { return parts_.contains(part); }

 private:
  struct Part {
    Placement placement;
    std::uint64_t user_data;
    MotionKind motion;
    bool is_moved = false;
    bool is_marked = false;  // seen by the check of a batch
    std::vector<GeometryId> geometries;
  };
  struct Geometry {
    PartId part;
    Pose local_pose;
    GeometryOptions options;
    bool is_changed = false;  // in the list of changed ones
    bool is_marked = false;
  };
  // Whether a geometry is in the broad phase.
  enum class Presence : std::uint8_t { absent, hidden, shown };
  // What a detection covers of the pairs that have changed.
  enum class Coverage : std::uint8_t { changed, everything, pairs, region };
  struct Scope {
    Coverage coverage = Coverage::changed;
    std::span<const ProxyPair> pairs = {};  // in order
    CompactAabb region = {};
    Real dt = 0;
  };
  // What one task finds when changes are gathered, pairs are looked at, contacts counted and events written.
  struct ChangeTask {
    std::vector<std::uint32_t> queue, fresh;
  };
  struct PairTask {
    std::vector<Pair> lost;
    std::vector<std::uint32_t> without_memory;  // by their place among the pairs
  };
  struct ContactTask {
    std::array<KindTally, run_count> tallies{};
    std::uint64_t candidates = 0, filtered = 0, unsupported = 0, touching = 0;
    std::uint32_t contacts = 0, kept = 0, first_contact = 0;  // kept: of pairs that were not examined
  };
  struct EventTask {
    std::vector<Event> events;
    std::size_t first = 0;  // where they go
  };

  void forget_geometry(GeometryId geometry);
  void change(GeometryId geometry);
  void enlist(GeometryId geometry);
  void apply_edits(std::span<const GeometryId> geometries, std::span<const Edit> edits);
  void patch(GeometryId geometry, const Aabb& changed);
  [[nodiscard]] Real reach_at(std::uint32_t place) const;
  [[nodiscard]] bool has_changed_for(std::uint32_t place, std::uint32_t other) const;
  void renew_pair(Pair& pair, bool is_reshaped);
  void apply_options(GeometryId geometry);
  void settle_parking(GeometryId geometry, Parking parking);
  void leave_broadphase(std::uint32_t place);
  void choose_broadphase();
  void join_broadphase(std::uint32_t at);
  void gather_changes();
  void gather_moved(std::span<const PartId> parts, ChangeTask& task);
  void queue_changed();
  void place(std::uint32_t at, const Pose& part);
  void note(std::uint32_t place, Happened what) { happened_[place] |= what; }
  void update_broadphase();
  void detect(const Scope& scope);
  void run_stages(const Scope& scope);
  void set_self_pairs(std::uint32_t place, bool has_them);
  void add_self_pairs();
  void update_pairs(const Scope& scope);
  void update_pair(Pair& pair, const Scope& scope, std::vector<Pair>& lost);
  void follow_focus();
  void follow_focus(std::uint32_t at);
  [[nodiscard]] bool is_admitted(const Pair& pair) const;
  [[nodiscard]] bool passes_rules_and_filter(const Pair& pair) const;
  [[nodiscard]] bool is_covered(const Pair& pair, const Scope& scope) const;
  void find_contacts();
  void find_contacts_of_chunk(std::size_t chunk);
  void time_kinds();
  void finish_job(std::size_t job, std::uint32_t chunk, std::size_t first, std::size_t count);
  void collect_contacts();
  void count_contacts(std::size_t begin, std::size_t end, ContactTask& out);
  void write_contacts(std::size_t begin, std::size_t end, std::uint32_t first_contact);
  void write_contacts_of(const Pair& pair, std::span<const ContactPoint> found);
  void move_kept_contacts();
  void make_room_for_contacts(std::size_t count);
  void disturb(PartId part);
  void update_velocities(Real dt);
  void connect_islands();
  void number_islands();
  void update_sleep(Real dt);
  [[nodiscard]] bool is_asleep(const Pair& pair) const;
  [[nodiscard]] std::uint32_t event_flags_of(const Pair& pair) const;
  void collect_events();
  void write_events(std::span<const Pair> pairs, std::span<const Pair> lost, std::vector<Event>& out) const;
  void write_event(EventKind kind, const Pair& pair, std::vector<Event>& out) const;
  void write_contact_events(const Pair& pair, std::vector<Event>& out) const;
  void finish_detection();
  void count_everything();
  [[nodiscard]] Placement world_of(const Geometry& geometry) const;
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] Plan plan(std::span<const Plan::Extension> extensions) const;
  [[nodiscard]] std::vector<Plan::LeftOut> left_out(std::uint64_t never_met, bool has_extensions) const;
  [[nodiscard]] Plan::FocusCounts count_focus() const;

  UniverseOptions options_;
  SlotMap<Part, PartTag> parts_;
  SlotMap<Geometry, GeometryTag> geometries_;
  Revision revision_;
  std::size_t list_bytes_ = 0;  // of the lists of geometries of the parts
  std::size_t parked_count_ = 0;
  std::size_t moving_count_ = 0;  // of those in the broad phase
  std::uint64_t step_ = 0;

  // By slot of the geometry, less one: what the stages of a step read and write.
  ShapeHandle vacant_;  // stands where there is no geometry
  std::vector<ShapeHandle> shapes_;
  std::vector<Pose> worlds_;
  std::vector<CompactAabb> boxes_;
  std::vector<PlaceInfo> infos_;
  std::vector<std::uint8_t> happened_;  // bits of Happened
  std::vector<Presence> presence_;

  // What changed since the last detection.
  std::vector<PartId> moved_parts_;
  std::vector<GeometryId> changed_geometries_;
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> fresh_;      // places whose box was refreshed
  std::vector<std::uint32_t> queue_;      // places whose box is asked for
  std::vector<std::uint32_t> updates_;    // those of them that the broad phase knows
  std::vector<std::uint32_t> rejoining_;  // places that leave the broad phase and come back
  std::vector<ChangeTask> change_tasks_;
  bool is_broadphase_changed_ = false;
  bool are_slots_reused_ = false;  // perhaps, since the pairs were merged
  bool must_refilter_ = false;

  Workers workers_;
  AnyBroadPhase broadphase_;
  BroadphaseKind broadphase_kind_ = BroadphaseKind::brute;
  std::string_view broadphase_reason_ = "nothing to look at yet";
  std::vector<ProxyPair> near_;
  std::vector<std::uint32_t> self_places_;  // of geometries that meet themselves, in order
  PairStore pairs_;
  std::vector<PairTask> pair_tasks_;
  JobList jobs_;
  Rules rules_;
  Filter filter_;
  PolicyTable policies_;
  FocusCentres focus_;
  bool has_focus_ = false;
  bool is_focus_moved_ = false;          // since the last detection
  std::vector<std::uint32_t> switched_;  // places that the focus has given another tag
  MaterialTable materials_;
  SleepTable sleep_;
  VelocityTable velocities_;
  IslandLinks island_links_;
  IslandList islands_;
  bool follows_islands_ = false;
  std::vector<PartId> dynamic_parts_;                 // while islands are numbered
  mutable std::atomic<bool> are_pairs_timed_{false};  // since someone asked for the plan
  bool is_stepping_ = false;
  bool is_torn_ = false;  // while lists do not fit each other
  std::vector<std::pair<GeometryId, Parking>> deferred_parking_;

  std::vector<Contact> contacts_;
  std::vector<LocalPoints> locals_;  // of the contacts, where the universe keeps them; else empty
  std::vector<ContactHistory> histories_, histories_before_;  // of the contacts, and of those of the detection before
  std::vector<Event> events_;
  std::array<KindTally, run_count> tallies_{};
  std::vector<ContactTask> contact_tasks_;
  std::vector<EventTask> event_tasks_;
  StepStats stats_;
};

}  // namespace abut
