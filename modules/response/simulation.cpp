// SPDX-License-Identifier: Apache-2.0
// The order of a step: contacts, forces, impulses of each island, motion, and a push apart where rigid bodies overlap.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

[[nodiscard]] auto key_of(const abut_part_id& part) { return std::tuple(part.slot, part.generation); }
[[nodiscard]] auto key_of(const KeptContact& contact) {
  return std::tuple(contact.a.slot, contact.a.generation, contact.b.slot, contact.b.generation, contact.id);
}

[[nodiscard]] abut_vec3 vector_of(const Row& row, std::size_t first) {
  return {row[first], row[first + 1], row[first + 2]};
}
[[nodiscard]] Row row_of(const abut_vec3& linear, const abut_vec3& angular) {
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}

// Springs and dampers by implicit Euler: an impulse f = -dt (k g1 + d u) with the gap g1 = g + dt u at the end of the
// step.
struct Yield {
  double compliance, offset;
};
[[nodiscard]] Yield yield_of(const abut_contact_material& material, double gap, double dt) {
  if (material.compliance == 0) return {.compliance = 0, .offset = std::max(gap, 0.0) / dt};
  const double stiffness = 1 / material.compliance, whole = dt * stiffness + material.damping;
  return {.compliance = 1 / (dt * whole), .offset = stiffness * gap / whole};
}

}  // namespace

Matrix world_inertia(const Matrix& inertia, const abut_quat& orientation) {
  const Matrix turn = matrix_of(orientation);
  Matrix out = product(product(turn, inertia), transposed(turn));
  for (const auto& [i, j] : {std::pair(1U, 3U), std::pair(2U, 6U), std::pair(5U, 7U)}) out[i] = out[j];
  return out;
}

abut_vec3 accelerated(const Matrix& inertia, const abut_vec3& torque) {
  return vector_of(velocity_of_impulse({.mass = 1, .inertia = inertia}, row_of({}, torque)), 3);
}

Body* Simulation::find(abut_part_id part) {
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  return place != bodies_.end() && key_of(place->part) == key_of(part) ? &*place : nullptr;
}
const Body* Simulation::find(abut_part_id part) const {
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  return place != bodies_.end() && key_of(place->part) == key_of(part) ? &*place : nullptr;
}

void Simulation::add_body(abut_part_id part, const MassProperties& mass) {
  if (Body* const body = find(part); body != nullptr) {
    body->mass = mass;
    return;
  }
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  bodies_.insert(place, Body{.part = part, .mass = mass});
}

bool Simulation::remove_body(abut_part_id part) {
  return std::erase_if(bodies_, [&](const Body& body) { return key_of(body.part) == key_of(part); }) > 0;
}

std::optional<MassProperties> Simulation::mass_of(abut_part_id part) const {
  const Body* const body = find(part);
  return body == nullptr ? std::nullopt : std::optional(body->mass);
}

abut_status Simulation::push(abut_part_id part, const abut_vec3& force, const std::optional<abut_vec3>& at) {
  Body& body = *find(part);
  Motion motion;
  if (const abut_status status = read(body, motion); status != ABUT_OK) return status;
  body.force = add(body.force, force);
  if (at) body.torque = add(body.torque, cross(subtract(*at, motion.centre), force));
  return ABUT_OK;
}

void Simulation::twist(abut_part_id part, const abut_vec3& torque) {
  Body& body = *find(part);
  body.torque = add(body.torque, torque);
}

// Where a body is and how it moves now.
abut_status Simulation::read(const Body& body, Motion& out) const {
  abut_pose pose;
  abut_velocity velocity;
  if (const abut_status status = source_->pose(body.part, pose); status != ABUT_OK) return status;
  if (const abut_status status = source_->velocity(body.part, velocity); status != ABUT_OK) return status;
  const abut_vec3 arm = times(matrix_of(normalized(pose.orientation)), body.mass.centre);
  out.orientation = normalized(pose.orientation);
  out.centre = add(pose.position, arm);
  out.linear = out.linear_before = add(velocity.linear, cross(velocity.angular, arm));
  out.angular = out.angular_before = velocity.angular;
  return source_->is_awake(body.part, out.is_awake);
}

