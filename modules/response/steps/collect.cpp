// SPDX-License-Identifier: Apache-2.0
// What touches and what is linked at the start of a step, and by which law.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

[[nodiscard]] auto key_of(const KeptContact& contact) {
  return std::tuple(contact.a.slot, contact.a.generation, contact.b.slot, contact.b.generation, contact.id);
}
// What the kind friction says, for a kind of the caller.
[[nodiscard]] abut_contact_law law_of(const StepContact& contact, double dt) {
  const ContactRows& rows = contact.rows;
  const Yield yield = yield_of(contact, dt);
  return {.friction_primary = rows.friction * rows.scales[0],
          .friction_secondary = rows.friction * rows.scales[1],
          .compliance = yield.compliance,
          .offset = yield.offset,
          .pull = contact.given < 0 ? -contact.given : 0,
          .surface_velocity = {}};
}

}  // namespace

abut_status Simulation::look(double dt, Pass& pass) {
  if (const abut_status status = source_->detect(dt); status != ABUT_OK) return status;
  pass.motions.assign(bodies_.size(), {});
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (const abut_status status = read(bodies_[i], pass.motions[i]); status != ABUT_OK) return status;
  }
  read_particles(pass);
  return collect(dt, pass);
}

const KeptContact* Simulation::find_kept(const abut_contact& record) const {
  const KeptContact key{
      .a = record.geometry_a, .b = record.geometry_b, .id = record.id, .force = {}, .is_sticking = false, .creep = {}};
  const auto kept =
      std::ranges::lower_bound(kept_, key_of(key), {}, [](const KeptContact& its) { return key_of(its); });
  return kept != kept_.end() && key_of(*kept) == key_of(key) ? &*kept : nullptr;
}

bool Simulation::has_bond(const Pair& pair) const {
  return std::ranges::any_of(links_, [&](const Link& link) {
    return is_same(link.geometry_a, pair.first) && is_same(link.geometry_b, pair.second);
  });
}

abut_status Simulation::hold_part(abut_part_id part, const abut_vec3& point, double sign, const Pass& pass,
                                  Sides& out) const {
  if (part.slot == 0) return ABUT_OK;
  if (const Body* const found = find(part); found != nullptr) {
    const auto body = static_cast<std::uint32_t>(found - bodies_.data());
    const Motion& its = pass.motions[body];
    // A body that is asleep, or held, is as good as the ground.
    if (its.is_awake) out.holders.push_back({.body = body, .weight = sign, .arm = subtract(point, its.centre)});
    return ABUT_OK;
  }
  abut_pose pose;
  abut_velocity moving;
  if (const abut_status status = source_->pose(part, pose); status != ABUT_OK) return status;
  if (const abut_status status = source_->velocity(part, moving); status != ABUT_OK) return status;
  const abut_vec3 velocity = add(moving.linear, cross(moving.angular, subtract(point, pose.position)));
  out.velocity = add(out.velocity, scale(velocity, sign));
  return ABUT_OK;
}

// What materials say, then what rules say, then what the callback makes of it.
abut_status Simulation::read_terms(const abut_contact& record, const GeometryFacts& a, const GeometryFacts& b,
                                   StepContact& contact, Terms& terms, bool& counts) const {
  abut_status status = source_->material(record.material_a, record.material_b, terms.material);
  if (status != ABUT_OK) return status;
  const Choice choice = rules_.choose(a, b);
  if (choice.parameters != nullptr) choice.parameters->apply(terms);
  contact.kind = choice.kind;
  contact.response = rules_.kinds()[choice.kind].response;
  if (edit_) status = edit_(record, terms.material, counts);
  contact.compliance = terms.material.compliance;
  contact.damping = terms.material.damping;
  contact.epsilon = terms.epsilon;
  contact.restitution = terms.material.restitution;
  contact.slow = terms.material.restitution_threshold;
  return status;
}

