// SPDX-License-Identifier: Apache-2.0
// The records that a universe takes and gives.
export module abut.scene.state.options;
export import abut.broadphase.automatic;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

struct PartTag;
struct GeometryTag;
using PartId = Id<PartTag>;
using GeometryId = Id<GeometryTag>;

enum class ToleranceMode : std::uint32_t { dead_band, margin };
enum class MotionKind : std::uint32_t { dynamic, animated, fixed };

// Parked geometries take no part in anything. Short term: they keep their place in the broad phase, so that parking and
// coming back are quick. Long term: they leave it and cost a step nothing.
enum class Parking : std::uint32_t { none, short_term, long_term };

// Which events a step writes down.
enum EventBits : std::uint32_t {
  event_pairs = 1,     // pairs that begin and end to touch
  event_persist = 2,   // also those that still touch
  event_contacts = 4,  // the same of each contact
  event_elements = 8,  // and of each element contact
};

struct UniverseOptions {
  BroadphaseKind broadphase = BroadphaseKind::automatic;
  ToleranceMode tolerance_mode = ToleranceMode::dead_band;
  std::uint32_t max_contacts = 4;       // per patch; 0 keeps all
  std::uint32_t max_pair_contacts = 0;  // of all patches of a pair; 0 keeps all
  Vec3 origin{0, 0, 0};                 // of the compact boxes
  std::uint32_t threads = 1;            // 0: as many as the machine runs at once
  std::uint32_t events = event_pairs | event_persist;
  bool keeps_local_points = false;  // of contacts; a step that writes many of them takes longer for it
  bool welds = false;               // convex parts that lie side by side, as it does surfaces
};

// A position with the quaternion as it was given (normalised), so that poses read back as they were set.
struct Placement {
  Vec3 position{0, 0, 0};
  Quat orientation{1, 0, 0, 0};

  [[nodiscard]] inline Pose pose() const { return {Rotation::from(orientation), position}; }
};

struct PartOptions {
  MotionKind motion = MotionKind::dynamic;
  Placement placement;
  std::uint64_t user_data = 0;
};

inline constexpr std::uint32_t tag_count = 64;

// What a step with time looks at beside the present poses, for pairs that one geometry of asks for it. Impacts go
// before speculative contacts.
enum class Sweeping : std::uint8_t {
  none,
  impacts,      // the way within the step, and the contacts of the touches on it
  speculative,  // the start of the step, and contacts as far away as the motion may close
};

struct GeometryOptions {
  Placement local;     // in the frame of the part
  Real tolerance = 0;  // not negative; the tolerance of a pair is the sum
  std::uint64_t user_data = 0;
  bool is_sensor = false;  // its contacts are flagged
  Parking parking = Parking::none;
  std::uint64_t layers = 1;                // what it is
  std::uint64_t mask = ~std::uint64_t{0};  // the layers that it meets
  std::uint64_t exclusion = 0;             // geometries with a bit in common never meet
  std::uint32_t label = 0;                 // for rules
  std::uint32_t tag = 0;                   // for policies, below tag_count
  std::uint32_t material = 0;
  bool has_self_pairs = false;  // it meets itself
  Sweeping sweeping = Sweeping::none;
  bool keeps_side = false;  // its pairs remember from which side of a surface a body came
};

struct Revision {
  std::uint64_t geometries = 0;  // grows when one is created or destroyed, parked, or changes its shape
  std::uint64_t poses = 0;       // grows when one is set
};

// A part is calm in a step when it is faster than none of these, by its poses in the last steps. After so many calm
// steps it may fall asleep.
struct Sleep {
  std::uint32_t steps = 10;
  Real linear_speed = 0.14;  // of the origin of the part
  Real linear_acceleration = 0.045;
  Real angular_speed = 0.03;  // radians
  Real angular_acceleration = 0.045;

  friend constexpr bool operator==(const Sleep&, const Sleep&) = default;
};

// A part that fell asleep or woke.
struct SleepChange {
  PartId part;
  bool is_asleep;
};

enum ContactFlags : std::uint32_t { contact_of_sensor = 1, contact_speculative = 2 };

struct Contact {
  GeometryId geometry_a, geometry_b;
  ContactPoint point;  // in the world frame
  std::uint32_t flags = 0;
  std::uint32_t age = 0;        // steps in a row before this one that reported it
  std::uint64_t user_data = 0;  // stays while the contact does
  std::uint32_t material_a = 0, material_b = 0;
  Real toi = 0;  // part of the step before the touch
};

// A touch of two geometries on their paths through a step. Times are parts of the step.
struct StepImpact {
  GeometryId geometry_a, geometry_b;
  Real lower = 0, upper = 0;        // apart before `lower`, which is proven; touching at `upper`
  bool is_undecided = false;        // nothing is known after `lower`
  std::uint32_t first_contact = 0;  // in the list of the step
  std::uint32_t contact_count = 0;
};

// The points of a contact in the frames of its two geometries, as these lay when it was found.
struct LocalPoints {
  Vec3 a, b;
};

// What the next detection asks about a contact, apart from the rest of it: few bytes, since all of them are read again.
struct ContactHistory {
  std::uint64_t id;
  std::uint64_t user_data;
  std::uint32_t age;
};

