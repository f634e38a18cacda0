// SPDX-License-Identifier: Apache-2.0
// Shapes that change while they are in use.
module;
#include "../core/check.hpp"
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape.shape_edit;
import abut.scene.meetings.checks;
import abut.scene.room;

namespace abut {

// Where alone a geometry has changed since the last detection. Nothing is known of one that has moved as well, or whose
// box is not that of its pose.
void Scene::patch(GeometryId geometry, const Aabb& changed) {
  const std::uint32_t place = geometry.slot - 1;
  PlaceInfo& info = places_.infos[place];
  const bool is_first = info.patch == no_patch;
  const bool is_settled = space_.is_shown(place) && !geometries_.at(geometry).is_changed &&
                          !places_.has_happened(place, happened_to_box) && !info.is_box_stale;
  if (!changed.is_bounded() || (is_first && !is_settled)) {
    info.patch = no_patch;
    return;
  }
  if (is_first) {
    info.patch = static_cast<std::uint32_t>(changes_.patches.size());
    changes_.patches.push_back({place, Aabb::empty(), {}});
  }
  Patch& its = changes_.patches[info.patch];
  const Real reach = reach_of(info, options_.tolerance_mode, meetings_.policies.largest_tolerance());
  its.box.include(transformed(changed, places_.worlds[place]).inflated(reach));
  its.compact_box = compact(its.box, options_.origin);
}

namespace {

// Where an edit changes a shape at most, in the frame of the shape, but for what it adds to the box; everywhere where
// that is not known. A new box moves the origin of all queries, so more than this is examined anew.
Aabb place_of(const Edit& edit, const AnyShape& shape) {
  const auto* heights = std::get_if<HeightEdit>(&edit);
  if (heights == nullptr) {
    return Aabb::everything();
  }
  const std::vector<Real> parameters = parameters_of(shape);
  const Real across = parameters[2], along = parameters[3];
  const Real column = heights->column, row = heights->row;
  Aabb out = aabb_of(shape, Pose::identity());
  out.low.x = across * (column - 1);
  out.low.y = along * (row - 1);
  out.high.x = across * (column + heights->columns);
  out.high.y = along * (row + heights->rows);
  return out;
}

}  // namespace

void Scene::make_room_for_edits(std::size_t count) {
  make_room(changes_.changed_geometries, count);
  make_room(changes_.patches, count);
}

// After the shape of a geometry has changed, at most in a box, but for what that adds to the box of the shape.
void Scene::follow_edit(GeometryId geometry, const Aabb& changed, const Aabb& place_before) {
  const std::uint32_t place = geometry.slot - 1;
  patch(geometry, changed);
  places_.note(place, happened_to_surface);
  places_.infos[place].is_box_stale = true;
  enlist(geometry);
  if (sleep_.is_used()) {
    Aabb its = place_before;
    const Aabb box = aabb_of(shape_at(place), Pose::identity());
    its.low.z = std::min(its.low.z, box.low.z);
    its.high.z = std::max(its.high.z, box.high.z);
    disturb_by_edit(geometry, changed.is_bounded() ? changed : its);
  }
}

// Of checked ids and edits. What needs memory comes first, so that nothing has changed when there is none.
void Scene::apply_edits(std::span<const GeometryId> geometries, std::span<const Edit> edits) {
  make_room_for_edits(geometries.size());
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    own_shape(places_.shapes[geometries[i].slot - 1], edits[i]);
  }
  std::vector<Aabb> places;
  for (std::size_t i = 0; sleep_.is_used() && i < geometries.size(); ++i) {
    places.push_back(place_of(edits[i], shape_at(geometries[i].slot - 1)));
  }
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const std::uint32_t place = geometries[i].slot - 1;
    if (std::get_if<RecreationEdit>(&edits[i]) != nullptr) {
      lent_.forget(place);
    }
    const Aabb changed = apply_edit(places_.shapes[place], edits[i]);
    follow_edit(geometries[i], changed, places.empty() ? Aabb::everything() : places[i]);
  }
  count_change(geometries, {1, 0});
}

Result<std::span<Vec3>> Scene::lend_next_vertices(GeometryId geometry) {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  const std::uint32_t place = geometry.slot - 1;
  if (Fault fault = check_next_vertices(shape_at(place), {})) {
    return *fault;
  }
  return lent_.lend(place, held_triangles(shape_at(place)).vertices);
}

Fault Scene::check_advance(GeometryId geometry) const {
  const std::span<const Vec3> next = lent_.of(geometry.slot - 1);
  return next.empty() ? Error{Errc::invalid_argument, "it has lent no vertices"}
                      : check_next_vertices(shape_at(geometry.slot - 1), next);
}

Result<void> Scene::advance_vertices(GeometryId geometry) {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  if (Fault fault = check_advance(geometry)) {
    return Error{fault->code, "geometry: " + fault->message};
  }
  exchange_all({&geometry, 1});
  return {};
}

Result<void> Scene::advance_vertices(std::span<const GeometryId> geometries) {
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    if (Fault fault = check_advance(geometries[i])) {
      return Error{fault->code, name_at("geometries", i) + ": " + fault->message};
    }
  }
  if (mark_all(geometries_, geometries, "geometries")) {
    return Error{Errc::invalid_argument, "geometries has one of them twice; each can advance once"};
  }
  for (const GeometryId geometry : geometries) {
    geometries_.at(geometry).is_marked = false;
  }
  exchange_all(geometries);
  return {};
}

// As apply_edits.
void Scene::exchange_all(std::span<const GeometryId> geometries) {
  make_room_for_edits(geometries.size());
  for (const GeometryId geometry : geometries) {
    own_vertices(places_.shapes[geometry.slot - 1]);
  }
  for (const GeometryId geometry : geometries) {
    const std::uint32_t place = geometry.slot - 1;
    const Aabb changed = exchange_vertices(places_.shapes[place], lent_.take_back(place));
    follow_edit(geometry, changed, Aabb::everything());
  }
  count_change(geometries, {1, 0});
}

// What is not dynamic wakes what lies where it has changed, by the boxes of the last refresh: what has moved since is
// awake.
void Scene::disturb_by_edit(GeometryId geometry, const Aabb& changed) {
  const Geometry& its = geometries_.at(geometry);
  const PlaceInfo& info = places_.infos[geometry.slot - 1];
  if (info.is_dynamic || !changed.is_bounded()) {
    disturb(its.part);
    return;
  }
  const Real reach = reach_of(info, options_.tolerance_mode, meetings_.policies.largest_tolerance());
  visit(transformed(changed, world_of(its).pose()).inflated(reach), [&](std::uint32_t place) {
    if (places_.infos[place].is_dynamic) {
      sleep_.wake(places_.infos[place].part.slot);
    }
  });
}

Result<void> Scene::edit_shape(GeometryId geometry, const Edit& edit) {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  if (Fault fault = check_edit(shape_at(geometry.slot - 1), edit)) {
    return *fault;
  }
  apply_edits({&geometry, 1}, {&edit, 1});
  return {};
}

Result<void> Scene::edit_shapes(std::span<const GeometryId> geometries, std::span<const Edit> edits) {
  ABUT_CHECK(geometries.size() == edits.size());
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (Fault fault = check_edit(shape_at(geometries[i].slot - 1), edits[i])) {
      return Error{fault->code, name_at("geometries", i) + ": " + fault->message};
    }
  }
  apply_edits(geometries, edits);
  return {};
}

}  // namespace abut
