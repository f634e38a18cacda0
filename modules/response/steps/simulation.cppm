// SPDX-License-Identifier: Apache-2.0
// Rigid bodies of a world, and the step that moves them.
module;

#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

export module abut.response:simulation;
import :island;
import :link;
import :mass;
import :elastic;
import :grains;
import :problem;
import :rules;
import :source;
import :vector;

namespace abut::response {

struct Body {
  abut_part_id part;
  MassProperties mass;  // in the frame of the part
  abut_integrator integrator = ABUT_INTEGRATOR_IMPLICIT;
  abut_vec3 force{}, torque{};  // of the next step, about the centre of mass
};

// What a contact did, for the step after.
struct KeptContact {
  abut_geometry_id a, b;
  std::uint64_t id;
  abut_vec3 force;  // on b
  bool is_sticking;
  abut_vec3 creep;  // of b against a while it sticks
};

// A contact or a link while a step runs.
struct StepContact {
  abut_contact record{};
  std::uint32_t kind = 0;
  Response response = Response::friction;
  bool is_solved = true;   // by the solver; else it has the given impulse
  std::uint64_t link = 0;  // number, or 0
  abut_vec3 point{};       // between the two surfaces
  double compliance = 0, damping = 0;
  double epsilon = 0;      // of the kind augmented
  double restitution = 0;  // of its material
  double slow = 0;         // approaches that are slower do not bounce
  ContactRows rows{};
  Triple impulse{}, velocity{};  // along the rows; the velocity at the end of the step
  bool is_middle = false;        // a spring by the midpoint rule
  double given = 0;              // impulse along the normal beside that of the solver
  Triple opened{};               // the part of the drift of a link that closes its gap
  abut_vec3 creep{};             // of sticking points of the kind slide, before the step
  double gap = 0;                // at the end of the step, where nothing moves bodies apart
};

// A body while a step runs. World frame; velocities are those of the centre of mass.
struct Motion {
  double mass = 1;
  Matrix inertia{};  // about the centre of mass, world axes
  abut_quat orientation{};
  abut_vec3 centre{}, linear{}, angular{};
  abut_vec3 linear_before{}, angular_before{};  // at the start of the pass
  abut_vec3 bend{};                             // of a free path: what its mean velocity has beside that of the ends
  abut_vec3 shift{}, tilt{};                    // of the push apart: a move of the centre, and a small turn
  abut_integrator integrator = ABUT_INTEGRATOR_IMPLICIT;
  bool is_awake = false;
  bool is_pushed = false;  // by a contact that asks for the velocity at the end
};

// The inertia of a body as it lies now, about its centre of mass. Exactly symmetric.
[[nodiscard]] Matrix world_inertia(const Matrix& inertia, const abut_quat& orientation);
// The angular acceleration by a torque, or the angular velocity of a momentum.
[[nodiscard]] abut_vec3 accelerated(const Matrix& inertia, const abut_vec3& torque);

[[nodiscard]] inline abut_vec3 vector_of(const Row& row, std::size_t first) {
  return {row[first], row[first + 1], row[first + 2]};
}
[[nodiscard]] inline Row row_of(const abut_vec3& linear, const abut_vec3& angular) {
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}
// Whether a contact is told with an impulse on or inside the border of its cone.
[[nodiscard]] abut_contact_state state_of(const StepContact& contact);

// A spring and a damper by implicit Euler: an impulse f = -dt (k g1 + d u) with the gap g1 = g + dt u at the end of the
// step. Of rigid contacts, the offset of the gap.
struct Yield {
  double compliance, offset;
};
[[nodiscard]] Yield yield_of(const StepContact& contact, double dt);
// For islands: the bodies of each contact, of which those that do nothing join nobody.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> joined_by(const std::vector<StepContact>& contacts);

// Where a contact touches a geometry: a point, and the vertices or the particle that make it by weights with the sum 1.
struct Spot {
  static constexpr std::size_t most = 4;  // vertices of a stencil

