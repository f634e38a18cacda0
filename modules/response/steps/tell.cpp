// SPDX-License-Identifier: Apache-2.0
// What is told of a step, and what the next one begins with.
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
[[nodiscard]] auto key_of(const abut_geometry_id& a, const abut_geometry_id& b) {
  return std::tuple(a.slot, a.generation, b.slot, b.generation);
}
[[nodiscard]] auto key_of(const abut_response_object& object) { return key_of(object.geometry_a, object.geometry_b); }
// All that a contact has received.
[[nodiscard]] abut_vec3 impulse_of(const StepContact& contact) {
  return add(world_impulse(contact.rows, contact.impulse), scale(contact.rows.axes[2], contact.given));
}

}  // namespace

// On the border of the cone a contact slides, and inside it sticks; rounding apart.
abut_contact_state state_of(const StepContact& contact) {
  if (contact.link != 0) return ABUT_CONTACT_STATE_BONDED;
  const Triple& impulse = contact.impulse;
  if (!contact.is_solved && contact.given > 0) return ABUT_CONTACT_STATE_SLIDING;
  if (impulse[2] <= 0) return ABUT_CONTACT_STATE_OPEN;
  constexpr double border = 1 - 1e-9;
  const bool sticks = norm_of(impulse[0], impulse[1]) < border * contact.rows.friction * impulse[2];
  return sticks ? ABUT_CONTACT_STATE_STICKING : ABUT_CONTACT_STATE_SLIDING;
}

