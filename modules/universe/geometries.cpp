module;
#include "../core/check.hpp"
module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;
import abut.universe.checks;
import abut.universe.pairs;
import abut.universe.room;

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
void Universe::change(GeometryId geometry) {
  infos_[geometry.slot - 1].patch = no_patch;
  enlist(geometry);
}

// Puts a geometry on the list of those that the next detection looks at.
void Universe::enlist(GeometryId geometry) {
  Geometry& its = geometries_.at(geometry);
  if (!its.is_changed) {
    its.is_changed = true;
    changed_geometries_.push_back(geometry);
  }
}

void Universe::leave_broadphase(std::uint32_t place) {
  if (presence_[place] != Presence::absent) {
    std::visit([&](auto& broadphase) { broadphase.erase(place); }, broadphase_);
    presence_[place] = Presence::absent;
    moving_count_ -= infos_[place].is_moving ? 1 : 0;
    is_broadphase_changed_ = true;
  }
}

// Short term it is hidden in the broad phase, long term it leaves it. Coming back waits for the next detection.
void Universe::settle_parking(GeometryId geometry, Parking parking) {
  Geometry& its = geometries_.at(geometry);
  const std::uint32_t place = geometry.slot - 1;
  const Parking before = std::exchange(its.options.parking, parking);
  if (parking == before) {
    return;
  }
  parked_count_ += (parking != Parking::none ? 1 : 0);
  parked_count_ -= (before != Parking::none ? 1 : 0);
  ++revision_.geometries;
  if (parking == Parking::none) {
    change(geometry);
  } else if (parking == Parking::long_term) {
    leave_broadphase(place);
  } else if (presence_[place] == Presence::shown) {
    std::visit([&](auto& broadphase) { broadphase.hide(place); }, broadphase_);
    presence_[place] = Presence::hidden;
    is_broadphase_changed_ = true;
  }
}

// Beside the pairs that the broad phase finds.
void Universe::set_self_pairs(std::uint32_t place, bool has_them) {
  if (infos_[place].has_self_pairs == has_them) {
    return;
  }
  const auto at = std::lower_bound(self_places_.begin(), self_places_.end(), place);
  if (has_them) {
    self_places_.insert(at, place);
  } else {
    self_places_.erase(at);
  }
  infos_[place].has_self_pairs = has_them;
  is_broadphase_changed_ = true;
}

// What pairs ask about a geometry, after its options have changed.
void Universe::apply_options(GeometryId geometry) {
  Geometry& its = geometries_.at(geometry);
  const GeometryOptions& options = its.options;
  PlaceInfo& info = infos_[geometry.slot - 1];
  its.local_pose = options.local.pose();
  info.layers = options.layers;
  info.mask = options.mask;
  info.exclusion = options.exclusion;
  info.tolerance = options.tolerance;
  info.generation = geometry.generation;
  info.part = its.part.slot;
  info.tag = options.tag;
  info.material = options.material;
  info.is_sensor = options.is_sensor;
  set_self_pairs(geometry.slot - 1, options.has_self_pairs);
  info.is_at_part = is_identity(options.local);
  info.is_box_stale = true;
  note(geometry.slot - 1, happened_to_filters);
}

