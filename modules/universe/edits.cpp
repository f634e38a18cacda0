// Shapes that change while they are in use.
module;
#include "../core/check.hpp"
module abut.universe;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape.shape_edit;
import abut.universe.checks;
import abut.universe.pairs;
import abut.universe.room;

namespace abut {

// Where alone a geometry has changed since the last detection. Nothing is known of one that has moved as well, or whose
// box is not that of its pose.
void Universe::patch(GeometryId geometry, const Aabb& changed) {
  const std::uint32_t place = geometry.slot - 1;
  PlaceInfo& info = infos_[place];
  const bool is_first = info.patch == no_patch;
  const bool is_settled = presence_[place] == Presence::shown && !geometries_.at(geometry).is_changed &&
                          (happened_[place] & happened_to_box) == 0 && !info.is_box_stale;
  if (!changed.is_bounded() || (is_first && !is_settled)) {
    info.patch = no_patch;
    return;
  }
  if (is_first) {
    info.patch = static_cast<std::uint32_t>(patches_.size());
    patches_.push_back({place, Aabb::empty(), {}});
  }
  Patch& its = patches_[info.patch];
  its.box.include(transformed(changed, worlds_[place]).inflated(reach_at(place)));
  its.compact_box = compact(its.box, options_.origin);
}

// Of checked ids and edits. What needs memory comes first, so that nothing has changed when there is none.
void Universe::apply_edits(std::span<const GeometryId> geometries, std::span<const Edit> edits) {
  make_room(changed_geometries_, geometries.size());
  make_room(patches_, geometries.size());
  for (const GeometryId geometry : geometries) {
    own_shape(shapes_[geometry.slot - 1]);
  }
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const std::uint32_t place = geometries[i].slot - 1;
    patch(geometries[i], apply_edit(shapes_[place], edits[i]));
    note(place, happened_to_surface);
    infos_[place].is_box_stale = true;
    enlist(geometries[i]);
    disturb(geometries_.at(geometries[i]).part);
  }
  revision_.geometries += geometries.empty() ? 0 : 1;
}

Result<void> Universe::edit_shape(GeometryId geometry, const Edit& edit) {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  if (Fault fault = check_edit(shape_at(geometry.slot - 1), edit)) {
    return *fault;
  }
  apply_edits({&geometry, 1}, {&edit, 1});
  return {};
}

Result<void> Universe::edit_shapes(std::span<const GeometryId> geometries, std::span<const Edit> edits) {
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