// Of a kind that the caller has added.
abut_status Simulation::take_law(double dt, const Pass& pass, ContactPlace place, StepContact& contact,
                                 bool& counts) const {
  abut_contact_law law = law_of(contact, dt);
  abut_vec3 velocity = place.surface_velocity;
  for (const Holder& its : place.holders) {
    const Motion& motion = pass.motions[its.body];
    velocity = add(velocity, scale(add(motion.linear, cross(motion.angular, its.arm)), its.weight));
  }
  const abut_status status = rules_.kinds()[contact.kind].law(contact.record, velocity, dt, law, counts);
  if (status != ABUT_OK || !counts) return status;
  place.frictions = {law.friction_primary, law.friction_secondary};
  place.surface_velocity = add(place.surface_velocity, law.surface_velocity);
  contact.rows = contact_rows(place);
  contact.rows.compliance = contact.compliance = law.compliance;
  contact.rows.offset = law.offset;
  contact.rows.drift[2] += law.offset;
  contact.given = -law.pull;
  return ABUT_OK;
}

abut_status Simulation::bond(const abut_contact& record, const GeometryFacts& a, const GeometryFacts& b,
                             const Terms& terms, std::uint32_t kind, Pass& pass) const {
  const double compliance = terms.material.compliance;
  Link link{.number = next_link_ + pass.bonds.size(),
            .a = {.part = a.part, .point = {}},
            .b = {.part = b.part, .point = {}},
            .stiffness = compliance > 0 ? 1 / compliance : 0,
            .damping = terms.material.damping,
            .most_force = 0,
            .break_force = terms.break_force,
            .force = {},
            .geometry_a = record.geometry_a,
            .geometry_b = record.geometry_b,
            .contact = record.id,
            .kind = kind,
            .normal = record.normal};
  const abut_vec3 point = scale(add(record.point_a, record.point_b), 0.5);
  for (Anchor* const anchor : {&link.a, &link.b}) {
    abut_pose pose;
    if (const abut_status status = source_->pose(anchor->part, pose); status != ABUT_OK) return status;
    anchor->point = times(transposed(matrix_of(normalized(pose.orientation))), subtract(point, pose.position));
  }
  pass.bonds.push_back(link);
  return ABUT_OK;
}

// The contacts that have a body which is awake, with their rows, and the links.
abut_status Simulation::collect(double dt, Pass& pass) {
  pass.contacts.clear();
  resting_.clear();
  std::vector<Meeting> found;
  if (const abut_status status = find_meetings(found); status != ABUT_OK) return status;
  for (const Meeting& meeting : found) {
    const abut_contact& record = meeting.record;
    StepContact contact;
    contact.record = record;
    contact.point = meeting.point;
    GeometryFacts facts_a, facts_b;
    Sides sides;
    abut_status status = source_->facts(record.geometry_a, facts_a);
    if (status == ABUT_OK) status = source_->facts(record.geometry_b, facts_b);
    if (status == ABUT_OK) status = hold_side(facts_a, meeting.a, -1, pass, sides);
    if (status == ABUT_OK) status = hold_side(facts_b, meeting.b, 1, pass, sides);
    if (status != ABUT_OK) return status;
    std::erase_if(sides.holders, [](const Holder& its) { return its.weight == 0; });
    const Pair pair(record.geometry_a, record.geometry_b);
    if (sides.holders.empty()) resting_.push_back(pair);
    // A part does not push itself.
    if (sides.holders.empty() || (facts_a.part.slot == facts_b.part.slot && !sides.has_particles)) continue;
    facts_a.material = record.material_a;
    facts_b.material = record.material_b;
    Terms terms;
    bool counts = true;
    status = read_terms(record, facts_a, facts_b, contact, terms, counts);
    if (status != ABUT_OK) return status;
    if (!counts) continue;
    if (contact.response == Response::stick && !sides.has_particles) {
      if (has_bond(pair)) continue;
      const bool is_released = std::ranges::any_of(released_, [&](const Pair& its) {
        return is_same(its.first, pair.first) && is_same(its.second, pair.second);
      });
      if (!is_released) {
        status = bond(record, facts_a, facts_b, terms, contact.kind, pass);
        if (status != ABUT_OK) return status;
        continue;
      }
    }
    const KeptContact* const kept = find_kept(record);
    const double grip = kept != nullptr && kept->is_sticking ? terms.material.static_scale : 1;
    const double rubs = contact.response == Response::penalty ? 0 : grip;
    const ContactPlace place{
        .holders = std::move(sides.holders),
        .axes = {record.tangent, cross(record.normal, record.tangent), record.normal},
        .frictions = {rubs * terms.material.friction_primary, rubs * terms.material.friction_secondary},
        .surface_velocity = sides.velocity};
    contact.rows = contact_rows(place);
    contact.given = -dt * terms.material.adhesive_force;
    contact.is_solved = contact.response != Response::none;
    if (contact.response == Response::none) contact.given = 0;
    if (kept != nullptr && contact.response == Response::slide && kept->is_sticking) {
      contact.creep = kept->creep;
      for (std::size_t i = 0; i < 2; ++i)
        contact.rows.drift[i] += contact.rows.scales[i] * dot(kept->creep, contact.rows.axes[i]) / dt;
    }
    if (contact.response == Response::custom) {
      status = take_law(dt, pass, place, contact, counts);
      if (status != ABUT_OK) return status;
      if (!counts) {
        contact.is_solved = false;
        contact.given = 0;
      }
    }
    if (kept != nullptr && contact.is_solved) contact.impulse = impulse_along(contact.rows, scale(kept->force, dt));
    pass.contacts.push_back(contact);
  }
  for (const std::vector<Link>* const links : {&std::as_const(links_), &std::as_const(pass.bonds)}) {
    for (const Link& link : *links) {
      if (const abut_status status = collect_link(link, dt, pass); status != ABUT_OK) return status;
    }
  }
  return ABUT_OK;
}