// The body of one side of a contact; where it has none, how fast its point moves all the same.
abut_status Simulation::read_side(abut_geometry_id geometry, const abut_vec3& point, std::uint32_t& body,
                                  abut_vec3& velocity) const {
  abut_part_id part{};
  if (const abut_status status = source_->part_of(geometry, part); status != ABUT_OK) return status;
  const Body* const found = find(part);
  if (found != nullptr) {
    body = static_cast<std::uint32_t>(found - bodies_.data());
    return ABUT_OK;
  }
  abut_pose pose;
  abut_velocity moving;
  if (const abut_status status = source_->pose(part, pose); status != ABUT_OK) return status;
  if (const abut_status status = source_->velocity(part, moving); status != ABUT_OK) return status;
  velocity = add(moving.linear, cross(moving.angular, subtract(point, pose.position)));
  return ABUT_OK;
}

abut_status Simulation::look(double dt, Pass& pass) {
  if (const abut_status status = source_->detect(dt); status != ABUT_OK) return status;
  pass.motions.assign(bodies_.size(), {});
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (const abut_status status = read(bodies_[i], pass.motions[i]); status != ABUT_OK) return status;
    pass.motions[i].inertia = world_inertia(bodies_[i].mass.inertia, pass.motions[i].orientation);
  }
  return collect(dt, pass);
}

// The contacts that have a body which is awake, with their rows.
abut_status Simulation::collect(double dt, Pass& pass) const {
  const std::vector<Motion>& motions = pass.motions;
  pass.contacts.clear();
  std::vector<abut_contact> found;
  if (const abut_status status = source_->contacts(found); status != ABUT_OK) return status;
  for (const abut_contact& record : found) {
    if ((record.flags & ABUT_CONTACT_SENSOR) != 0) continue;
    StepContact contact;
    contact.record = record;
    contact.point = scale(add(record.point_a, record.point_b), 0.5);
    abut_vec3 speed_a{}, speed_b{};
    abut_status status = read_side(record.geometry_a, contact.point, contact.a, speed_a);
    if (status == ABUT_OK) status = read_side(record.geometry_b, contact.point, contact.b, speed_b);
    if (status != ABUT_OK) return status;
    // One that is asleep is as good as the ground.
    for (std::uint32_t* const side : {&contact.a, &contact.b}) {
      if (*side != no_body && !motions[*side].is_awake) *side = no_body;
    }
    if (contact.a == contact.b) continue;
    abut_contact_material material{};
    bool counts = true;
    status = source_->material(record.material_a, record.material_b, material);
    if (status == ABUT_OK && edit_) status = edit_(record, material, counts);
    if (status != ABUT_OK) return status;
    if (!counts) continue;
    const KeptContact key{record.geometry_a, record.geometry_b, record.id, {}, false};
    const auto kept =
        std::ranges::lower_bound(kept_, key_of(key), {}, [](const KeptContact& its) { return key_of(its); });
    const bool was_there = kept != kept_.end() && key_of(*kept) == key_of(key);
    const double grip = was_there && kept->is_sticking ? material.static_scale : 1;
    const auto centre = [&](std::uint32_t side) { return side == no_body ? contact.point : motions[side].centre; };
    contact.rows = contact_rows({.a = contact.a,
                                 .b = contact.b,
                                 .arm_a = subtract(contact.point, centre(contact.a)),
                                 .arm_b = subtract(contact.point, centre(contact.b)),
                                 .axes = {record.tangent, cross(record.normal, record.tangent), record.normal},
                                 .frictions = {grip * material.friction_primary, grip * material.friction_secondary},
                                 .surface_velocity = subtract(speed_b, speed_a)});
    const Yield yield = yield_of(material, record.distance, dt);
    contact.rows.compliance = yield.compliance;
    contact.rows.offset = yield.offset;
    contact.rows.drift[2] += yield.offset;
    contact.restitution = material.restitution;
    contact.slow = material.restitution_threshold;
    if (was_there) contact.impulse = impulse_along(contact.rows, scale(kept->force, dt));
    pass.contacts.push_back(contact);
  }
  return ABUT_OK;
}

