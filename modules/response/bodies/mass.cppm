// SPDX-License-Identifier: Apache-2.0
// How heavy solids are, and how hard they are to turn.
module;

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

export module abut.response:mass;
import :vector;

export namespace abut::response {

struct MassProperties {
  double mass = 0;
  abut_vec3 centre{};  // of mass
  Matrix inertia{};    // about the centre, symmetric
};

// Solids of density 1, in the frame of their shape.
[[nodiscard]] MassProperties ellipsoid_mass(const abut_vec3& radii);
[[nodiscard]] MassProperties box_mass(const abut_vec3& half_extents);
[[nodiscard]] MassProperties cylinder_mass(double radius, double half_height);
[[nodiscard]] MassProperties capsule_mass(double radius, double half_height);
// The base at -half_height.
[[nodiscard]] MassProperties cone_mass(double radius, double half_height);
// What closed triangles enclose; nothing where an edge has no partner the other way round, or the volume is not
// positive.
[[nodiscard]] std::optional<MassProperties> enclosed_mass(std::span<const double> xyz,
                                                          std::span<const std::uint32_t> triangles);

[[nodiscard]] MassProperties scaled(const MassProperties& mass, double density);
[[nodiscard]] MassProperties placed(const MassProperties& mass, const abut_pose& pose);
// Of several together.
[[nodiscard]] MassProperties combined(std::span<const MassProperties> masses);

}  // namespace abut::response