  abut_vec3 point{};
  bool is_bent = false;   // whether particles move the mesh that it is of
  std::size_t count = 0;  // 0 where no particles hold it
  std::array<std::uint32_t, most> vertices{};
  std::array<double, most> weights{};
};

// A contact of the world, or a stencil of elements in the shape of one.
struct Meeting {
  abut_contact record{};
  abut_vec3 point{};  // at which both sides are pushed
  Spot a, b;
};

// By slot and generation of geometries.
using Skins = std::map<std::pair<std::uint32_t, std::uint32_t>, Skin>;

// A spring or a tetrahedron while a step runs: which one of which particles, and the motions of its nodes.
struct StepElement {
  std::uint32_t grains = 0, number = 0, count = 0;
  std::array<std::uint32_t, 4> nodes{};
};

// A step, or the part of it up to an impact.
struct Pass {
  std::vector<Motion> motions;
  std::vector<StepContact> contacts;
  std::vector<StepElement> elements{};
  std::vector<abut_response_island> islands;  // that were solved
  std::vector<std::uint32_t> island_of;       // of contacts
  std::vector<Link> bonds;                    // that contacts of the kind stick have made
};

}  // namespace abut::response

export namespace abut::response {

// As the C interface tells them.
[[nodiscard]] abut_residuals residuals_of(const SolverReport& report);

[[nodiscard]] std::uint64_t hash_of(std::span<const std::byte> bytes);

class Simulation {
 public:
  explicit Simulation(std::unique_ptr<Source> source) : source_(std::move(source)) {}

  // From the next step on.
  void set_options(const abut_response_options& options) { options_ = options; }
  // Room for as many bodies, so that adding them cannot fail.
  void reserve(std::size_t count) { bodies_.reserve(count); }
  // What a contact is like, from what its materials and rules say; whether it counts.
  using Editor = std::function<abut_status(const abut_contact&, abut_contact_material&, bool& counts)>;
  void set_editor(Editor editor) { edit_ = std::move(editor); }
  // Adds forces and torques; centres of mass in the place of positions.
  using Field = std::function<abut_status(abut_part_id, const abut_pose&, const abut_velocity&, double time,
                                          abut_vec3& force, abut_vec3& torque)>;
  void set_field(Field field) { field_ = std::move(field); }
  // A body that is there already gets the new mass.
  void add_body(abut_part_id part, const MassProperties& mass, abut_integrator integrator);
  // Whether the part was a body.
  [[nodiscard]] bool remove_body(abut_part_id part);
  [[nodiscard]] std::optional<MassProperties> mass_of(abut_part_id part) const;
  [[nodiscard]] std::size_t body_count() const { return bodies_.size(); }
  // For the next step; at a point of the world, or at the centre of mass. The part is a body.
  [[nodiscard]] abut_status push(abut_part_id part, const abut_vec3& force, const std::optional<abut_vec3>& at);
  void twist(abut_part_id part, const abut_vec3& torque);

  // In the place of those that the geometry has.
  [[nodiscard]] abut_status set_particles(Grains particles);
  // Whether the geometry had particles, or followed some.
  [[nodiscard]] bool remove_particles(abut_geometry_id geometry);
  // In the place of what the mesh has followed. Its carrier has particles, and as many as it needs.
  [[nodiscard]] abut_status set_surface(Surface surface);
  // Behind those that there are.
  void add_springs(abut_geometry_id geometry, std::span<const Spring> springs);
  void add_tetrahedra(abut_geometry_id geometry, std::span<const Tetrahedron> tetrahedra);
  [[nodiscard]] const Grains* particles_of(abut_geometry_id geometry) const;
  [[nodiscard]] bool stops_at_impacts() const { return (options_.flags & ABUT_RESPONSE_IMPACTS) != 0; }
  [[nodiscard]] bool has_particles() const { return !grains_.empty(); }

  [[nodiscard]] Rules& rules() { return rules_; }
  [[nodiscard]] const Rules& rules() const { return rules_; }
  // The rule that counts, in words.
  [[nodiscard]] abut_status explain_pair(abut_geometry_id a, abut_geometry_id b, std::string& out) const;

