// SPDX-License-Identifier: Apache-2.0
module;
#include "../core/check.hpp"
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.meetings.checks;
import abut.scene.room;

namespace abut {
namespace {

Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

bool is_identity(const Placement& its) {
  return its.position == Vec3{0, 0, 0} && its.orientation.x == 0 && its.orientation.y == 0 && its.orientation.z == 0;
}

}  // namespace

// Of a geometry that may not be anywhere as it was.
void Scene::change(GeometryId geometry) {
  places_.infos[geometry.slot - 1].patch = no_patch;
  enlist(geometry);
}

// Puts a geometry on the list of those that the next detection looks at.
void Scene::enlist(GeometryId geometry) {
  Geometry& its = geometries_.at(geometry);
  if (!its.is_changed) {
    its.is_changed = true;
    changes_.changed_geometries.push_back(geometry);
  }
}

// Short term it is hidden in the broad phase, long term it leaves it. Coming back waits for the next detection.
void Scene::settle_parking(GeometryId geometry, Parking parking) {
  Geometry& its = geometries_.at(geometry);
  const std::uint32_t place = geometry.slot - 1;
  const Parking before = std::exchange(its.options.parking, parking);
  if (parking == before) {
    return;
  }
  parked_count_ += (parking != Parking::none ? 1 : 0);
  parked_count_ -= (before != Parking::none ? 1 : 0);
  count_change({&geometry, 1}, {1, 0});
  if (parking == Parking::none) {
    change(geometry);
  } else if (parking == Parking::long_term) {
    space_.leave(place);
  } else {
    space_.hide(place);
  }
}

// Beside the pairs that the broad phase finds.
void Scene::set_self_pairs(std::uint32_t place, bool has_them) {
  if (places_.infos[place].has_self_pairs == has_them) {
    return;
  }
  const auto at = std::lower_bound(self_places_.begin(), self_places_.end(), place);
  if (has_them) {
    self_places_.insert(at, place);
  } else {
    self_places_.erase(at);
  }
  places_.infos[place].has_self_pairs = has_them;
  space_.set_changed(true);
}

void Scene::set_sweeping(std::uint32_t place, Sweeping sweeping) {
  if (std::exchange(places_.infos[place].sweeping, sweeping) == sweeping) {
    return;
  }
  const auto at = std::lower_bound(swept_places_.begin(), swept_places_.end(), place);
  const bool is_listed = at != swept_places_.end() && *at == place;
  if (sweeping == Sweeping::none) {
    swept_places_.erase(at);
  } else if (!is_listed) {
    swept_places_.insert(at, place);
  }
}

void Scene::set_keeps_side(std::uint32_t place, bool keeps_it) {
  PlaceInfo& info = places_.infos[place];
  side_keeper_count_ += keeps_it ? 1 : 0;
  side_keeper_count_ -= info.keeps_side ? 1 : 0;
  info.keeps_side = keeps_it;
}

// What pairs ask about a geometry, after its options have changed.
void Scene::apply_options(GeometryId geometry) {
  Geometry& its = geometries_.at(geometry);
  const GeometryOptions& options = its.options;
  PlaceInfo& info = places_.infos[geometry.slot - 1];
  its.local_pose = options.local.pose();
  info.layers = options.layers;
  info.mask = options.mask;
  info.exclusion = options.exclusion;
  info.tolerance = options.tolerance;
  info.generation = geometry.generation;
  info.part = its.part;
  info.label = options.label;
  info.tag = static_cast<std::uint8_t>(options.tag);
  info.material = options.material;
  info.is_dynamic = parts_.at(its.part).motion == MotionKind::dynamic;
  info.is_sensor = options.is_sensor;
  set_self_pairs(geometry.slot - 1, options.has_self_pairs);
  set_sweeping(geometry.slot - 1, options.sweeping);
  set_keeps_side(geometry.slot - 1, options.keeps_side);
  info.is_at_part = is_identity(options.local);
  info.is_box_stale = true;
  places_.note(geometry.slot - 1, happened_to_filters);
}

Result<std::vector<GeometryId>> Scene::create_geometries(std::span<const PartId> parts,
                                                         std::span<const ShapeHandle> shapes,
                                                         std::span<const GeometryOptions> options) {
  ABUT_CHECK(parts.size() == shapes.size() && (options.empty() || options.size() == parts.size()));
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_options(options[i], i)) {
      return *fault;
    }
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_self_pairs(options[i], kind_in_pairs(*shapes[i]))) {
      return Error{fault->code, name_at("options", i) + "." + fault->message};
    }
  }
  std::vector<GeometryId> created;
  created.reserve(parts.size());
  try {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const GeometryId id = geometries_.insert(
          {.part = parts[i], .local_pose = {}, .options = options.empty() ? GeometryOptions{} : options[i]});
      created.push_back(id);
      parked_count_ += geometries_.at(id).options.parking != Parking::none ? 1 : 0;
      places_.make_room(id.slot);
      space_.make_room(id.slot);
      std::vector<GeometryId>& list = parts_.at(parts[i]).geometries;
      const std::size_t capacity_before = list.capacity();
      list.push_back(id);
      list_bytes_ += (list.capacity() - capacity_before) * sizeof(GeometryId);
      places_.shapes[id.slot - 1] = shapes[i];
      places_.infos[id.slot - 1] = {};
      places_.happened[id.slot - 1] = 0;
      places_.infos[id.slot - 1].kind = static_cast<std::uint8_t>(kind_in_pairs(*shapes[i]));
      apply_options(id);
      change(id);
    }
  } catch (...) {
    // The last one first: the next call gets the same slots.
    for (; !created.empty(); created.pop_back()) {
      std::erase(parts_.at(geometries_.at(created.back()).part).geometries, created.back());
      forget_geometry(created.back());
    }
    throw;
  }
  std::ranges::for_each(parts, [&](PartId part) { disturb(part); });
  count_change(created, {1, 0});
  return created;
}