Result<std::vector<GeometryId>> Universe::create_geometries(std::span<const PartId> parts,
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
    if (Fault fault = check_self_pairs(options[i], (*shapes[i]).index())) {
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
      shapes_.resize(std::max<std::size_t>(shapes_.size(), id.slot), vacant_);
      worlds_.resize(shapes_.size(), Pose::identity());
      boxes_.resize(shapes_.size());
      infos_.resize(shapes_.size());
      happened_.resize(shapes_.size());
      presence_.resize(shapes_.size());
      std::vector<GeometryId>& list = parts_.at(parts[i]).geometries;
      const std::size_t capacity_before = list.capacity();
      list.push_back(id);
      list_bytes_ += (list.capacity() - capacity_before) * sizeof(GeometryId);
      shapes_[id.slot - 1] = shapes[i];
      infos_[id.slot - 1] = {};
      happened_[id.slot - 1] = 0;
      infos_[id.slot - 1].kind = static_cast<std::uint8_t>((*shapes[i]).index());
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
  revision_.geometries += parts.empty() ? 0 : 1;
  return created;
}

// Takes a geometry out of everything but the list of its part.
void Universe::forget_geometry(GeometryId geometry) {
  const std::uint32_t place = geometry.slot - 1;
  if (place < presence_.size()) {
    leave_broadphase(place);
    set_self_pairs(place, false);
  }
  if (place < shapes_.size()) {
    shapes_[place] = vacant_;
  }
  if (!rules_.is_empty()) {
    rules_.forget({CollidableKind::geometry, geometry.slot, geometry.generation});
  }
  are_slots_reused_ = true;
  parked_count_ -= geometries_.at(geometry).options.parking != Parking::none ? 1 : 0;
  geometries_.erase(geometry);
}

Result<void> Universe::destroy_geometries(std::span<const GeometryId> geometries) {
  if (std::optional<Error> error = mark_all(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (const GeometryId geometry : geometries) {
    disturb(geometries_.at(geometry).part);
    std::erase(parts_.at(geometries_.at(geometry).part).geometries, geometry);
    forget_geometry(geometry);
  }
  revision_.geometries += geometries.size();
  return {};
}

Result<void> Universe::set_shapes(std::span<const GeometryId> geometries, std::span<const ShapeHandle> shapes) {
  ABUT_CHECK(geometries.size() == shapes.size());
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  make_room(changed_geometries_, geometries.size());
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const std::uint32_t place = geometries[i].slot - 1;
    shapes_[place] = shapes[i];
    infos_[place].kind = static_cast<std::uint8_t>((*shapes[i]).index());
    note(place, happened_to_shape);
    infos_[place].is_box_stale = true;
    change(geometries[i]);
    disturb(geometries_.at(geometries[i]).part);
  }
  revision_.geometries += geometries.empty() ? 0 : 1;
  return {};
}

Result<void> Universe::set_options(std::span<const GeometryId> geometries, std::span<const GeometryOptions> options) {
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
    if (Fault fault = check_self_pairs(options[i], infos_[geometries[i].slot - 1].kind)) {
      return Error{fault->code, name_at("options", i) + "." + fault->message};
    }
  }
  make_room(changed_geometries_, geometries.size());
  self_places_.reserve(self_places_.size() +
                       static_cast<std::size_t>(std::ranges::count_if(options, &GeometryOptions::has_self_pairs)));
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    settle_parking(geometries[i], options[i].parking);
    geometries_.at(geometries[i]).options = options[i];
    apply_options(geometries[i]);
    change(geometries[i]);
    disturb(geometries_.at(geometries[i]).part);
  }
  revision_.geometries += geometries.empty() ? 0 : 1;
  revision_.poses += geometries.empty() ? 0 : 1;
  return {};
}

Result<void> Universe::park(std::span<const GeometryId> geometries, Parking parking) {
  if (std::optional<Error> error = check_ids(geometries_, geometries, "geometries")) {
    return *error;
  }
  make_room(changed_geometries_, geometries.size());
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

Placement Universe::world_of(const Geometry& geometry) const {
  const Part& part = parts_.at(geometry.part);
  const Placement& local = geometry.options.local;
  return {part.placement.pose() * local.position, product(part.placement.orientation, local.orientation)};
}

Result<GeometryInfo> Universe::describe(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  const Geometry& its = geometries_.at(geometry);
  return GeometryInfo{its.part, shapes_[geometry.slot - 1], world_of(its), its.options};
}

Result<Placement> Universe::world_pose(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  return world_of(geometries_.at(geometry));
}

std::vector<GeometryId> Universe::geometries() const {
  std::vector<GeometryId> all;
  all.reserve(geometries_.size());
  geometries_.for_each([&](GeometryId id, const Geometry&) { all.push_back(id); });
  return all;
}

}  // namespace abut