enum class EventKind : std::uint32_t { begin, persist, end };
enum EventFlags : std::uint32_t {
  event_of_sensor = 1,
  event_of_contact = 2,
  event_asleep = 4,
  event_of_elements = 8,  // of an element contact
};

struct Event {
  EventKind kind;
  std::uint32_t flags;
  GeometryId geometry_a, geometry_b;  // of an end they may be destroyed
  std::uint64_t contact_id;           // of a contact; else 0
  std::uint32_t first_contact;        // the contacts of the pair, or the one, in the list of the step; of an end: none
  std::uint32_t contact_count;
};

// What a rule speaks of, most specific first.
enum class CollidableKind : std::uint32_t { geometry, part, label, any };
struct Collidable {
  CollidableKind kind = CollidableKind::any;
  std::uint32_t slot = 0;        // of the geometry or the part; or the label
  std::uint32_t generation = 0;  // of the geometry or the part
};
enum class Rule : std::uint32_t { none, enable, disable };
// The rule that counts for two geometries, and the two that it speaks of; none where no rule does.
struct RuleVerdict {
  Rule rule = Rule::none;
  Collidable a = {}, b = {};
};

// What keeps two geometries from being examined.
enum ApartReason : std::uint32_t {
  apart_by_part = 1,          // they are on one part, or are one that does not meet itself
  apart_by_motion = 2,        // neither part is dynamic
  apart_by_parking = 4,       // one of them is parked
  apart_by_exclusion = 8,     // they have a bit in common
  apart_by_layers = 16,       // the layers of one do not meet the mask of the other
  apart_by_rule = 32,         // the rule that counts disables them
  apart_by_filter = 64,       // the filter has said no
  apart_by_kinds = 128,       // no algorithm
  apart_by_boxes = 256,       // their boxes do not overlap
  apart_by_policy = 512,      // their boxes are all that a policy asks about
  apart_by_detection = 1024,  // the last one has not looked at them as they are
  apart_by_side = 2048        // only the back of a one-sided surface is there
};

// How much of a pair is found.
enum class Detail : std::uint32_t {
  manifold,  // everything
  point,     // the deepest contact
  box,       // whether the boxes overlap: events, no contacts
  touch,     // whether the shapes touch: events, no contacts
  elements,  // which vertices, edges and faces are near, where both shapes have triangles; else everything
};

// What Detail::elements tells: numbers of ClosestOptions, which not every build has.
struct ElementRule {
  std::uint32_t method = 0, kinds = 0;
  bool is_front_only = false;
  Real contact_distance = 0;  // where the gap is zero, and how near a first touch is
  Real rest_distance = 0;
  Real cone_angle = 0, cone_factor = 0.5;

  friend constexpr bool operator==(const ElementRule&, const ElementRule&) = default;
};

// How the pairs of two tags are treated.
struct Policy {
  Algorithm algorithm = Algorithm::automatic;
  Detail detail = Detail::manifold;
  std::uint32_t period = 1;  // found anew once in so many steps, and kept in between
  Real tolerance = -1;       // of the pair; negative: the sum of both
  Real error_bound = 0;      // as in QuerySettings
  Real time_budget = 0;      // seconds for the contacts of a pair, which choose among measured routes; 0: none
  ElementRule elements = {};

  friend constexpr bool operator==(const Policy&, const Policy&) = default;
};

// What is odd about a universe, by number.
enum class FindingCode : std::uint32_t {
  nothing_moves,        // no part is dynamic: no pair is ever examined
  meets_nothing,        // the layers or the mask of a geometry are empty
  kinds_unsupported,    // two geometries that could meet are of kinds without an algorithm
  tolerance_too_large,  // a tolerance above the smallest side of a shape
  far_from_origin,      // boxes of the broad phase are coarser than a hundredth of the shape
  excluded_from_all,    // no geometry of the universe is one that the layers and masks let it meet
  rule_disables_all,    // a rule disables any with any, and none enables anything
  exclusion_in_common,  // all geometries have an exclusion bit in common
  filter_keeps_none,    // the filter was asked, and has said no each time
  all_parked,           // every geometry is parked
  all_on_one_part,      // geometries of one part never meet each other
  inside_out,           // a solid mesh that is wound clockwise seen from outside
  hollow,               // a closed mesh with two sides lies around a geometry
};
struct Finding {
  FindingCode code;
  GeometryId geometry, other;  // null where none or no second one is meant
  std::string message;
};

struct StepStats {
  std::uint64_t parts = 0, geometries = 0, parked = 0, moved = 0;
  std::uint64_t candidate_pairs = 0, filtered_pairs = 0, examined_pairs = 0, kept_pairs = 0;
  std::uint64_t touching_pairs = 0, contacts = 0, unsupported_pairs = 0, events = 0;
  std::uint64_t bytes = 0;
  double refresh_microseconds = 0, broadphase_microseconds = 0, pair_microseconds = 0;
  double narrowphase_microseconds = 0, contact_microseconds = 0;
  std::uint64_t asleep = 0;
};

}  // namespace abut
