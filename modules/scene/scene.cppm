// SPDX-License-Identifier: Apache-2.0
// Parts with geometries, where they are, and what the caller says about them: data and edits, no detection.
export module abut.scene;
import abut.capability;
import abut.core.archive;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.state.changes;
export import abut.scene.rest.focus;
import abut.scene.rest.focus_tags;
import abut.scene.journal;
export import abut.scene.meetings.materials;
import abut.scene.meetings;
import abut.scene.state.lent_vertices;
export import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
export import abut.scene.rest.sleep;
import abut.scene.state.space;
export import abut.scene.rest.velocity;

export namespace abut {

struct GeometryInfo {
  PartId part;
  ShapeHandle shape;
  Placement world;
  GeometryOptions options;
};

class Scene {
 public:
  // `number` tells scenes of one process apart: their ids start at different generations.
  Scene(const UniverseOptions& options, std::uint32_t number);

  // Parts. Failures change nothing; batches take effect as a whole or not at all.
  [[nodiscard]] Result<std::vector<PartId>> create_parts(std::span<const PartOptions> options);
  [[nodiscard]] Result<void> destroy_parts(std::span<const PartId> parts);
  [[nodiscard]] Result<void> set_poses(std::span<const PartId> parts, std::span<const Placement> poses);
  [[nodiscard]] Result<void> set_motions(std::span<const PartId> parts, std::span<const MotionKind> motions);
  [[nodiscard]] Result<Placement> pose(PartId part) const;
  [[nodiscard]] Result<MotionKind> motion(PartId part) const;
  [[nodiscard]] Result<std::uint64_t> user_data(PartId part) const;
  // Values of the caller, which nothing looks at.
  [[nodiscard]] Result<void> set_user_data(std::span<const PartId> parts, std::span<const std::uint64_t> user_data);
  [[nodiscard]] Result<void> set_user_data(std::span<const GeometryId> geometries,
                                           std::span<const std::uint64_t> user_data);
  [[nodiscard]] Result<std::vector<GeometryId>> geometries_of(PartId part) const;

  // How fast parts move, which only geometries with a sweeping ask; sleep goes by poses. None takes a velocity away.
  [[nodiscard]] Result<void> set_velocities(std::span<const PartId> parts,
                                            std::span<const std::optional<Velocity>> velocities);
  // From now on by the poses: a step with time finds what leads from those of the step with time before to the
  // present ones.
  [[nodiscard]] Result<void> measure_velocities(std::span<const PartId> parts);
  // Zero for a part that has none.
  [[nodiscard]] Result<Velocity> velocity(PartId part) const;
  [[nodiscard]] Result<VelocitySource> velocity_source(PartId part) const;
  // How the velocities of parts change within a step, by the second, but for those that are measured. Zero for none.
  [[nodiscard]] Result<void> set_accelerations(std::span<const PartId> parts,
                                               std::span<const Acceleration> accelerations);
  [[nodiscard]] Result<Acceleration> acceleration(PartId part) const;

  // Geometries. No options means the default ones for each.
  [[nodiscard]] Result<std::vector<GeometryId>> create_geometries(std::span<const PartId> parts,
                                                                  std::span<const ShapeHandle> shapes,
                                                                  std::span<const GeometryOptions> options);
  [[nodiscard]] Result<void> destroy_geometries(std::span<const GeometryId> geometries);
  // Changes a shape: for this geometry alone, and in place where nobody else holds it, else by a copy. Contacts live on
  // where their features do.
  [[nodiscard]] Result<void> edit_shape(GeometryId geometry, const Edit& edit);
  [[nodiscard]] Result<void> edit_shapes(std::span<const GeometryId> geometries, std::span<const Edit> edits);
  // Lends memory for the vertices to which those of a mesh move next, in the frame of the shape. It is there until an
  // advance exchanges it with the vertices, or until the geometry goes or gets another shape. After an advance it holds
  // the vertices that were. Of all geometries the numbers have to be right, or nothing changes. An advance does what an
  // edit of all vertices does, without a copy.
  [[nodiscard]] Result<std::span<Vec3>> lend_next_vertices(GeometryId geometry) [[clang::lifetimebound]];
  [[nodiscard]] Result<void> advance_vertices(GeometryId geometry);
  [[nodiscard]] Result<void> advance_vertices(std::span<const GeometryId> geometries);
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
  // The geometries that have changed since a revision, or have moved, ordered by slot; one that has gone has the
  // generation 0. None where more has changed than is remembered.
  [[nodiscard]] std::optional<std::vector<GeometryId>> changed_since(const Revision& since) const;