abut_status Simulation::place_of(const Anchor& anchor, abut_vec3& out) const {
  out = anchor.point;
  if (anchor.part.slot == 0) return ABUT_OK;
  abut_pose pose;
  if (const abut_status status = source_->pose(anchor.part, pose); status != ABUT_OK) return status;
  out = add(pose.position, times(matrix_of(normalized(pose.orientation)), anchor.point));
  return ABUT_OK;
}

// Three rows along the axes of the world. Rigid ones close what has opened within the step.
abut_status Simulation::collect_link(const Link& link, double dt, Pass& pass) const {
  abut_vec3 point_a, point_b;
  abut_status status = place_of(link.a, point_a);
  if (status == ABUT_OK) status = place_of(link.b, point_b);
  Sides sides;
  if (status == ABUT_OK) status = hold_part(link.a.part, point_a, -1, pass, sides);
  if (status == ABUT_OK) status = hold_part(link.b.part, point_b, 1, pass, sides);
  if (status != ABUT_OK || sides.holders.empty()) return status;
  StepContact contact;
  contact.link = link.number;
  contact.kind = link.kind;
  contact.response = Response::stick;
  contact.record.geometry_a = link.geometry_a;
  contact.record.geometry_b = link.geometry_b;
  contact.record.id = link.contact;
  contact.record.normal = link.normal;
  contact.record.distance = length(subtract(point_b, point_a));
  contact.point = scale(add(point_a, point_b), 0.5);
  contact.rows = contact_rows({.holders = std::move(sides.holders),
                               .axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                               .frictions = {1, 1},
                               .surface_velocity = sides.velocity});
  contact.rows.law = Law::hold;
  contact.rows.friction = 0;
  contact.rows.most = link.most_force > 0 ? link.most_force * dt : std::numeric_limits<double>::infinity();
  contact.compliance = link.stiffness > 0 ? 1 / link.stiffness : 0;
  const double whole = dt * link.stiffness + link.damping;
  const double gain = link.stiffness > 0 ? link.stiffness / whole : 1 / dt;
  if (link.stiffness > 0) contact.rows.compliance = 1 / (dt * whole);
  const abut_vec3 apart = subtract(point_b, point_a);
  for (std::size_t i = 0; i < contact.rows.drift.size(); ++i) {
    contact.opened[i] = gain * dot(apart, contact.rows.axes[i]);
    contact.rows.drift[i] += contact.opened[i];
  }
  contact.impulse = impulse_along(contact.rows, scale(link.force, dt));
  pass.contacts.push_back(contact);
  return ABUT_OK;
}

}  // namespace abut::response
