module;
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>
#include "../core/check.hpp"
module abut.universe;
import abut.any_shape;
import abut.core;
import abut.math;
import abut.registry;
import abut.shape;

namespace abut {
namespace {

// Distinct for up to 2^32 universes, and far apart for neighbours (Knuth's multiplicative hash).
std::uint32_t first_generation(std::uint32_t number, std::uint32_t salt) {
  constexpr std::uint64_t golden = 0x9e3779b1;
  return static_cast<std::uint32_t>((number * golden + salt) & 0xffffffff);
}

std::string name_at(std::string_view array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

Error stale(const std::string& name) { return {Errc::stale_id, name + " is stale or belongs to another universe"}; }

Fault check_placement(const Placement& placement, std::string_view array, std::size_t index) {
  const auto [w, x, y, z] = placement.orientation;
  const Real square = w * w + x * x + y * y + z * z;
  if (!is_finite(placement.position) || !std::isfinite(square)) {
    return Error{Errc::not_finite, name_at(array, index) + " has a NaN or an infinity in it; it must be finite"};
  }
  // Twice the relative error of a length that is off by 1e-3.
  if (!(std::fabs(square - 1) <= 2.001e-3)) {
    return Error{Errc::not_unit, name_at(array, index) + " has an orientation of length " + to_text(std::sqrt(square)) +
                                     "; it must be 1 within 1e-3"};
  }
  return std::nullopt;
}

Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

// Marks each value of a batch that is to be erased. The first id that is stale, or named before,
// takes all marks off again.
template <class Map, class Id>
std::optional<Error> mark_all(Map& map, std::span<const Id> ids, std::string_view array) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!map.contains(ids[i]) || map.at(ids[i]).is_marked) {
      for (const Id& id : ids.first(i)) {
        map.at(id).is_marked = false;
      }
      return stale(name_at(array, i));
    }
    map.at(ids[i]).is_marked = true;
  }
  return std::nullopt;
}

}  // namespace

Universe::Universe(const UniverseOptions& options, std::uint32_t number)
    : options_(options),
      parts_(first_generation(number, 1)),
      geometries_(first_generation(number, 0x80000001)),
      vacant_(AnyShape(Shapes::At<0>::samples().front())) {}

Result<std::vector<PartId>> Universe::create_parts(std::span<const PartOptions> options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_placement(options[i].placement, "options", i)) {
      return *fault;
    }
  }
  std::vector<PartId> created;
  created.reserve(options.size());
  try {
    for (const PartOptions& part : options) {
      created.push_back(parts_.insert({.placement = part.placement,
                                       .pose = part.placement.pose(),
                                       .user_data = part.user_data,
                                       .motion = part.motion,
                                       .geometries = {}}));
    }
  } catch (...) {
    for (const PartId part : created) {
      parts_.erase(part);
    }
    throw;
  }
  return created;
}

Result<void> Universe::destroy_parts(std::span<const PartId> parts) {
  if (std::optional<Error> error = mark_all(parts_, parts, "parts")) {
    return *error;
  }
  for (const PartId part : parts) {
    for (const GeometryId geometry : parts_.at(part).geometries) {
      forget_geometry(geometry);
    }
    list_bytes_ -= parts_.at(part).geometries.capacity() * sizeof(GeometryId);
    parts_.erase(part);
  }
  return {};
}

Result<void> Universe::set_poses(std::span<const PartId> parts, std::span<const Placement> poses) {
  ABUT_CHECK(parts.size() == poses.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts_.contains(parts[i])) {
      return stale(name_at("parts", i));
    }
    if (Fault fault = check_placement(poses[i], "poses", i)) {
      return *fault;
    }
  }
  moved_parts_.reserve(moved_parts_.size() + parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts_.at(parts[i]);
    part.placement = poses[i];
    part.pose = poses[i].pose();
    if (!part.is_moved) {
      part.is_moved = true;
      moved_parts_.push_back(parts[i]);
    }
  }
  revision_.poses += parts.empty() ? 0 : 1;
  return {};
}

Result<Placement> Universe::pose(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).placement;
}

Result<std::uint64_t> Universe::user_data(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).user_data;
}

Result<std::vector<GeometryId>> Universe::geometries_of(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).geometries;
}