// Takes a geometry out of everything but the list of its part.
void Scene::forget_geometry(GeometryId geometry) {
  const std::uint32_t place = geometry.slot - 1;
  space_.leave(place);
  lent_.forget(place);
  if (place < places_.infos.size()) {
    set_self_pairs(place, false);
    set_sweeping(place, Sweeping::none);
    set_keeps_side(place, false);
    places_.shapes[place] = places_.vacant;
  }
  if (!meetings_.rules.is_empty()) {
    meetings_.rules.forget({CollidableKind::geometry, geometry.slot, geometry.generation});
  }
  changes_.are_slots_reused = true;
  parked_count_ -= geometries_.at(geometry).options.parking != Parking::none ? 1 : 0;
  geometries_.erase(geometry);
}

Result<void> Scene::destroy_geometries(std::span<const GeometryId> geometries) {
  if (std::optional<Error> error = mark_all(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (const GeometryId geometry : geometries) {
    disturb(geometries_.at(geometry).part);
    std::erase(parts_.at(geometries_.at(geometry).part).geometries, geometry);
    forget_geometry(geometry);
  }
  count_change(geometries, {geometries.size(), 0});
  return {};
}

Result<void> Scene::set_shapes(std::span<const GeometryId> geometries, std::span<const ShapeHandle> shapes) {
  ABUT_CHECK(geometries.size() == shapes.size());
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  make_room(changes_.changed_geometries, geometries.size());
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const std::uint32_t place = geometries[i].slot - 1;
    lent_.forget(place);
    places_.shapes[place] = shapes[i];
    places_.infos[place].kind = static_cast<std::uint8_t>(kind_in_pairs(*shapes[i]));
    places_.note(place, happened_to_shape);
    places_.infos[place].is_box_stale = true;
    change(geometries[i]);
    disturb(geometries_.at(geometries[i]).part);
  }
  count_change(geometries, {1, 0});
  return {};
}

Result<void> Scene::set_options(std::span<const GeometryId> geometries, std::span<const GeometryOptions> options) {
  ABUT_CHECK(geometries.size() == options.size());
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_options(options[i], i)) {
      return *fault;
    }
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_self_pairs(options[i], places_.infos[geometries[i].slot - 1].kind)) {
      return Error{fault->code, name_at("options", i) + "." + fault->message};
    }
  }
  make_room(changes_.changed_geometries, geometries.size());
  self_places_.reserve(self_places_.size() +
                       static_cast<std::size_t>(std::ranges::count_if(options, &GeometryOptions::has_self_pairs)));
  const auto is_swept = [](const GeometryOptions& its) { return its.sweeping != Sweeping::none; };
  swept_places_.reserve(swept_places_.size() + static_cast<std::size_t>(std::ranges::count_if(options, is_swept)));
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    settle_parking(geometries[i], options[i].parking);
    geometries_.at(geometries[i]).options = options[i];
    apply_options(geometries[i]);
    change(geometries[i]);
    disturb(geometries_.at(geometries[i]).part);
  }
  count_change(geometries, {1, 1});
  return {};
}

Result<void> Scene::set_user_data(std::span<const GeometryId> geometries, std::span<const std::uint64_t> user_data) {
  ABUT_CHECK(geometries.size() == user_data.size());
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    geometries_.at(geometries[i]).options.user_data = user_data[i];
  }
  return {};
}

Result<void> Scene::park(std::span<const GeometryId> geometries, Parking parking) {
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  make_room(changes_.changed_geometries, geometries.size());
  make_room(deferred_parking_, is_stepping_ ? geometries.size() : 0);
  for (const GeometryId geometry : geometries) {
    if (is_stepping_) {
      deferred_parking_.emplace_back(geometry, parking);
    } else {
      settle_parking(geometry, parking);
    }
  }
  return {};
}

Placement Scene::world_of(const Geometry& geometry) const {
  const Part& part = parts_.at(geometry.part);
  const Placement& local = geometry.options.local;
  return {part.placement.pose() * local.position, product(part.placement.orientation, local.orientation)};
}

Result<GeometryInfo> Scene::describe(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  const Geometry& its = geometries_.at(geometry);
  GeometryOptions options = its.options;
  options.tag = places_.infos[geometry.slot - 1].tag;  // which the focus may have changed
  return GeometryInfo{its.part, places_.shapes[geometry.slot - 1], world_of(its), options};
}

Result<Placement> Scene::world_pose(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  return world_of(geometries_.at(geometry));
}

std::vector<GeometryId> Scene::geometries() const {
  std::vector<GeometryId> all;
  all.reserve(geometries_.size());
  geometries_.for_each([&](GeometryId id, const Geometry&) { all.push_back(id); });
  return all;
}

}  // namespace abut
