// SPDX-License-Identifier: Apache-2.0
// The world of a response, seen through abut.h.
#ifndef ABUT_CAPI_RESPONSE_SOURCE_HPP
#define ABUT_CAPI_RESPONSE_SOURCE_HPP

#include <abut/response.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

import abut.response;

namespace abut::capi {

/// A universe that an attachment keeps.
struct BorrowedUniverse {
  void operator()(abut_universe*) const noexcept {}
};
using UniversePointer = std::unique_ptr<abut_universe, BorrowedUniverse>;

/// That a response stands on a universe, which abut_universe_explain tells.
struct DetachResponse {
  void operator()(abut_universe* universe) const noexcept;
};
using ResponseAttachment = std::unique_ptr<abut_universe, DetachResponse>;
[[nodiscard]] abut_status attach_response(abut_universe* universe, ResponseAttachment& out) noexcept;

class ResponseSource final : public response::Source {
 public:
  explicit ResponseSource(abut_universe* universe) noexcept : universe_(universe) {}

  [[nodiscard]] abut_status detect(double dt) override;
  [[nodiscard]] abut_status contacts(std::vector<abut_contact>& out) const override;
  [[nodiscard]] abut_status element_contacts(std::vector<abut_element_contact>& out) const override;
  [[nodiscard]] abut_status contact_distance(abut_geometry_id a, abut_geometry_id b, double& out) const override;
  [[nodiscard]] abut_status skin(abut_geometry_id geometry, response::Skin& out) const override;
  [[nodiscard]] abut_status facts(abut_geometry_id geometry, response::GeometryFacts& out) const override;
  [[nodiscard]] abut_status material(std::uint32_t a, std::uint32_t b, abut_contact_material& out) const override;
  [[nodiscard]] bool has(abut_part_id part) const override;
  [[nodiscard]] bool has(abut_geometry_id geometry) const override;
  [[nodiscard]] abut_status geometries_of(abut_part_id part, std::vector<response::GeometryFacts>& out) const override;
  [[nodiscard]] abut_status is_dynamic(abut_part_id part, bool& out) const override;
  [[nodiscard]] abut_status has_margin(bool& out) const override;
  [[nodiscard]] abut_status move_particles(abut_geometry_id geometry, std::span<const double> xyz) override;
  [[nodiscard]] abut_status is_awake(abut_part_id part, bool& out) const override;
  [[nodiscard]] abut_status pose(abut_part_id part, abut_pose& out) const override;
  [[nodiscard]] abut_status velocity(abut_part_id part, abut_velocity& out) const override;
  [[nodiscard]] abut_status move(std::span<const abut_part_id> parts, std::span<const abut_pose> poses,
                                 std::span<const abut_velocity> velocities) override;
  [[nodiscard]] abut_status advance(std::span<const abut_part_id> parts, std::span<const abut_velocity> velocities,
                                    std::span<const abut_acceleration> accelerations, double time, double& fraction,
                                    bool& is_impact) override;
  [[nodiscard]] abut_status stop_accelerating(std::span<const abut_part_id> parts) override;

 private:
  [[nodiscard]] bool has_vertices(abut_geometry_id geometry) const;

  UniversePointer universe_;
};

/// Mass of all geometries of a part but sensors, in the frame of the part. Writes a message of its own where it fails.
[[nodiscard]] abut_status mass_of_part(const abut_universe* universe, abut_part_id part, double density,
                                       response::MassProperties& out);
/// Mass of a shape of density 1. Writes a message of its own where the shape has no volume.
[[nodiscard]] abut_status mass_of_shape(const abut_shape* shape, response::MassProperties& out);

}  // namespace abut::capi

#endif
