// SPDX-License-Identifier: Apache-2.0
// Universes whose pairs are told by vertices, edges and faces.
#pragma once

#include "elements_oracle.hpp"

namespace abut_test {

inline abut_policy elements_policy(double reach, abut_closest_method method = ABUT_CLOSEST_FEATURES) {
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = reach;
  policy.method = method;
  return policy;
}
inline abut_universe_options margin_options(std::uint32_t threads = 1,
                                            abut_event_bits events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST) {
  abut_universe_options options = default_universe_options();
  options.events = events;
  options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
  options.threads = threads_of_build(threads);
  return options;
}
// A triangle that covers the origin, and one whose first corner points down to a place above it.
inline const Surface ground{{-1, -1, 0, 2, -1, 0, -1, 2, 0}, {0, 1, 2}};
inline Surface tip_at(double x, double y, double z) {
  return {{x, y, z, x + 0.2, y, z + 1, x, y + 0.2, z + 1}, {0, 1, 2}};
}
inline Surface shifted(Surface mesh, double x, double y, double z) {
  for (std::size_t i = 0; i < mesh.xyz.size(); i += 3) {
    mesh.xyz[i] += x;
    mesh.xyz[i + 1] += y;
    mesh.xyz[i + 2] += z;
  }
  return mesh;
}
inline Shape shape_of(const Surface& mesh) { return make_of_kind("mesh", {0}, mesh.xyz, mesh.triangles); }

// Meshes of tag 0, each on a part.
class Cloths {
 public:
  explicit Cloths(const abut_policy& policy, std::uint32_t threads = 1,
                  abut_event_bits events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST)
      : options_(margin_options(threads, events)), universe_(&options_) {
    set_policy(policy);
  }

  std::size_t add(const Surface& mesh, abut_geometry_flags flags = 0, const abut_pose& pose = identity,
                  abut_motion motion = ABUT_MOTION_DYNAMIC) {
    abut_geometry_options options = default_geometry_options();
    options.flags = flags;
    return add_on(universe_.add_part(pose, motion), mesh, options);
  }
  std::size_t add_on(abut_part_id part, const Surface& mesh, const abut_geometry_options& options) {
    parts_.push_back(part);
    const Shape shape = shape_of(mesh);
    geometries_.push_back(universe_.add_geometry(part, shape, options));
    return geometries_.size() - 1;
  }
  void set_policy(const abut_policy& policy) { require(abut_policy_set(universe_, 0, 0, &policy)); }
  void move(std::size_t which, const std::vector<double>& xyz) {
    require(abut_geometry_set_vertices(universe_, geometries_.at(which), 0, xyz.data(), xyz.size() / 3));
  }
  void step(double dt = 0.01) { require(abut_universe_step(universe_, dt)); }
  std::vector<abut_element_contact> contacts() const { return copy_of(abut_universe_element_contacts, universe_); }
  // Those of a pair; of one with itself twice the same number.
  std::vector<abut_stencil> stencils(std::size_t a, std::size_t b) const {
    std::vector<abut_stencil> out;
    for (const abut_element_contact& its : contacts()) {
      if (its.geometry_a == geometries_.at(a) && its.geometry_b == geometries_.at(b)) out.push_back(its.stencil);
    }
    return out;
  }

  Universe& universe() { return universe_; }
  abut_part_id part(std::size_t which) const { return parts_.at(which); }
  abut_geometry_id geometry(std::size_t which) const { return geometries_.at(which); }

 private:
  abut_universe_options options_;
  Universe universe_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
};

}  // namespace abut_test
