// SPDX-License-Identifier: Apache-2.0
// A space in which parts meet: a scene, and detections of what touches what in it.
export module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.archive;
import abut.core.memory.spare_blocks;
import abut.core.standard;
import abut.core.workers;
import abut.core;
export import abut.detect.backend;
import abut.detect.lists.contacts;
import abut.detect.continuous;
export import abut.detect.elements;
import abut.detect.lists.events;
export import abut.detect.lists.islands;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.detect.lists.seams;
import abut.detect.pairs.sides;
import abut.detect.pairs.selection;
import abut.detect.paths;
import abut.math;
export import abut.report.plan;
export import abut.scene;

export namespace abut {

class Universe : public Scene {
 public:
  Universe(const UniverseOptions& options, std::uint32_t number);

  // From the next detection on, or no longer: each one finds the islands, at a cost of O(pairs + parts).
  void follow_islands(bool are_followed);
  [[nodiscard]] bool follows_islands() const { return follows_islands_; }
  // Of the last detection; parts may have been destroyed since.
  [[nodiscard]] const IslandList& islands() const [[clang::lifetimebound]] { return islands_; }

  // A detector of the caller, which answers pairs in place of the narrow phase from the next detection on, where all
  // pairs are examined. An empty `find` is none.
  void set_backend(Backend backend);
  [[nodiscard]] bool is_asking_backend() const { return backend_.is_asking(); }
  // While it is asked: about these.
  [[nodiscard]] std::span<const BackendPair> backend_pairs() const [[clang::lifetimebound]] { return backend_.pairs(); }
  // Answers a pair that the back end is asked about now.
  [[nodiscard]] Fault answer_pair(std::size_t pair, std::span<const ContactPoint> contacts) {
    return backend_.answer(pair, contacts);
  }

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
  [[nodiscard]] std::span<const Contact> contacts() const [[clang::lifetimebound]] { return contacts_.all(); }
  // Of the contacts, in their order; empty where the options do not keep them.
  [[nodiscard]] std::span<const LocalPoints> local_points() const [[clang::lifetimebound]] {
    return contacts_.locals();
  }
  // Of the pairs whose policy asks for elements.
  [[nodiscard]] const ElementStage& elements() const [[clang::lifetimebound]] { return elements_; }
  [[nodiscard]] ToleranceMode tolerance_mode() const { return options_.tolerance_mode; }
  [[nodiscard]] bool keeps_local_points() const { return options_.keeps_local_points; }
  // Why two geometries are not examined, as bits of ApartReason; 0 where they are, so that the distance of their shapes
  // decides. Options, rules and parking are the present ones, boxes those of the last refresh, and answers of the
  // filter those of the last detection. O(log pairs).
  [[nodiscard]] Result<std::uint32_t> why_apart(GeometryId a, GeometryId b) const;
  // One value per contact of the last step, in their order.
  [[nodiscard]] Result<void> set_contact_user_data(std::span<const std::uint64_t> user_data) {
    return contacts_.set_user_data(user_data);
  }
  // Of the last step: by the slots of the geometries; of one pair what ends comes before what begins, and the pair
  // before its contacts.
  [[nodiscard]] std::span<const Event> events() const [[clang::lifetimebound]] { return events_.all(); }
  // Of the last step, in order of time: two geometries, of which one at least asked for impacts, that touch on their
  // path and did not at its start.
  [[nodiscard]] std::span<const StepImpact> impacts() const [[clang::lifetimebound]] { return impacts_.all(); }
  // Moves all parts that have a velocity as far on their path through dt as nothing touches of what asks for impacts.
  // Those that touch at the start, sensors and pairs that are seen as boxes hold nothing up. Answers with the impact
  // that comes first, or with none and the whole way.
  // Vertices of fast geometries that are lent move as far on their way, and are lent no longer.
  [[nodiscard]] Result<StepImpact> advance_to_first_impact(Real dt);
  // Those whose vertices that moves.
  [[nodiscard]] std::vector<GeometryId> geometries_that_lead() const;
  // Of the contacts, the events and the parts that fell asleep or woke in the last step: every bit of them counts, in
  // their order, but for generations.
  [[nodiscard]] std::uint64_t hash() const;
  [[nodiscard]] const StepStats& stats() const [[clang::lifetimebound]] { return stats_; }
  // `extensions`: libraries that stand on this universe, which only the caller knows.
  [[nodiscard]] std::string explain(std::span<const Plan::Extension> extensions = {}) const;
  [[nodiscard]] std::string explain_json(std::span<const Plan::Extension> extensions = {}) const;
  // Whether an exception, which is lack of memory, has ended a detection or a refresh half-way: its lists do not fit
  // each other then. All other calls leave things as they were.
  [[nodiscard]] bool is_torn() const { return is_torn_ && !is_stepping(); }