  // The number of a new link, whose own counts for nothing.
  [[nodiscard]] std::uint64_t add_link(Link link);
  [[nodiscard]] Link* find_link(std::uint64_t number);
  [[nodiscard]] const Link* find_link(std::uint64_t number) const;
  void remove_link(std::uint64_t number);
  // Whether the two had bonds.
  [[nodiscard]] bool release(abut_geometry_id a, abut_geometry_id b);

  // Moves the bodies, or none of them where it fails. `dt` is above 0.
  [[nodiscard]] abut_status step(double dt);

  // Of the last step.
  [[nodiscard]] const std::vector<abut_response_contact>& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<abut_response_island>& islands() const { return islands_; }
  [[nodiscard]] const std::vector<abut_response_object>& objects() const { return objects_; }
  // Of all bodies as they are now.
  [[nodiscard]] abut_status energy(abut_energy& out) const;

  // What is odd, by code.
  [[nodiscard]] abut_status validate(std::vector<abut_response_finding>& out) const;
  [[nodiscard]] std::string explain() const;
  [[nodiscard]] std::string explain_json() const;
  [[nodiscard]] std::vector<std::byte> save() const;
  // Whether the bytes are those of a response; else nothing has changed but this one, which is of no use then.
  [[nodiscard]] bool load(std::span<const std::byte> bytes);
  [[nodiscard]] const abut_response_options& options() const { return options_; }
  [[nodiscard]] std::vector<abut_part_id> parts() const;

 private:
  [[nodiscard]] abut_status find_in_bodies(std::vector<abut_response_finding>& out) const;
  void find_in_rules(std::vector<abut_response_finding>& out) const;
  // The one list of what bytes hold, for writing and for reading.
  template <class Archive, class Self>
  static void exchange(Archive& archive, Self& its);
  using Pair = std::pair<abut_geometry_id, abut_geometry_id>;

  [[nodiscard]] Body* find(abut_part_id part);
  [[nodiscard]] const Body* find(abut_part_id part) const;
  [[nodiscard]] abut_status read(const Body& body, Motion& out) const;

  // Contacts and links now, and how bodies move.
  [[nodiscard]] abut_status look(double dt, Pass& pass);
  [[nodiscard]] abut_status collect(double dt, Pass& pass);
  // What moves the points of both sides of a contact or a link, and how b moves against a where no body does.
  struct Sides {
    std::vector<Holder> holders;
    abut_vec3 velocity{};
    bool has_particles = false;
  };
  // `sign` is -1 for a and 1 for b.
  [[nodiscard]] abut_status hold_part(abut_part_id part, const abut_vec3& point, double sign, const Pass& pass,
                                      Sides& out) const;
  [[nodiscard]] abut_status hold_side(const GeometryFacts& facts, const Spot& spot, double sign, const Pass& pass,
                                      Sides& out) const;
  void hold_vertex(abut_geometry_id geometry, std::uint32_t vertex, double weight, std::vector<Holder>& holders) const;
  [[nodiscard]] bool follows_particles(abut_geometry_id geometry) const;
  [[nodiscard]] const Surface* surface_of(abut_geometry_id geometry) const;
  [[nodiscard]] std::vector<double> places_of(const Surface& surface) const;
  bool remove_surface(abut_geometry_id geometry);
  void remove_surfaces_on(abut_geometry_id carrier);
  [[nodiscard]] abut_status find_meetings(std::vector<Meeting>& out) const;
  [[nodiscard]] abut_status add_meeting(const abut_element_contact& element, Skins& skins,
                                        std::vector<Meeting>& out) const;
  [[nodiscard]] abut_status find_spot(abut_geometry_id geometry, const abut_feature& feature, std::uint32_t child,
                                      const abut_vec3& point, Skins& skins, Spot& out) const;
  [[nodiscard]] abut_status skin_of(abut_geometry_id geometry, Skins& skins, const Skin*& out) const;
  void read_particles(Pass& pass) const;
  void read_elements(std::size_t first, std::uint32_t grains, Pass& pass) const;
  [[nodiscard]] ElasticForce force_of_element(const StepElement& element, const std::array<abut_vec3, 4>& places) const;
  [[nodiscard]] std::array<double, 144> viscosity_of_element(const StepElement& element, const ElasticForce& force,
                                                             const std::array<abut_vec3, 4>& places) const;
  // Elements of an island, as they are where its bodies will be. `ends` has a place for each of its bodies.
  void linearise(const Island& island, std::span<const std::uint32_t> elements, const std::vector<abut_vec3>& ends,
                 double dt, const Pass& pass, Problem& problem) const;
  [[nodiscard]] SolverReport solve_with_elements(const Island& island, std::span<const std::uint32_t> elements,
                                                 double dt, const Pass& pass, const SolverOptions& options,
                                                 Problem& problem, Solution& solution) const;
  [[nodiscard]] abut_status write_particles(double dt, const Pass& pass);
  [[nodiscard]] abut_status read_terms(const abut_contact& record, const GeometryFacts& a, const GeometryFacts& b,
                                       StepContact& contact, Terms& terms, bool& counts) const;
  [[nodiscard]] abut_status take_law(double dt, const Pass& pass, ContactPlace place, StepContact& contact,
                                     bool& counts) const;
  [[nodiscard]] abut_status bond(const abut_contact& record, const GeometryFacts& a, const GeometryFacts& b,
                                 const Terms& terms, std::uint32_t kind, Pass& pass) const;
  [[nodiscard]] abut_status collect_link(const Link& link, double dt, Pass& pass) const;
  [[nodiscard]] abut_status place_of(const Anchor& anchor, abut_vec3& out) const;
  [[nodiscard]] const KeptContact* find_kept(const abut_contact& record) const;
  [[nodiscard]] bool has_bond(const Pair& pair) const;