  // Who meets whom. A geometry with self pairs meets itself, however its part moves, unless a rule or the filter keeps
  // it. Two never meet that are of one part, of which neither is dynamic, or one is parked. Nor do two that have
  // exclusion bits in common. After that layers and masks are asked, both ways, then rules, then the filter.
  // Answers are kept per pair until something that they depend on changes.
  [[nodiscard]] Result<void> set_rule(const Collidable& a, const Collidable& b, Rule rule);
  void clear_rules();
  // In the order of the two.
  [[nodiscard]] Result<RuleVerdict> rule_between(GeometryId a, GeometryId b) const;
  // Asked last, once for each pair that comes near, in order. It may ask the universe but not change it.
  using Filter = Meetings::Filter;
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
  // is the default. A sleeping part wakes with the next detection, and with it all that it touches:
  // - when it or its geometries are changed,
  // - when something else touches it or leaves it,
  // - when what it touches moves.
  // Detections cover sleeping parts like any others.
  [[nodiscard]] Result<void> set_sleep(std::span<const PartId> parts, std::span<const std::optional<Sleep>> thresholds);
  [[nodiscard]] Result<void> wake(std::span<const PartId> parts);
  [[nodiscard]] Result<bool> is_asleep(PartId part) const;
  // Of the last detection, by slot; parts may have been destroyed since.
  [[nodiscard]] std::span<const SleepChange> sleep_changes() const [[clang::lifetimebound]] { return sleep_.changes(); }

  // What contacts of two materials are like, in either order: stored and handed out. Nothing takes a row away.
  [[nodiscard]] Result<void> set_material(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row);
  [[nodiscard]] ContactMaterial material(std::uint32_t a, std::uint32_t b) const { return materials_.of(a, b); }

  // What will surprise whoever built the scene, ordered by code, then by slots. O(geometries + kinds squared).
  [[nodiscard]] std::vector<Finding> validate() const;

  // Whether a detection runs: it reads what edits would write.
  [[nodiscard]] bool is_stepping() const { return is_stepping_; }