void Simulation::tell(const Pass& pass, double part) {
  const auto first_island = static_cast<std::uint32_t>(islands_.size());
  const std::size_t earlier = contacts_.size();
  for (std::size_t k = 0; k < pass.contacts.size(); ++k) {
    const StepContact& contact = pass.contacts[k];
    const abut_contact& record = contact.record;
    if (record.geometry_a.slot == 0) continue;
    abut_response_contact its{.geometry_a = record.geometry_a,
                              .geometry_b = record.geometry_b,
                              .id = record.id,
                              .point = contact.point,
                              .normal = record.normal,
                              .impulse = scale(impulse_of(contact), part),
                              .force = {},
                              .distance = record.distance,
                              .normal_velocity = contact.velocity[2],
                              .state = state_of(contact),
                              .island = first_island + pass.island_of[k],
                              .kind = contact.kind,
                              .reserved = 0};
    const std::span told = std::span(contacts_).first(earlier);
    const auto before = std::ranges::find_if(told, [&](const abut_response_contact& one) {
      return one.id == record.id && is_same(one.geometry_a, record.geometry_a) &&
             is_same(one.geometry_b, record.geometry_b);
    });
    if (before != told.end()) {
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
    if (contact.link != 0) continue;
    const abut_contact& record = contact.record;
    const bool is_sticking = state_of(contact) == ABUT_CONTACT_STATE_STICKING;
    abut_vec3 creep{};
    if (contact.response == Response::slide && is_sticking) {
      // Drift holds what crept before; together they are what is left.
      for (std::size_t i = 0; i < 2; ++i) {
        const double scale_of_row = contact.rows.scales[i] > 0 ? 1 / contact.rows.scales[i] : 0;
        creep = add(creep, scale(contact.rows.axes[i], dt * scale_of_row * contact.velocity[i]));
      }
    }
    kept_.push_back({record.geometry_a, record.geometry_b, record.id,
                     scale(world_impulse(contact.rows, contact.impulse), 1 / dt), is_sticking, creep});
  }
  std::ranges::sort(kept_, {}, [](const KeptContact& contact) { return key_of(contact); });
  keep_links(dt, pass);
}

// Links learn their forces, and break.
void Simulation::keep_links(double dt, const Pass& pass) {
  links_.insert(links_.end(), pass.bonds.begin(), pass.bonds.end());
  next_link_ += pass.bonds.size();
  for (Link& link : links_) link.force = {};
  for (const StepContact& contact : pass.contacts) {
    if (contact.link == 0) continue;
    if (Link* const link = find_link(contact.link); link != nullptr)
      link->force = scale(world_impulse(contact.rows, contact.impulse), 1 / dt);
  }
  std::erase_if(links_, [&](const Link& link) {
    const bool breaks = link.break_force > 0 && length(link.force) > link.break_force;
    if (breaks && link.is_bond()) released_.emplace_back(link.geometry_a, link.geometry_b);
    return breaks;
  });
}

std::uint64_t Simulation::add_link(Link link) {
  link.number = next_link_;
  links_.push_back(link);
  return next_link_++;
}

Link* Simulation::find_link(std::uint64_t number) {
  const auto found = std::ranges::lower_bound(links_, number, {}, &Link::number);
  return found != links_.end() && found->number == number ? &*found : nullptr;
}
const Link* Simulation::find_link(std::uint64_t number) const {
  const auto found = std::ranges::lower_bound(links_, number, {}, &Link::number);
  return found != links_.end() && found->number == number ? &*found : nullptr;
}

void Simulation::remove_link(std::uint64_t number) {
  std::erase_if(links_, [&](const Link& link) { return link.number == number; });
}

bool Simulation::release(abut_geometry_id a, abut_geometry_id b) {
  const auto is_of = [&](const Link& link) {
    return (is_same(link.geometry_a, a) && is_same(link.geometry_b, b)) ||
           (is_same(link.geometry_a, b) && is_same(link.geometry_b, a));
  };
  const auto bond = std::ranges::find_if(links_, is_of);
  if (bond == links_.end()) return false;
  released_.emplace_back(bond->geometry_a, bond->geometry_b);
  std::erase_if(links_, is_of);
  return true;
}

// Objects appear with their first contact or bond, and end with the last.
void Simulation::tell_objects(double dt) {
  std::vector<abut_response_object> now;
  const auto object_of = [&](const abut_geometry_id& a, const abut_geometry_id& b) -> abut_response_object& {
    const auto place = std::ranges::lower_bound(now, key_of(a, b), {}, [](const auto& its) { return key_of(its); });
    if (place != now.end() && key_of(*place) == key_of(a, b)) return *place;
    abut_response_object made{};
    made.geometry_a = a;
    made.geometry_b = b;
    const auto before =
        std::ranges::find_if(objects_, [&](const abut_response_object& its) { return key_of(its) == key_of(a, b); });
    if (before != objects_.end() && before->event != ABUT_RESPONSE_EVENT_END) {
      made.kind = before->kind;
      made.event = ABUT_RESPONSE_EVENT_PERSIST;
      made.age = before->age + 1;
    }
    return *now.insert(place, made);
  };
  for (const auto& [a, b] : resting_) object_of(a, b);
  for (const abut_response_contact& contact : contacts_) {
    abut_response_object& its = object_of(contact.geometry_a, contact.geometry_b);
    if (its.contact_count++ == 0) its.kind = contact.kind;
    its.impulse = add(its.impulse, contact.impulse);
    its.force = scale(its.impulse, 1 / dt);
  }
  for (const Link& link : links_) {
    if (!link.is_bond()) continue;
    abut_response_object& its = object_of(link.geometry_a, link.geometry_b);
    ++its.bond_count;
    its.kind = link.kind;
  }
  std::vector<abut_response_object> ended;
  for (const abut_response_object& old : objects_) {
    if (old.event == ABUT_RESPONSE_EVENT_END) continue;
    const bool is_there =
        std::ranges::any_of(now, [&](const abut_response_object& its) { return key_of(its) == key_of(old); });
    if (is_there) continue;
    abut_response_object its{};
    its.geometry_a = old.geometry_a;
    its.geometry_b = old.geometry_b;
    its.kind = old.kind;
    its.event = ABUT_RESPONSE_EVENT_END;
    its.age = old.age + 1;
    ended.push_back(its);
  }
  std::erase_if(released_, [&](const Pair& pair) {
    return std::ranges::none_of(
        now, [&](const abut_response_object& its) { return key_of(its) == key_of(pair.first, pair.second); });
  });
  now.insert(now.end(), ended.begin(), ended.end());
  objects_ = std::move(now);
}

void Simulation::finish(double dt) {
  for (abut_response_contact& contact : contacts_) contact.force = scale(contact.impulse, 1 / dt);
  for (Body& body : bodies_) body.force = body.torque = {};
  time_ += dt;
  tell_objects(dt);
}

abut_status Simulation::explain_pair(abut_geometry_id a, abut_geometry_id b, std::string& out) const {
  GeometryFacts facts_a, facts_b;
  abut_status status = source_->facts(a, facts_a);
  if (status == ABUT_OK) status = source_->facts(b, facts_b);
  Terms terms;
  if (status == ABUT_OK) status = source_->material(facts_a.material, facts_b.material, terms.material);
  if (status != ABUT_OK) return status;
  const Choice choice = rules_.choose(facts_a, facts_b);
  if (choice.parameters != nullptr) choice.parameters->apply(terms);
  out = rules_.explain(choice, terms);
  return ABUT_OK;
}

}  // namespace abut::response