namespace {

// Numbers of bodies within the island.
void renumber(ContactRows& rows, const Island& island) {
  for (std::uint32_t* const side : {&rows.a, &rows.b}) {
    if (*side == no_body) continue;
    *side = static_cast<std::uint32_t>(std::ranges::lower_bound(island.bodies, *side) - island.bodies.begin());
  }
}

// Begins with the impulses of the step before, and the velocities that they lead to.
[[nodiscard]] bool warm(const Problem& problem, Solution& solution) {
  const bool is_warm = std::ranges::any_of(solution.impulses, [](const Triple& impulse) { return impulse[2] > 0; });
  if (!is_warm) return false;
  std::vector<Row> sums(problem.bodies.size());
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    add_impulse(problem.contacts[k], solution.impulses[k], sums);
  }
  solution.velocities = problem.free;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Row change = velocity_of_impulse(problem.bodies[i], sums[i]);
    for (std::size_t j = 0; j < change.size(); ++j) solution.velocities[i][j] += change[j];
  }
  return true;
}

[[nodiscard]] abut_residuals residuals_of(const SolverReport& report) {
  return {.contact = report.residuals.contact,
          .motion = report.residuals.motion,
          .dissipation = report.residuals.dissipation,
          .speed = report.speed,
          .rounds = report.rounds,
          .newton_steps = report.newton_steps,
          .is_converged = report.is_converged ? 1U : 0U,
          .reserved = 0};
}

// On the border of the cone a contact slides, and inside it sticks; rounding apart.
[[nodiscard]] abut_contact_state state_of(const ContactRows& rows, const Triple& impulse) {
  if (impulse[2] <= 0) return ABUT_CONTACT_STATE_OPEN;
  constexpr double border = 1 - 1e-9;
  const bool sticks = norm_of(impulse[0], impulse[1]) < border * rows.friction * impulse[2];
  return sticks ? ABUT_CONTACT_STATE_STICKING : ABUT_CONTACT_STATE_SLIDING;
}

}  // namespace

// Velocities and impulses of an island, and a push apart. False where they are not finite.
bool Simulation::solve_island(const Island& island, double ahead, Pass& pass) const {
  std::vector<Motion>& motions = pass.motions;
  std::vector<StepContact>& contacts = pass.contacts;
  Problem problem;
  Solution solution;
  for (const std::uint32_t body : island.bodies) {
    const Motion& motion = motions[body];
    problem.bodies.push_back({.mass = bodies_[body].mass.mass, .inertia = motion.inertia});
    problem.free.push_back(row_of(motion.linear, motion.angular));
  }
  for (const std::uint32_t k : island.contacts) {
    ContactRows rows = contacts[k].rows;
    renumber(rows, island);
    rows.weight = weight_of(rows, problem.bodies);
    problem.contacts.push_back(rows);
    solution.impulses.push_back(project(contacts[k].impulse, rows.friction, 1, 1));
  }
  const bool is_warm = warm(problem, solution);
  const SolverReport solved = solve(
      problem, {.tolerance = options_.tolerance, .speed = 0, .most_rounds = options_.most_rounds, .is_warm = is_warm},
      solution);
  pass.islands.push_back({.body_count = static_cast<std::uint32_t>(island.bodies.size()),
                          .contact_count = static_cast<std::uint32_t>(island.contacts.size()),
                          .residuals = residuals_of(solved)});
  if (!solved.is_finite) return false;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    Motion& motion = motions[island.bodies[i]];
    motion.linear = vector_of(solution.velocities[i], 0);
    motion.angular = vector_of(solution.velocities[i], 3);
  }
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    StepContact& contact = contacts[island.contacts[k]];
    contact.impulse = solution.impulses[k];
    contact.velocity = relative_velocity(problem.contacts[k], solution.velocities);
    contact.velocity[2] -= contact.rows.offset;
    contact.gap = contact.record.distance + ahead * contact.velocity[2];
    for (const std::uint32_t side : {contact.a, contact.b}) {
      if (side != no_body && contact.impulse[2] > 0) motions[side].is_pushed = true;
    }
  }
  return move_apart(island, problem, pass);
}