  // Integrators of groups, what springs do, and velocities without contacts.
  [[nodiscard]] abut_status add_forces(double dt, Pass& pass) const;
  void choose_integrators(Pass& pass) const;
  [[nodiscard]] abut_status accelerate(const Body& body, double dt, Motion& its) const;
  struct Push {
    abut_vec3 linear, angular;  // accelerations
  };
  [[nodiscard]] abut_status push_at(const Body& body, const Motion& its, double time, Push& out) const;

  // Whether all velocities are finite. Gaps are those after a time `ahead`.
  [[nodiscard]] bool solve_islands(double ahead, Pass& pass) const;
  [[nodiscard]] bool solve_island(const Island& island, std::span<const std::uint32_t> elements, double ahead,
                                  Pass& pass, abut_response_island& told) const;
  [[nodiscard]] bool move_apart(const Island& island, const std::vector<std::uint32_t>& solved_contacts,
                                const Problem& solved, Pass& pass) const;
  [[nodiscard]] abut_status write(double dt, const Pass& pass);

  // What is told of contacts and islands; impulses add up in a step. `part` of the time of the pass has passed.
  void tell(const Pass& pass, double part);
  // What the next step begins with.
  void keep(double dt, const Pass& pass);
  void keep_links(double dt, const Pass& pass);
  void finish(double dt);
  void tell_objects(double dt);

  [[nodiscard]] abut_status step_at_once(double dt);
  // From impact to impact.
  [[nodiscard]] abut_status step_by_impacts(double dt);
  [[nodiscard]] abut_status follow(double& rest);
  [[nodiscard]] abut_status end_at_once(double rest);
  [[nodiscard]] bool bounce(Pass& pass);
  [[nodiscard]] abut_status advance(double time, double rest, const Pass& pass, double& passed, bool& is_impact);

  std::unique_ptr<Source> source_;
  abut_response_options options_{};
  Editor edit_;
  Field field_;
  Rules rules_;
  double time_ = 0;
  std::vector<Body> bodies_;  // in the order of their parts
  std::vector<Grains> grains_;
  std::vector<Surface> surfaces_;  // on these
  std::vector<KeptContact> kept_;  // in their order
  std::vector<Link> links_;        // in the order of their numbers
  std::uint64_t next_link_ = 1;
  std::vector<Pair> released_;  // that do not bond again before they have been apart
  std::vector<Pair> resting_;   // in contact, with no awake body
  std::vector<abut_response_contact> contacts_;
  std::vector<abut_response_island> islands_;
  std::vector<abut_response_object> objects_;
};

}  // namespace abut::response
