// SPDX-License-Identifier: Apache-2.0
// What a simulation asks of the world that it moves. One implementation stands on the C interface; a test may bring
// another one.
module;

#include <abut/response.h>

#include <cstdint>
#include <span>
#include <vector>

export module abut.response:source;

export namespace abut::response {

// What rules ask of a geometry.
struct GeometryFacts {
  abut_geometry_id geometry{};
  abut_part_id part{};
  std::uint32_t label = 0, tag = 0, material = 0;
  abut_geometry_flags flags = 0;
  double tolerance = 0;
};

// The triangles of a geometry, in the world. Vertices are three numbers each.
struct Skin {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  Source(Source&&) = delete;
  Source& operator=(Source&&) = delete;
  virtual ~Source() = default;

  // Finds contacts of the present poses, looking ahead by `dt` where geometries ask for it.
  [[nodiscard]] virtual abut_status detect(double dt) = 0;
  // Those of the last detection.
  [[nodiscard]] virtual abut_status contacts(std::vector<abut_contact>& out) const = 0;
  [[nodiscard]] virtual abut_status element_contacts(std::vector<abut_element_contact>& out) const = 0;
  // How far apart the surfaces of a pair are to stay, by its policy.
  [[nodiscard]] virtual abut_status contact_distance(abut_geometry_id a, abut_geometry_id b, double& out) const = 0;
  [[nodiscard]] virtual abut_status skin(abut_geometry_id geometry, Skin& out) const = 0;
  [[nodiscard]] virtual abut_status facts(abut_geometry_id geometry, GeometryFacts& out) const = 0;
  [[nodiscard]] virtual abut_status material(std::uint32_t a, std::uint32_t b, abut_contact_material& out) const = 0;
  // Whether the world has a part; false when it was destroyed.
  [[nodiscard]] virtual bool has(abut_part_id part) const = 0;
  // Whether a part is to be moved by forces now: dynamic, and not asleep.
  [[nodiscard]] virtual abut_status is_awake(abut_part_id part, bool& out) const = 0;
  [[nodiscard]] virtual abut_status pose(abut_part_id part, abut_pose& out) const = 0;
  [[nodiscard]] virtual abut_status velocity(abut_part_id part, abut_velocity& out) const = 0;
  // Poses and velocities of all parts or, where it fails, of none.
  [[nodiscard]] virtual abut_status move(std::span<const abut_part_id> parts, std::span<const abut_pose> poses,
                                         std::span<const abut_velocity> velocities) = 0;
  // Whether the world has a geometry; false when it was destroyed.
  [[nodiscard]] virtual bool has(abut_geometry_id geometry) const = 0;
  // Particles of a geometry, or vertices of its mesh, from the first one on; three numbers each, in the world.
  [[nodiscard]] virtual abut_status move_particles(abut_geometry_id geometry, std::span<const double> xyz) = 0;
  [[nodiscard]] virtual abut_status geometries_of(abut_part_id part, std::vector<GeometryFacts>& out) const = 0;
  [[nodiscard]] virtual abut_status is_dynamic(abut_part_id part, bool& out) const = 0;
  // Whether contacts begin before surfaces touch.
  [[nodiscard]] virtual abut_status has_margin(bool& out) const = 0;
  // Moves the world along its paths through `time`, or up to the first touch of fast geometries. `fraction` is the part
  // of the time that has passed.
  [[nodiscard]] virtual abut_status advance(std::span<const abut_part_id> parts,
                                            std::span<const abut_velocity> velocities,
                                            std::span<const abut_acceleration> accelerations, double time,
                                            double& fraction, bool& is_impact) = 0;
  [[nodiscard]] virtual abut_status stop_accelerating(std::span<const abut_part_id> parts) = 0;
};

}  // namespace abut::response
