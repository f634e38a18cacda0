// SPDX-License-Identifier: Apache-2.0
// Rigid bodies of a world, and the step that moves them.
module;

#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

export module abut.response:simulation;
import :island;
import :mass;
import :problem;
import :source;
import :vector;

namespace abut::response {

struct Body {
  abut_part_id part;
  MassProperties mass;          // in the frame of the part
  abut_vec3 force{}, torque{};  // of the next step, about the centre of mass
};

// What a contact did, for the step after.
struct KeptContact {
  abut_geometry_id a, b;
  std::uint64_t id;
  abut_vec3 force;  // on b
  bool is_sticking;
};

// A contact while a step runs.
struct StepContact {
  abut_contact record{};
  std::uint32_t a = no_body, b = no_body;
  abut_vec3 point{};       // between the two surfaces
  double restitution = 0;  // of its material
  double slow = 0;         // approaches that are slower do not bounce
  ContactRows rows{};
  Triple impulse{}, velocity{};  // along the rows; the velocity at the end of the step
  double gap = 0;                // at the end of the step, where nothing moves bodies apart
};

// A body while a step runs. World frame; velocities are those of the centre of mass.
struct Motion {
  abut_quat orientation{};
  abut_vec3 centre{}, linear{}, angular{};
  abut_vec3 linear_before{}, angular_before{};  // at the start of the pass
  abut_vec3 shift{}, tilt{};                    // of the push apart: a move of the centre, and a small turn
  Matrix inertia{};                             // about the centre of mass, world axes
  bool is_awake = false;
  bool is_pushed = false;  // by a contact
};

// The inertia of a body as it lies now, about its centre of mass. Exactly symmetric.
[[nodiscard]] Matrix world_inertia(const Matrix& inertia, const abut_quat& orientation);
// The angular acceleration by a torque, or the angular velocity of a momentum.
[[nodiscard]] abut_vec3 accelerated(const Matrix& inertia, const abut_vec3& torque);

// A step, or the part of it up to an impact.
struct Pass {
  std::vector<Motion> motions;
  std::vector<StepContact> contacts;
  std::vector<abut_response_island> islands;  // that were solved
  std::vector<std::uint32_t> island_of;       // of contacts
};

}  // namespace abut::response

export namespace abut::response {

class Simulation {
 public:
  explicit Simulation(std::unique_ptr<Source> source) : source_(std::move(source)) {}

  // From the next step on.
  void set_options(const abut_response_options& options) { options_ = options; }
  // Room for as many bodies, so that adding them cannot fail.
  void reserve(std::size_t count) { bodies_.reserve(count); }
  // What a contact is like, from what its materials say; whether it counts.
  using Editor = std::function<abut_status(const abut_contact&, abut_contact_material&, bool& counts)>;
  void set_editor(Editor editor) { edit_ = std::move(editor); }
  // A body that is there already gets the new mass.
  void add_body(abut_part_id part, const MassProperties& mass);
  // Whether the part was a body.
  [[nodiscard]] bool remove_body(abut_part_id part);
  [[nodiscard]] std::optional<MassProperties> mass_of(abut_part_id part) const;
  [[nodiscard]] std::size_t body_count() const { return bodies_.size(); }
  // For the next step; at a point of the world, or at the centre of mass. The part is a body.
  [[nodiscard]] abut_status push(abut_part_id part, const abut_vec3& force, const std::optional<abut_vec3>& at);
  void twist(abut_part_id part, const abut_vec3& torque);

  // Moves the bodies, or none of them where it fails. `dt` is above 0.
  [[nodiscard]] abut_status step(double dt);

  // Of the last step.
  [[nodiscard]] const std::vector<abut_response_contact>& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<abut_response_island>& islands() const { return islands_; }
  // Of all bodies as they are now.
  [[nodiscard]] abut_status energy(abut_energy& out) const;

 private:
  [[nodiscard]] Body* find(abut_part_id part);
  [[nodiscard]] const Body* find(abut_part_id part) const;
  [[nodiscard]] abut_status read(const Body& body, Motion& out) const;
  // Contacts now, and how bodies move.
  [[nodiscard]] abut_status look(double dt, Pass& pass);
  [[nodiscard]] abut_status collect(double dt, Pass& pass) const;
  [[nodiscard]] abut_status read_side(abut_geometry_id geometry, const abut_vec3& point, std::uint32_t& body,
                                      abut_vec3& velocity) const;
  void add_forces(double dt, Pass& pass) const;
  // Whether all velocities are finite. Gaps are those after a time `ahead`.
  [[nodiscard]] bool solve_islands(double ahead, Pass& pass) const;
  [[nodiscard]] bool solve_island(const Island& island, double ahead, Pass& pass) const;
  [[nodiscard]] bool move_apart(const Island& island, const Problem& solved, Pass& pass) const;
  [[nodiscard]] abut_status write(double dt, const Pass& pass);
  // What is told of contacts and islands; impulses add up in a step.
  void tell(const Pass& pass);
  // What the next step begins with.
  void keep(double dt, const Pass& pass);
  void finish(double dt);

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
  std::vector<Body> bodies_;       // in the order of their parts
  std::vector<KeptContact> kept_;  // in their order
  std::vector<abut_response_contact> contacts_;
  std::vector<abut_response_island> islands_;
};

}  // namespace abut::response