  // Everything but the filter as bytes, between detections. A universe that is made of them has the same ids, and its
  // next steps give the same bits.
  [[nodiscard]] std::vector<std::uint8_t> save() const;
  // Whether bytes are those of a universe, and with what options it was made.
  [[nodiscard]] static Result<UniverseOptions> saved_options(std::span<const std::uint8_t> bytes);
  // Into a universe that is new and has the options that the bytes tell. After an error it is good for nothing.
  [[nodiscard]] Result<void> load(std::span<const std::uint8_t> bytes);

  // Brings boxes up to date with poses, as a step does first. Queries see boxes and poses as of the last step or
  // refresh.
  void refresh();

 private:
  void load_pairs(ByteReader& in);
  void load_contacts(ByteReader& in, std::uint64_t count);
  void detect(Scope scope);
  void run_stages(const Scope& scope);
  [[nodiscard]] Fault check_time(Real dt) const;
  [[nodiscard]] Fault check_lent_vertices() const;
  void refresh_places();
  void find_paths(Real dt);
  void sweep(Real dt);
  void follow_elements(Real dt);
  [[nodiscard]] Paths paths(Real dt) const { return {geometries_, velocities_, places_, dt}; }
  [[nodiscard]] StepImpact first_impact(Real dt);
  void hold_at_elements(Real dt, StepImpact& first);
  void move_vertices(Real share);
  void move_along(Real dt, Real time);
  [[nodiscard]] BoxFrame box_frame() const;
  void update_space();
  void find_pairs();
  void follow_focus();
  void update_islands(Real dt);
  void finish_detection();
  void count_everything(const ContactCounts& counts);
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] Plan plan(std::span<const Plan::Extension> extensions) const;
  [[nodiscard]] std::uint32_t why_apart_at(std::uint32_t low, std::uint32_t high) const;
  [[nodiscard]] bool is_behind(std::uint32_t low, std::uint32_t high) const;
  [[nodiscard]] const Pair* find_pair(std::uint32_t low, std::uint32_t high) const;
  [[nodiscard]] bool has_filter_refused(const Pair& pair) const;
  [[nodiscard]] bool is_parked(std::uint32_t place) const;
  [[nodiscard]] bool has_changed(std::uint32_t place) const;
  [[nodiscard]] std::vector<Plan::LeftOut> left_out(std::uint64_t never_met, bool has_extensions) const;
  [[nodiscard]] Plan::FocusCounts count_focus() const;

  Workers workers_;
  SpareBlocks spare_;
  std::uint64_t step_ = 0;
  Refresh refresh_;
  std::vector<ProxyPair> near_;
  PairStore pairs_;
  Selection selection_;
  JobList jobs_;
  SideStage sides_;
  BackendStage backend_;
  SeamStage seams_;
  ElementStage elements_;
  Sweeps sweeps_;
  bool had_paths_ = false;  // the last detection looked at paths
  ImpactStage impacts_;
  ContactList contacts_;
  EventList events_;
  IslandLinks island_links_;
  IslandList islands_;
  bool follows_islands_ = false;
  std::vector<PartId> dynamic_parts_;                 // while islands are numbered
  mutable std::atomic<bool> are_pairs_timed_{false};  // since someone asked for the plan
  bool is_torn_ = false;                              // while lists do not fit each other
  StepStats stats_;
};

}  // namespace abut