  // For queries, which see boxes and poses as of the last refresh. Parked geometries are left out. Safe from many
  // threads at once. The first calls visit(place) for boxes that overlap. The second calls visit(place, entry) for
  // those that a box meets while it moves by t * displacement, t up to `most`; the visitor answers with the new limit
  // of t.
  template <class Visitor>
  void visit(const Aabb& box, Visitor&& visit_place) const {
    space_.visit(compact(box, options_.origin), visit_place);
  }
  template <class Visitor>
  void sweep(const Aabb& box, const Vec3& displacement, Real most, Visitor&& visit_place) const {
    space_.sweep(box.centre() - options_.origin, 0.5 * (box.high - box.low), displacement, most, visit_place);
  }
  [[nodiscard]] inline const AnyShape& shape_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return *places_.shapes[place];
  }
  [[nodiscard]] inline const ShapeHandle& handle_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return places_.shapes[place];
  }
  // The handle that was there before an edit that has failed, so that a shape that was shared is so again.
  void put_back(std::uint32_t place, const ShapeHandle& shape) { places_.shapes[place] = shape; }
  // A shape that no geometry has of its own.
  [[nodiscard]] inline const ShapeHandle& vacant_shape() const [[clang::lifetimebound]] { return places_.vacant; }
  [[nodiscard]] inline const Pose& world_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return places_.worlds[place];
  }
  [[nodiscard]] inline const PlaceInfo& info_at(std::uint32_t place) const [[clang::lifetimebound]] {
    return places_.infos[place];
  }
  // Of a geometry that is there.
  [[nodiscard]] inline GeometryId id_at(std::uint32_t place) const { return places_.id_at(place); }
  // Of the part; jobs name geometries by the same places. A point p of the geometry moves by
  // linear + angular x (p - origin of the part).
  [[nodiscard]] inline Velocity velocity_at(std::uint32_t place) const {
    return velocities_.of(places_.infos[place].part.slot);
  }

  struct Part {
    Placement placement;
    std::uint64_t user_data;
    MotionKind motion;
    bool is_moved = false;   // in the list of moved ones, until a refresh
    bool is_marked = false;  // only while a batch is checked
    std::vector<GeometryId> geometries;

    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& self) {
      archive(self.placement, self.user_data, self.motion, self.geometries);
    }
  };
  struct Geometry {
    PartId part;
    Pose local_pose;
    GeometryOptions options;
    bool is_changed = false;  // in the list of changed ones, until a refresh
    bool is_marked = false;   // only while a batch is checked

    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& self) {
      archive(self.part, self.options);
    }
  };
  using Parts = SlotMap<Part, PartTag>;
  using Geometries = SlotMap<Geometry, GeometryTag>;

 protected:
  // Those who detect are one with the scene: edits that come from a filter wait until they are done.
  void begin_detection() { is_stepping_ = true; }
  void end_detection();
  void apply_deferred_parking();
  // Of checked geometries that have lent vertices.
  void exchange_all(std::span<const GeometryId> geometries);

  [[nodiscard]] std::size_t bytes() const;

  // Everything but the filter, between detections. What is wrong with bytes is the reader's to tell; a scene that was
  // to be made of them is good for nothing then. It has to be new.
  void save(ByteWriter& out) const;
  void load(ByteReader& in, const Workers& workers);

  UniverseOptions options_;
  Parts parts_;
  Geometries geometries_;
  Places places_;
  Space space_;
  SceneChanges changes_;
  Meetings meetings_;
  FocusTags focus_;
  MaterialTable materials_;
  SleepTable sleep_;
  VelocityTable velocities_;
  std::vector<std::uint32_t> self_places_;   // of geometries that meet themselves, in order
  std::vector<std::uint32_t> swept_places_;  // of geometries whose way through a step is looked at, in order
  std::size_t parked_count_ = 0;
  std::size_t side_keeper_count_ = 0;  // geometries whose pairs remember sides
  LentVertices lent_;

 private:
  void check_parts(ByteReader& in) const;
  void restore_changes(std::span<std::uint8_t> presences);
  void find_what_hides_all(std::vector<Finding>& findings) const;
  void find_odd_meshes(std::vector<Finding>& findings) const;
  void count_change(std::span<const GeometryId> geometries, const Revision& by);
  void count_moves(std::span<const PartId> parts);
  void forget_geometry(GeometryId geometry);
  void change(GeometryId geometry);
  void enlist(GeometryId geometry);
  void apply_edits(std::span<const GeometryId> geometries, std::span<const Edit> edits);
  [[nodiscard]] Fault check_advance(GeometryId geometry) const;
  void make_room_for_edits(std::size_t count);
  void follow_edit(GeometryId geometry, const Aabb& changed, const Aabb& place_before);
  void patch(GeometryId geometry, const Aabb& changed);
  void apply_options(GeometryId geometry);
  void settle_parking(GeometryId geometry, Parking parking);
  void set_self_pairs(std::uint32_t place, bool has_them);
  void set_sweeping(std::uint32_t place, Sweeping sweeping);
  void set_keeps_side(std::uint32_t place, bool keeps_it);
  void disturb(PartId part);
  void disturb_by_edit(GeometryId geometry, const Aabb& changed);
  [[nodiscard]] Placement world_of(const Geometry& geometry) const;

  Revision revision_;
  Journal journal_;
  std::size_t list_bytes_ = 0;  // of the lists of geometries of the parts
  bool is_stepping_ = false;
  std::vector<std::pair<GeometryId, Parking>> deferred_parking_;
};

// How far a box goes beyond its shape: the two boxes of a pair reach as far together as its policy does.
[[nodiscard]] inline Real reach_of(const PlaceInfo& info, ToleranceMode mode, Real largest_of_policies) {
  return mode == ToleranceMode::margin ? std::max(info.tolerance, 0.5 * largest_of_policies) : 0;
}

}  // namespace abut
