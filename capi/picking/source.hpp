// SPDX-License-Identifier: Apache-2.0
// The world of a picker, seen through abut.h.
#ifndef ABUT_CAPI_PICKING_SOURCE_HPP
#define ABUT_CAPI_PICKING_SOURCE_HPP

#include <abut/abut.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

import abut.picking;

namespace abut::capi {

/// Lets go of a shape.
struct ShapeRelease {
  void operator()(abut_shape* shape) const noexcept { abut_shape_release(shape); }
};

class UniverseShape final : public picking::PickableShape {
 public:
  /// Adds a reference of its own.
  explicit UniverseShape(abut_shape* shape) noexcept;
  /// Takes over a reference.
  explicit UniverseShape(std::unique_ptr<abut_shape, ShapeRelease> shape) noexcept : shape_(std::move(shape)) {}

  [[nodiscard]] abut_status bounds(const abut_pose& pose, abut_aabb& out) const override;
  [[nodiscard]] abut_status triangle_count(std::size_t& out) const override;
  [[nodiscard]] abut_status triangles(picking::TriangleList& out) const override;
  [[nodiscard]] abut_status faces(const picking::TriangleList& list, std::vector<std::uint32_t>& out) const override;
  [[nodiscard]] std::optional<abut_ray_hit> cast(const abut_pose& pose, const abut_ray& ray) const noexcept override;
  [[nodiscard]] std::optional<picking::RoundedSegment> rounded() const override;
  [[nodiscard]] bool overlaps(const abut_pose& pose, const picking::PickableShape& solid) const noexcept override;

 private:
  [[nodiscard]] std::string_view kind() const;

  std::unique_ptr<abut_shape, ShapeRelease> shape_;
};

/// That a picker stands on a universe, which abut_universe_explain tells.
struct Detach {
  void operator()(const abut_universe* universe) const noexcept;
};
using Attachment = std::unique_ptr<const abut_universe, Detach>;
[[nodiscard]] abut_status attach(const abut_universe* universe, Attachment& out) noexcept;

/// The change counters of a universe.
[[nodiscard]] abut_status borrow_counters(const abut_universe* universe, picking::Counters& out) noexcept;

class UniverseSource final : public picking::Source {
 public:
  explicit UniverseSource(const abut_universe* universe) noexcept : universe_(universe) {}

  [[nodiscard]] abut_status changes(std::uint64_t geometries, std::uint64_t poses, std::vector<abut_geometry_id>& out,
                                    bool& is_known) const override;
  [[nodiscard]] abut_status geometries(std::vector<abut_geometry_id>& out) const override;
  [[nodiscard]] abut_status describe(abut_geometry_id id, picking::GeometryView& out) const override;
  [[nodiscard]] abut_status poses(std::span<const abut_geometry_id> ids, std::vector<abut_pose>& out) const override;
  [[nodiscard]] abut_status shape(abut_geometry_id id, std::unique_ptr<picking::PickableShape>& out) const override;
  [[nodiscard]] abut_status half_space(const abut_vec3& normal, double offset,
                                       std::unique_ptr<picking::PickableShape>& out) const override;
  [[nodiscard]] abut_status hull(std::span<const double> xyz,
                                 std::unique_ptr<picking::PickableShape>& out) const override;

 private:
  std::unique_ptr<const abut_universe, picking::Borrowed> universe_;
};

}  // namespace abut::capi

#endif
