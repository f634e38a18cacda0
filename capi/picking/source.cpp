// SPDX-License-Identifier: Apache-2.0
#include "picking/source.hpp"

#include <abut/abut.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

import abut.picking;

namespace abut::capi {

UniverseShape::UniverseShape(abut_shape* shape) noexcept : shape_(shape) { abut_shape_retain(shape); }

std::string_view UniverseShape::kind() const {
  const char* const name = abut_shape_kind_name(abut_shape_kind_of(shape_.get()));
  return name == nullptr ? "" : name;
}

abut_status UniverseShape::bounds(const abut_pose& pose, abut_aabb& out) const {
  return abut_shape_aabb(shape_.get(), &pose, &out);
}

abut_status UniverseShape::triangle_count(std::size_t& out) const {
  std::size_t vertices = 0;
  out = 0;
  // Its triangles are near its surface, but rays meet that itself.
  if (kind() == "distance_field") return ABUT_OK;
  const std::string message = abut_last_error_message();
  const abut_status status = abut_shape_triangles(shape_.get(), nullptr, 0, &vertices, nullptr, 0, &out);
  if (status != ABUT_UNSUPPORTED) return status;
  // Nothing has failed for the caller, whose last message stays.
  abut_set_last_error(ABUT_OK, message.c_str());
  out = 0;
  return ABUT_OK;
}

abut_status UniverseShape::triangles(picking::TriangleList& out) const {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  if (const abut_status status = abut_shape_triangles(shape_.get(), nullptr, 0, &vertices, nullptr, 0, &triangles);
      status != ABUT_OK) {
    return status;
  }
  out.xyz.resize(3 * vertices);
  out.indices.resize(3 * triangles);
  return abut_shape_triangles(shape_.get(), out.xyz.data(), vertices, &vertices, out.indices.data(), triangles,
                              &triangles);
}

// The faces of a hull or a box have several triangles each. A ray at the middle of a triangle tells which face that is.
abut_status UniverseShape::faces(const picking::TriangleList& list, std::vector<std::uint32_t>& out) const {
  out.clear();
  if (kind() != "hull" && kind() != "box") return ABUT_OK;
  constexpr abut_pose unmoved{.position = {0, 0, 0}, .orientation = {1, 0, 0, 0}};
  for (std::size_t i = 0; i < list.indices.size() / 3; ++i) {
    const auto hit = cast(unmoved, picking::ray_at_triangle(list, i));
    out.push_back(hit ? hit->feature.index : (out.empty() ? 0 : out.back()));
  }
  return ABUT_OK;
}

std::optional<abut_ray_hit> UniverseShape::cast(const abut_pose& pose, const abut_ray& ray) const noexcept {
  abut_ray_hit hit;
  std::uint32_t found = 0;
  if (abut_shape_cast_ray(shape_.get(), &pose, &ray, &hit, &found) != ABUT_OK || found == 0) return std::nullopt;
  return hit;
}

std::optional<picking::RoundedSegment> UniverseShape::rounded() const {
  const std::string_view its = kind();
  if (its == "point") return picking::RoundedSegment{0, 0};
  if (its != "sphere" && its != "capsule" && its != "segment") return std::nullopt;
  std::size_t count = 0;
  if (abut_shape_parameters(shape_.get(), nullptr, 0, &count) != ABUT_OK) return std::nullopt;
  std::vector<double> parameters(count);
  if (abut_shape_parameters(shape_.get(), parameters.data(), count, &count) != ABUT_OK || parameters.empty())
    return std::nullopt;
  if (its == "segment") return picking::RoundedSegment{0, parameters[0]};
  return picking::RoundedSegment{parameters[0], parameters.size() > 1 ? parameters[1] : 0};
}

bool UniverseShape::overlaps(const abut_pose& pose, const picking::PickableShape& solid) const noexcept {
  constexpr abut_pose unmoved{.position = {0, 0, 0}, .orientation = {1, 0, 0, 0}};
  const abut_shape* const other = static_cast<const UniverseShape&>(solid).shape_.get();
  std::uint32_t found = 0;
  return abut_pair_overlaps(shape_.get(), &pose, other, &unmoved, nullptr, &found) == ABUT_OK && found != 0;
}

namespace {

// By which the universe tells it.
constexpr const char* extension_name = "picking";

}  // namespace

void Detach::operator()(const abut_universe* universe) const noexcept {
  // A universe that has failed keeps the count, and answers nothing about it any more.
  static_cast<void>(abut_universe_detach(universe, extension_name));
}

abut_status attach(const abut_universe* universe, Attachment& out) noexcept {
  const abut_status status = abut_universe_attach(universe, extension_name);
  if (status == ABUT_OK) out.reset(universe);
  return status;
}

abut_status borrow_counters(const abut_universe* universe, picking::Counters& out) noexcept {
  const std::uint64_t* geometries = nullptr;
  const std::uint64_t* poses = nullptr;
  const abut_status status = abut_universe_counters(universe, &geometries, &poses);
  out.geometries.reset(geometries);
  out.poses.reset(poses);
  return status;
}

abut_status UniverseSource::changes(std::uint64_t geometries, std::uint64_t poses, std::vector<abut_geometry_id>& out,
                                    bool& is_known) const {
  const abut_revision since{geometries, poses};
  std::size_t count = 0;
  std::uint32_t known = 0;
  out.resize(64);
  abut_status status = abut_universe_changes(universe_.get(), &since, out.data(), out.size(), &count, &known);
  if (status == ABUT_OK && count > out.size()) {
    out.resize(count);
    status = abut_universe_changes(universe_.get(), &since, out.data(), out.size(), &count, &known);
  }
  out.resize(status == ABUT_OK ? count : 0);
  is_known = known == 1;
  return status;
}

abut_status UniverseSource::geometries(std::vector<abut_geometry_id>& out) const {
  std::size_t count = 0;
  if (const abut_status status = abut_universe_geometries(universe_.get(), nullptr, 0, &count); status != ABUT_OK)
    return status;
  out.resize(count);
  return abut_universe_geometries(universe_.get(), out.data(), count, &count);
}

abut_status UniverseSource::describe(abut_geometry_id id, picking::GeometryView& out) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  if (const abut_status status = abut_geometry_describe(universe_.get(), id, &info); status != ABUT_OK) return status;
  out = {.shape_key = std::bit_cast<std::uintptr_t>(info.shape),
         .pose = info.pose,
         .traits = {info.layers, info.mask, info.part, (info.flags & ABUT_GEOMETRY_SENSOR) != 0},
         .is_parked = info.parking != ABUT_PARKING_NONE};
  return ABUT_OK;
}