Result<std::vector<GeometryId>> Universe::create_geometries(std::span<const PartId> parts, std::span<const ShapeHandle> shapes,
                                                            std::span<const GeometryOptions> options) {
  ABUT_CHECK(parts.size() == shapes.size() && (options.empty() || options.size() == parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts_.contains(parts[i])) {
      return stale(name_at("parts", i));
    }
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_placement(options[i].local, "options", i)) {
      return *fault;
    }
    if (Fault fault = check_not_negative("tolerance", options[i].tolerance)) {
      return Error{fault->code, name_at("options", i) + "." + fault->message};
    }
  }
  std::vector<GeometryId> created;
  created.reserve(parts.size());
  try {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const GeometryOptions& option = options.empty() ? GeometryOptions{} : options[i];
      const GeometryId id = geometries_.insert({.part = parts[i],
                                                .local = option.local,
                                                .local_pose = option.local.pose(),
                                                .user_data = option.user_data});
      created.push_back(id);
      shapes_.resize(std::max<std::size_t>(shapes_.size(), id.slot), vacant_);
      worlds_.resize(shapes_.size(), Pose::identity());
      boxes_.resize(shapes_.size());
      tolerances_.resize(shapes_.size());
      kinds_.resize(shapes_.size());
      in_broadphase_.resize(shapes_.size());
      new_geometries_.push_back(id);
      std::vector<GeometryId>& list = parts_.at(parts[i]).geometries;
      list_bytes_ -= list.capacity() * sizeof(GeometryId);
      list.push_back(id);
      list_bytes_ += list.capacity() * sizeof(GeometryId);
      shapes_[id.slot - 1] = shapes[i];
      tolerances_[id.slot - 1] = option.tolerance;
      kinds_[id.slot - 1] = static_cast<std::uint8_t>((*shapes[i]).index());
    }
  } catch (...) {
    for (const GeometryId geometry : created) {
      std::erase(parts_.at(geometries_.at(geometry).part).geometries, geometry);
      forget_geometry(geometry);
    }
    throw;
  }
  revision_.geometries += parts.empty() ? 0 : 1;
  return created;
}

// Takes a geometry out of everything but the list of its part.
void Universe::forget_geometry(GeometryId geometry) {
  const std::uint32_t proxy = geometry.slot - 1;
  if (proxy < in_broadphase_.size() && in_broadphase_[proxy] != 0) {
    std::visit([&](auto& broadphase) { broadphase.erase(proxy); }, broadphase_);
    in_broadphase_[proxy] = 0;
  }
  if (proxy < shapes_.size()) {
    shapes_[proxy] = vacant_;
  }
  geometries_.erase(geometry);
  ++revision_.geometries;
}

Result<void> Universe::destroy_geometries(std::span<const GeometryId> geometries) {
  if (std::optional<Error> error = mark_all(geometries_, geometries, "geometries")) {
    return *error;
  }
  for (const GeometryId geometry : geometries) {
    std::erase(parts_.at(geometries_.at(geometry).part).geometries, geometry);
    forget_geometry(geometry);
  }
  return {};
}

Placement Universe::world_of(const Geometry& geometry) const {
  const Part& part = parts_.at(geometry.part);
  return {part.pose * geometry.local.position, product(part.placement.orientation, geometry.local.orientation)};
}

Result<GeometryInfo> Universe::describe(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  const Geometry& its = geometries_.at(geometry);
  const std::size_t place = geometry.slot - 1;
  return GeometryInfo{its.part, shapes_[place], world_of(its), its.local, tolerances_[place], its.user_data};
}

Result<Placement> Universe::world_pose(GeometryId geometry) const {
  if (!geometries_.contains(geometry)) {
    return stale("geometry");
  }
  return world_of(geometries_.at(geometry));
}

std::vector<PartId> Universe::parts() const {
  std::vector<PartId> all;
  all.reserve(parts_.size());
  parts_.for_each([&](PartId id, const Part&) { all.push_back(id); });
  return all;
}

std::vector<GeometryId> Universe::geometries() const {
  std::vector<GeometryId> all;
  all.reserve(geometries_.size());
  geometries_.for_each([&](GeometryId id, const Geometry&) { all.push_back(id); });
  return all;
}

std::size_t Universe::bytes() const {
  const std::size_t per_geometry = shapes_.capacity() * sizeof(ShapeHandle) + worlds_.capacity() * sizeof(Pose) +
                                   boxes_.capacity() * sizeof(CompactAabb) + tolerances_.capacity() * sizeof(Real) +
                                   kinds_.capacity() + in_broadphase_.capacity();
  const std::size_t changes = moved_parts_.capacity() * sizeof(PartId) + new_geometries_.capacity() * sizeof(GeometryId) +
                              fresh_.capacity() * sizeof(std::uint32_t);
  const std::size_t results = pairs_.capacity() * sizeof(ProxyPair) + runs_.bytes() + results_.capacity() * sizeof(PairResult) +
                              manifold_.capacity() * sizeof(ContactPoint) + (contacts_.capacity() + contacts_before_.capacity()) * sizeof(Contact) +
                              ids_before_.capacity() * sizeof(std::uint64_t);
  const std::size_t broadphase = std::visit([](const auto& its) { return its.bytes(); }, broadphase_);
  return sizeof(Universe) + parts_.bytes() + geometries_.bytes() + list_bytes_ + per_geometry + changes + results + broadphase;
}

}  // namespace abut
