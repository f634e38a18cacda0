// SPDX-License-Identifier: Apache-2.0
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.meetings.checks;
import abut.scene.journal;
import abut.scene.meetings;
import abut.scene.meetings.policies;

namespace abut {
namespace {

// Distinct for up to 2^32 universes, and far apart for neighbours (Knuth's multiplicative hash).
std::uint32_t first_generation(std::uint32_t number, std::uint32_t salt) {
  constexpr std::uint64_t golden = 0x9e3779b1;
  return static_cast<std::uint32_t>((number * golden + salt) & 0xffffffff);
}

Fault check_tags(std::uint32_t tag_a, std::uint32_t tag_b) {
  if (tag_a < tag_count && tag_b < tag_count) {
    return std::nullopt;
  }
  const bool is_first = tag_a >= tag_count;
  return error_about(Errc::out_of_range, is_first ? "tag_a" : "tag_b", std::uint64_t{is_first ? tag_a : tag_b},
                     "below " + std::to_string(tag_count));
}

}  // namespace

Scene::Scene(const UniverseOptions& options, std::uint32_t number)
    : options_(options),
      parts_(first_generation(number, 1)),
      geometries_(first_generation(number, 0x80000001)),
      places_(sample_shape()) {}

void Scene::end_detection() { is_stepping_ = false; }

void Scene::count_change(std::span<const GeometryId> geometries, const Revision& by) {
  if (geometries.empty()) {
    return;
  }
  revision_.geometries += by.geometries;
  revision_.poses += by.poses;
  const std::uint64_t time = Journal::time_of(revision_);
  if (!Journal::holds(geometries.size())) {
    journal_.forget(time);
    return;
  }
  for (const GeometryId geometry : geometries) {
    journal_.note(geometry.slot, time);
  }
}

void Scene::count_moves(std::span<const PartId> parts) {
  if (parts.empty()) {
    return;
  }
  ++revision_.poses;
  const std::uint64_t time = Journal::time_of(revision_);
  if (!Journal::holds(parts.size())) {
    journal_.forget(time);
    return;
  }
  for (const PartId part : parts) {
    for (const GeometryId geometry : parts_.at(part).geometries) {
      journal_.note(geometry.slot, time);
    }
  }
}

std::optional<std::vector<GeometryId>> Scene::changed_since(const Revision& since) const {
  const auto slots = journal_.slots_after(Journal::time_of(since));
  if (!slots) {
    return std::nullopt;
  }
  std::vector<GeometryId> out;
  out.reserve(slots->size());
  for (const std::uint32_t slot : *slots) {
    const GeometryId id = places_.id_at(slot - 1);
    out.push_back(geometries_.contains(id) ? id : GeometryId{slot, 0});
  }
  return out;
}

// Of filters that have parked geometries.
void Scene::apply_deferred_parking() {
  for (const auto& [geometry, parking] : std::exchange(deferred_parking_, {})) {
    if (geometries_.contains(geometry)) {
      settle_parking(geometry, parking);
    }
  }
}

Result<void> Scene::set_rule(const Collidable& a, const Collidable& b, Rule rule) {
  const auto is_known = [&](const Collidable& its) {
    return (its.kind != CollidableKind::geometry || geometries_.contains(GeometryId{its.slot, its.generation})) &&
           (its.kind != CollidableKind::part || parts_.contains(PartId{its.slot, its.generation}));
  };
  if (!is_known(a) || !is_known(b)) {
    return Error{Errc::stale_id, std::string(is_known(a) ? "b" : "a") +
                                     " names a geometry or a part that is stale or belongs to another universe"};
  }
  meetings_.rules.set(a, b, rule);
  meetings_.must_ask_again = true;
  return {};
}

void Scene::clear_rules() {
  meetings_.must_ask_again = meetings_.must_ask_again || !meetings_.rules.is_empty();
  meetings_.rules.clear();
}

Result<RuleVerdict> Scene::rule_between(GeometryId a, GeometryId b) const {
  if (!geometries_.contains(a) || !geometries_.contains(b)) {
    return stale(geometries_.contains(a) ? "geometry_b" : "geometry_a");
  }
  return meetings_.rules.verdict(Meetings::side_of(places_, a.slot - 1), Meetings::side_of(places_, b.slot - 1));
}

void Scene::set_filter(Filter filter) {
  meetings_.filter = std::move(filter);
  refilter();
}

void Scene::refilter() {
  meetings_.filter_counts = {};
  meetings_.must_ask_again = true;
}

Result<void> Scene::set_policy(std::uint32_t tag_a, std::uint32_t tag_b, const Policy& policy) {
  if (Fault fault = check_tags(tag_a, tag_b)) {
    return *fault;
  }
  if (Fault fault = check_policy(policy)) {
    return *fault;
  }
  const Real before = meetings_.policies.largest_tolerance();
  meetings_.policies.set(tag_a, tag_b, policy);
  meetings_.must_ask_again = true;
  // Boxes have to reach as far as the largest tolerance.
  if (options_.tolerance_mode == ToleranceMode::margin && meetings_.policies.largest_tolerance() != before) {
    for (const GeometryId geometry : geometries()) {
      places_.infos[geometry.slot - 1].is_box_stale = true;
      change(geometry);
    }
  }
  return {};
}

Result<Policy> Scene::policy(std::uint32_t tag_a, std::uint32_t tag_b) const {
  if (Fault fault = check_tags(tag_a, tag_b)) {
    return *fault;
  }
  return meetings_.policies.of(tag_a, tag_b);
}

Result<void> Scene::set_material(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row) {
  if (row) {
    if (Fault fault = check_material(*row)) {
      return *fault;
    }
  }
  materials_.set(a, b, row);
  return {};
}

Result<void> Scene::set_focus(const std::optional<Focus>& focus, std::span<const Vec3> centres) {
  if (!focus) {
    focus_.end();
    return {};
  }
  if (Fault fault = check_focus(*focus)) {
    return *fault;
  }
  focus_.set(*focus, centres, options_.origin);
  return {};
}

std::size_t Scene::bytes() const {
  return parts_.bytes() + geometries_.bytes() + list_bytes_ + places_.bytes() + space_.bytes() + changes_.bytes() +
         meetings_.bytes() + focus_.bytes() + materials_.bytes() + sleep_.bytes() + velocities_.bytes() +
         lent_.bytes() + (self_places_.capacity() + swept_places_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace abut
