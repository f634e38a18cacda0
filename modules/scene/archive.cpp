// SPDX-License-Identifier: Apache-2.0
// A scene as bytes, and a new scene from them.
module abut.scene;
import abut.broadphase;
import abut.capability;
import abut.core.archive;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.pairs.any_shape.shape_archive;
import abut.pairs.any_shape;
import abut.scene.state.changes;
import abut.scene.meetings.checks;
import abut.scene.rest.focus_tags;
import abut.scene.meetings;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.meetings.rules;
import abut.scene.state.space;

namespace abut {
namespace {

// What does not follow from the options of a geometry and its part.
struct SavedPlace {
  std::uint32_t shape = 0;
  Pose world{};
  CompactAabb box{};
  std::uint32_t patch = no_patch;
  std::uint8_t happened = 0, tag = 0;
  bool is_box_stale = false;
};
struct SavedPatch {
  std::uint32_t place;
  Aabb box;
};

bool is_box(const CompactAabb& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}

bool is_right(const SavedPlace& its, std::size_t shapes, std::size_t patches) {
  constexpr unsigned all_happened = 31;
  // A geometry that no refresh has seen has no box yet.
  return its.shape < shapes && is_rigid(its.world) && is_box(its.box) && its.tag < tag_count &&
         its.happened <= all_happened && (its.patch == no_patch || its.patch < patches);
}

bool is_within(std::span<const std::uint32_t> places, std::size_t count) {
  return std::ranges::all_of(places, [&](std::uint32_t place) { return place < count; });
}

// Each id of something that is there, once.
template <class Ids, class Map>
std::vector<Ids> present_once(std::span<const Ids> ids, const Map& map) {
  std::vector<bool> is_seen(map.slot_count());
  std::vector<Ids> out;
  for (const Ids& id : ids) {
    if (map.contains(id) && !is_seen[id.slot - 1]) {
      is_seen[id.slot - 1] = true;
      out.push_back(id);
    }
  }
  return out;
}

Fault check_far(const Placement& placement) {
  const bool is_near = largest_magnitude(placement.position) <= largest_coordinate;
  return is_near ? std::nullopt : Fault(Error{Errc::out_of_range, "a position is beyond 1e70"});
}

}  // namespace

void Scene::save(ByteWriter& out) const {
  ShapeList shapes;
  std::vector<SavedPlace> saved;
  geometries_.for_each([&](GeometryId id, const Geometry&) { shapes.add(places_.shapes[id.slot - 1]); });
  geometries_.for_each([&](GeometryId id, const Geometry&) {
    const std::uint32_t at = id.slot - 1;
    const PlaceInfo& info = places_.infos[at];
    saved.push_back({shapes.number_of(places_.shapes[at]), places_.worlds[at], places_.boxes[at], info.patch,
                     places_.happened[at], info.tag, info.is_box_stale});
  });
  std::vector<SavedPatch> patches;
  for (const Patch& patch : changes_.patches) {
    patches.push_back({patch.place, patch.box});
  }
  shapes.write(out);
  out(parts_, geometries_, saved, patches);
  out(present_once<PartId>(changes_.moved_parts, parts_),
      present_once<GeometryId>(changes_.changed_geometries, geometries_), changes_.rejoining, changes_.fresh);
  out(meetings_.rules, meetings_.policies, meetings_.must_ask_again, focus_, materials_, sleep_, velocities_,
      revision_);
  out(space_.kind(), space_.presences());
}

void Scene::load(ByteReader& in, const Workers& workers) {
  ShapeList shapes;
  std::vector<SavedPlace> saved;
  std::vector<SavedPatch> patches;
  std::vector<std::uint8_t> presences;
  BroadphaseKind kind{};
  shapes.read(in);
  in(parts_, geometries_, saved, patches);
  in(changes_.moved_parts, changes_.changed_geometries, changes_.rejoining, changes_.fresh);
  in(meetings_.rules, meetings_.policies, meetings_.must_ask_again, focus_, materials_, sleep_, velocities_, revision_);
  in(kind, presences);
  check_parts(in);
  const auto is_part = [&](PartId id) { return parts_.contains(id); };
  in.require(saved.size() == geometries_.size() && presences.size() == geometries_.slot_count(),
             "geometries and their places do not fit each other");
  in.require(std::ranges::all_of(
                 saved, [&](const SavedPlace& its) { return is_right(its, shapes.all().size(), patches.size()); }),
             "a geometry has no shape, pose or box");
  in.require(std::ranges::all_of(presences, Space::is_presence) && kind != BroadphaseKind::automatic &&
                 kind <= BroadphaseKind::hash_grid,
             "the broad phase is none");
  const std::size_t count = geometries_.slot_count();
  in.require(is_within(changes_.rejoining, count) && is_within(changes_.fresh, count) &&
                 std::ranges::all_of(patches, [&](const SavedPatch& its) { return its.place < count; }),
             "a change is of no geometry");
  if (in.has_failed()) {
    return;
  }
  in.require(sleep_.restore(parts_.slot_count(), is_part), "a part that may sleep is there twice or not at all");
  in.require(velocities_.restore(parts_.slot_count(), is_part), "the velocities do not fit the parts");
  for (const SavedPatch& its : patches) {
    changes_.patches.push_back({its.place, its.box, compact(its.box, options_.origin)});
  }
  std::size_t number = 0;
  places_.make_room(count);
  space_.make_room(count);
  geometries_.for_each([&](GeometryId id, const Geometry& geometry) {
    const std::uint32_t at = id.slot - 1;
    const SavedPlace& its = saved[number++];
    places_.shapes[at] = shapes.all()[its.shape];
    places_.infos[at].kind = static_cast<std::uint8_t>(kind_in_pairs(*places_.shapes[at]));
    apply_options(id);
    parked_count_ += geometry.options.parking != Parking::none ? 1 : 0;
    places_.worlds[at] = its.world;
    places_.boxes[at] = its.box;
    places_.happened[at] = its.happened;
    places_.infos[at].tag = its.tag;
    places_.infos[at].patch = its.patch;
    places_.infos[at].is_box_stale = its.is_box_stale;
  });
  journal_.forget(Journal::time_of(revision_));
  restore_changes(presences);
  space_.restore(workers, places_, kind, presences);
}

// Numbers of parts and geometries, and whether they know each other.
void Scene::check_parts(ByteReader& in) const {
  if (in.has_failed()) {
    return;
  }
  std::vector<bool> is_listed(geometries_.slot_count());
  std::size_t listed = 0;
  parts_.for_each([&](PartId id, const Part& part) {
    const Fault fault = check_placement(part.placement, "parts", id.slot);
    const Fault far = check_far(part.placement);
    if (fault || far) {
      in.fail(fault ? *fault : *far);
    }
    in.require(part.motion <= MotionKind::fixed, "the motion of a part is none");
    for (const GeometryId geometry : part.geometries) {
      const bool is_own = geometries_.contains(geometry) && geometries_.at(geometry).part == id;
      in.require(is_own && !is_listed[geometry.slot - 1], "a part has a geometry that is not its own");
      listed += is_own ? 1 : 0;
      if (is_own) {
        is_listed[geometry.slot - 1] = true;
      }
    }
  });
  in.require(listed == geometries_.size(), "a geometry is on no part");
  geometries_.for_each([&](GeometryId id, const Geometry& geometry) {
    const Fault fault = check_options(geometry.options, id.slot);
    const Fault far = check_far(geometry.options.local);
    if (fault || far) {
      in.fail(fault ? *fault : *far);
    }
    in.require(parts_.contains(geometry.part) && geometry.options.parking <= Parking::long_term &&
                   geometry.options.sweeping <= Sweeping::speculative,
               "the part, the parking or a flag of a geometry is none");
  });
}

// What the lists of changes say about parts and geometries.
void Scene::restore_changes(std::span<std::uint8_t> presences) {
  changes_.moved_parts = present_once<PartId>(changes_.moved_parts, parts_);
  for (const PartId part : changes_.moved_parts) {
    parts_.at(part).is_moved = true;
  }
  changes_.changed_geometries = present_once<GeometryId>(changes_.changed_geometries, geometries_);
  for (const GeometryId geometry : changes_.changed_geometries) {
    geometries_.at(geometry).is_changed = true;
  }
  std::vector<bool> is_fresh(presences.size());
  std::erase_if(changes_.fresh, [&](std::uint32_t at) {
    const bool is_again = is_fresh[at];
    is_fresh[at] = true;
    return is_again;
  });
  // Slots without a geometry have no seat, and those of pairs that the next detection ends are looked at by name.
  for (std::uint32_t at = 0; at < presences.size(); ++at) {
    presences[at] = geometries_.id_at_slot(at + 1).is_null() ? std::uint8_t{0} : presences[at];
  }
  changes_.are_slots_reused = true;
  parts_.for_each([&](PartId, const Part& part) { list_bytes_ += part.geometries.capacity() * sizeof(GeometryId); });
}

}  // namespace abut
