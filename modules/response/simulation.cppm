// SPDX-License-Identifier: Apache-2.0
// Rigid bodies of a world, and the step that moves them.
module;

#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
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

// The impulse of a contact, for the step after.
struct KeptContact {
  abut_geometry_id a, b;
  std::uint64_t id;
  abut_vec3 impulse;  // on b
  bool is_sticking;
};

// A body while a step runs. World frame; velocities are those of the centre of mass.
struct Motion {
  abut_quat orientation{};
  abut_vec3 centre{}, linear{}, angular{};
  abut_vec3 linear_before{};  // at the start of the step
  abut_vec3 shift{}, tilt{};  // of the push apart: a move of the centre, and a small turn
  Matrix inertia{};           // about the centre of mass, world axes
  bool is_awake = false;
  bool is_pushed = false;  // by a contact
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
  struct StepContact;

  [[nodiscard]] Body* find(abut_part_id part);
  [[nodiscard]] const Body* find(abut_part_id part) const;
  [[nodiscard]] abut_status read(const Body& body, Motion& out) const;
  [[nodiscard]] abut_status collect(double dt, const std::vector<Motion>& motions, std::vector<StepContact>& out) const;
  [[nodiscard]] abut_status read_side(abut_geometry_id geometry, const abut_vec3& point, std::uint32_t& body,
                                      abut_vec3& velocity) const;
  [[nodiscard]] bool solve_island(const Island& island, double dt, std::vector<Motion>& motions,
                                  std::vector<StepContact>& contacts, abut_response_island& report) const;
  [[nodiscard]] bool move_apart(const Island& island, const Problem& solved, std::vector<Motion>& motions,
                                const std::vector<StepContact>& contacts) const;
  [[nodiscard]] abut_status write(double dt, std::vector<Motion>& motions);
  void keep(double dt, const std::vector<StepContact>& contacts, const std::vector<std::uint32_t>& island_of);

  std::unique_ptr<Source> source_;
  abut_response_options options_{};
  std::vector<Body> bodies_;       // in the order of their parts
  std::vector<KeptContact> kept_;  // in their order
  std::vector<abut_response_contact> contacts_;
  std::vector<abut_response_island> islands_;
};

}  // namespace abut::response