// Rigid contacts that overlap at the end of the step are opened by the least moves, which change no velocity.
bool Simulation::move_apart(const Island& island, const Problem& solved, Pass& pass) const {
  Problem problem{.bodies = solved.bodies, .free = std::vector<Row>(solved.bodies.size()), .contacts = {}};
  double deepest = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    ContactRows rows = solved.contacts[k];
    if (rows.compliance > 0) continue;
    rows.friction = 0;
    rows.offset = pass.contacts[island.contacts[k]].gap + options_.slop;
    rows.drift = {0, 0, rows.offset};
    deepest = std::max(deepest, -rows.offset);
    problem.contacts.push_back(rows);
  }
  if (!(deepest > 0)) return true;
  Solution moves;
  const SolverReport report =
      solve(problem,
            {.tolerance = options_.tolerance, .speed = deepest, .most_rounds = options_.most_rounds, .is_warm = false},
            moves);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    Motion& motion = pass.motions[island.bodies[i]];
    motion.shift = vector_of(moves.velocities[i], 0);
    motion.tilt = vector_of(moves.velocities[i], 3);
  }
  return report.is_finite;
}

// Bodies move, and the world is told.
abut_status Simulation::write(double dt, const Pass& pass) {
  std::vector<abut_part_id> parts;
  std::vector<abut_pose> poses;
  std::vector<abut_velocity> velocities;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    const Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    // Constant forces are exact by the mean velocity. Where contacts push, the velocity at the end is the one that they
    // allow.
    const abut_vec3 mean = its.is_pushed ? its.linear : scale(add(its.linear_before, its.linear), 0.5);
    const Turning turned = turned_freely(body.mass.inertia, {its.orientation, its.angular}, dt);
    const abut_quat orientation = normalized(product(cayley(scale(its.tilt, 0.5)), turned.orientation));
    const abut_vec3 centre = add(add(its.centre, scale(mean, dt)), its.shift);
    const abut_vec3 arm = times(matrix_of(orientation), body.mass.centre);
    parts.push_back(body.part);
    poses.push_back({.position = subtract(centre, arm), .orientation = orientation});
    velocities.push_back({.linear = subtract(its.linear, cross(turned.angular, arm)), .angular = turned.angular});
  }
  return source_->move(parts, poses, velocities);
}

void Simulation::tell(const Pass& pass) {
  const auto same = [](const abut_contact& record) {
    return [&record](const abut_response_contact& told) {
      return told.id == record.id && told.geometry_a.slot == record.geometry_a.slot &&
             told.geometry_b.slot == record.geometry_b.slot;
    };
  };
  const auto first_island = static_cast<std::uint32_t>(islands_.size());
  const std::size_t earlier = contacts_.size();
  for (std::size_t k = 0; k < pass.contacts.size(); ++k) {
    const StepContact& contact = pass.contacts[k];
    const abut_contact& record = contact.record;
    abut_response_contact its{.geometry_a = record.geometry_a,
                              .geometry_b = record.geometry_b,
                              .id = record.id,
                              .point = contact.point,
                              .normal = record.normal,
                              .impulse = world_impulse(contact.rows, contact.impulse),
                              .force = {},
                              .distance = record.distance,
                              .normal_velocity = contact.velocity[2],
                              .state = state_of(contact.rows, contact.impulse),
                              .island = first_island + pass.island_of[k]};
    const std::span told = std::span(contacts_).first(earlier);
    if (const auto before = std::ranges::find_if(told, same(record)); before != told.end()) {
      its.impulse = add(its.impulse, before->impulse);
      *before = its;
    } else {
      contacts_.push_back(its);
    }
  }
  islands_.insert(islands_.end(), pass.islands.begin(), pass.islands.end());
}