abut_status UniverseSource::poses(std::span<const abut_geometry_id> ids, std::vector<abut_pose>& out) const {
  out.resize(ids.size());
  if (ids.empty()) return ABUT_OK;
  return abut_geometries_poses(universe_.get(), ids.data(), ids.size(), out.data());
}

abut_status UniverseSource::shape(abut_geometry_id id, std::unique_ptr<picking::PickableShape>& out) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  if (const abut_status status = abut_geometry_describe(universe_.get(), id, &info); status != ABUT_OK) return status;
  out = std::make_unique<UniverseShape>(info.shape);
  return ABUT_OK;
}

abut_status UniverseSource::half_space(const abut_vec3& normal, double offset,
                                       std::unique_ptr<picking::PickableShape>& out) const {
  abut_shape* made = nullptr;
  if (const abut_status status = abut_plane_create(&normal, offset, &made); status != ABUT_OK) return status;
  out = std::make_unique<UniverseShape>(std::unique_ptr<abut_shape, ShapeRelease>(made));
  return ABUT_OK;
}

abut_status UniverseSource::hull(std::span<const double> xyz, std::unique_ptr<picking::PickableShape>& out) const {
  abut_shape* made = nullptr;
  if (const abut_status status = abut_hull_create(xyz.data(), xyz.size() / 3, &made); status != ABUT_OK) return status;
  out = std::make_unique<UniverseShape>(std::unique_ptr<abut_shape, ShapeRelease>(made));
  return ABUT_OK;
}

}  // namespace abut::capi
