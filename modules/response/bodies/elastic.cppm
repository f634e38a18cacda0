// SPDX-License-Identifier: Apache-2.0
// Springs and tetrahedra between points of mass: their forces, and what these lose when the points move.
module;

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

export module abut.response:elastic;
import :vector;

export namespace abut::response {

struct Spring {
  std::uint32_t a = 0, b = 0;
  double rest = 0;  // length
  double stiffness = 0, damping = 0;
};

// An element of a material that is linear in the frame that turns with it (corotational).
struct Tetrahedron {
  std::array<std::uint32_t, 4> nodes{};
  Matrix inverse{};  // of the edges from the first node at rest, which are columns
  double volume = 0;
  double shear = 0, lame = 0;  // the two constants of Lame
  double damping = 0;          // seconds: viscous forces are those of a move through that time
};

// At some places: forces on the nodes, and the stiffness without what makes it indefinite.
struct ElasticForce {
  std::uint32_t count = 0;  // of nodes
  double energy = 0;
  std::array<abut_vec3, 4> forces{};
  std::array<double, 144> stiffness{};  // 3 * count rows and columns
};

// Nothing for corners in one plane.
[[nodiscard]] std::optional<Tetrahedron> tetrahedron_of(const std::array<std::uint32_t, 4>& nodes,
                                                        const std::array<abut_vec3, 4>& corners, double young,
                                                        double poisson, double damping);

[[nodiscard]] ElasticForce force_of(const Spring& spring, const std::array<abut_vec3, 4>& places);
[[nodiscard]] ElasticForce force_of(const Tetrahedron& element, const std::array<abut_vec3, 4>& places);
// What velocities lose by damping: the same shape as a stiffness, at the same places.
[[nodiscard]] std::array<double, 144> viscosity_of(const Spring& spring, const std::array<abut_vec3, 4>& places);
[[nodiscard]] std::array<double, 144> viscosity_of(const Tetrahedron& element, const ElasticForce& force);

}  // namespace abut::response