void Simulation::keep(double dt, const Pass& pass) {
  kept_.clear();
  for (const StepContact& contact : pass.contacts) {
    const abut_contact& record = contact.record;
    kept_.push_back({record.geometry_a, record.geometry_b, record.id,
                     scale(world_impulse(contact.rows, contact.impulse), 1 / dt),
                     state_of(contact.rows, contact.impulse) == ABUT_CONTACT_STATE_STICKING});
  }
  std::ranges::sort(kept_, {}, [](const KeptContact& contact) { return key_of(contact); });
}

void Simulation::finish(double dt) {
  for (abut_response_contact& contact : contacts_) contact.force = scale(contact.impulse, 1 / dt);
  for (Body& body : bodies_) body.force = body.torque = {};
}

// Forces change momentum here; turns without torque keep it, and come when bodies move.
void Simulation::add_forces(double dt, Pass& pass) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    its.linear = add(its.linear, scale(add(options_.gravity, scale(body.force, 1 / body.mass.mass)), dt));
    its.angular = add(its.angular, scale(accelerated(its.inertia, body.torque), dt));
  }
}

bool Simulation::solve_islands(double ahead, Pass& pass) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const StepContact& contact : pass.contacts) sides.emplace_back(contact.a, contact.b);
  pass.islands.clear();
  pass.island_of.assign(pass.contacts.size(), 0);
  for (const Island& island : islands_of(bodies_.size(), sides)) {
    if (island.contacts.empty()) continue;
    for (const std::uint32_t k : island.contacts) pass.island_of[k] = static_cast<std::uint32_t>(pass.islands.size());
    if (!solve_island(island, ahead, pass)) return false;
  }
  return true;
}

abut_status Simulation::step(double dt) {
  std::erase_if(bodies_, [&](const Body& body) { return !source_->has(body.part); });
  return (options_.flags & ABUT_RESPONSE_IMPACTS) != 0 ? step_by_impacts(dt) : step_at_once(dt);
}

abut_status Simulation::step_at_once(double dt) {
  Pass pass;
  if (const abut_status status = look(dt, pass); status != ABUT_OK) return status;
  add_forces(dt, pass);
  if (!solve_islands(dt, pass)) return ABUT_NOT_CONVERGED;
  contacts_.clear();
  islands_.clear();
  tell(pass);
  keep(dt, pass);
  // Last, because all before may fail for want of memory.
  if (const abut_status status = write(dt, pass); status != ABUT_OK) return status;
  finish(dt);
  return ABUT_OK;
}

abut_status Simulation::energy(abut_energy& out) const {
  abut_energy sum{};
  for (const Body& body : bodies_) {
    if (!source_->has(body.part)) continue;
    Motion its;
    if (const abut_status status = read(body, its); status != ABUT_OK) return status;
    const double mass = body.mass.mass;
    const abut_vec3 momentum = scale(its.linear, mass);
    const abut_vec3 spin = times(world_inertia(body.mass.inertia, its.orientation), its.angular);
    sum.kinetic += 0.5 * (dot(its.linear, momentum) + dot(its.angular, spin));
    sum.potential -= mass * dot(options_.gravity, its.centre);
    sum.linear_momentum = add(sum.linear_momentum, momentum);
    sum.angular_momentum = add(sum.angular_momentum, add(cross(its.centre, momentum), spin));
  }
  out = sum;
  return ABUT_OK;
}

}  // namespace abut::response
