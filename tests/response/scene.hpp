// SPDX-License-Identifier: Apache-2.0
// A universe with bodies for tests.
#pragma once

#include <abut/response.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "world.hpp"

namespace response_test {

inline constexpr abut_quat no_turn{1, 0, 0, 0};

inline void require(abut_status status) { ASSERT_EQ(status, ABUT_OK) << abut_last_error_message(); }

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_response* response) const { abut_response_destroy(response); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Shape = std::unique_ptr<abut_shape, Delete>;

template <class Create>
Shape shape_from(const Create& create) {
  abut_shape* shape = nullptr;
  require(create(&shape));
  return Shape(shape);
}
inline Shape ball(double radius) {
  return shape_from([&](abut_shape** out) { return abut_sphere_create(radius, out); });
}
inline Shape block(double x, double y, double z) {
  return shape_from([&](abut_shape** out) { return abut_box_create(x, y, z, out); });
}
inline Shape ground(const abut_vec3& normal = {0, 0, 1}) {
  return shape_from([&](abut_shape** out) { return abut_plane_create(&normal, 0, out); });
}

// Contacts are reported from a gap of `margin` on, so that what rests stays in contact.
class Scene {
 public:
  explicit Scene(const std::function<void(abut_response_options&)>& change = {}, double margin = 1e-3)
      : margin_(margin) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
    abut_universe* made = nullptr;
    require(abut_universe_create(&options, &made));
    universe_.reset(made);
    abut_response_options its;
    abut_response_options_init(&its, sizeof its);
    if (change) change(its);
    abut_response* response = nullptr;
    require(abut_response_create(made, &its, &response));
    response_.reset(response);
  }

  [[nodiscard]] abut_universe* universe() const { return universe_.get(); }
  [[nodiscard]] abut_response* response() const { return response_.get(); }

  abut_part_id place(const Shape& shape, const abut_pose& pose, abut_motion motion) {
    abut_part_options options;
    abut_part_options_init(&options, sizeof options);
    options.pose = pose;
    options.motion = motion;
    abut_part_id part{};
    require(abut_part_create(universe(), &options, &part));
    attach(part, shape, {{0, 0, 0}, no_turn});
    return part;
  }
  abut_geometry_id attach(abut_part_id part, const Shape& shape, const abut_pose& local,
                          abut_geometry_flags flags = 0) {
    abut_geometry_options options;
    abut_geometry_options_init(&options, sizeof options);
    options.pose = local;
    options.flags = flags;
    options.tolerance = margin_;
    abut_geometry_id geometry{};
    require(abut_geometry_create(universe(), part, shape.get(), &options, &geometry));
    return geometry;
  }
  abut_part_id floor(const abut_vec3& normal = {0, 0, 1}) {
    return place(ground(normal), {{0, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  }
  // A body of a mass, with the inertia of its shape.
  abut_part_id body(const Shape& shape, const abut_pose& pose, double mass, const abut_velocity& velocity = {}) {
    const abut_part_id part = place(shape, pose, ABUT_MOTION_DYNAMIC);
    abut_mass_properties unit;
    require(abut_shape_mass_properties(shape.get(), 1, &unit));
    abut_body_options options;
    abut_body_options_init(&options, sizeof options);
    options.density = mass / unit.mass;
    require(abut_response_add_bodies(response(), &part, 1, &options));
    require(abut_part_set_velocity(universe(), part, &velocity));
    return part;
  }
  // Of all contacts.
  void material(const std::function<void(abut_contact_material&)>& change) {
    abut_contact_material row;
    abut_contact_material_init(&row, sizeof row);
    change(row);
    require(abut_material_pair_set(universe(), 0, 0, &row));
  }

  void step(double dt, int count = 1) {
    for (int i = 0; i < count; ++i) require(abut_response_step(response(), dt));
  }
  [[nodiscard]] abut_pose pose(abut_part_id part) const {
    abut_pose out{};
    require(abut_part_pose(universe(), part, &out));
    return out;
  }
  [[nodiscard]] abut_velocity velocity(abut_part_id part) const {
    abut_velocity out{};
    require(abut_part_velocity(universe(), part, &out, nullptr));
    return out;
  }
  [[nodiscard]] abut_energy energy() const {
    abut_energy out{};
    require(abut_response_energy(response(), &out));
    return out;
  }
  [[nodiscard]] std::span<const abut_response_contact> contacts() const {
    const abut_response_contact* first = nullptr;
    std::size_t count = 0;
    require(abut_response_contacts(response(), &first, &count));
    return {first, count};
  }
  [[nodiscard]] std::span<const abut_response_island> islands() const {
    const abut_response_island* first = nullptr;
    std::size_t count = 0;
    require(abut_response_islands(response(), &first, &count));
    return {first, count};
  }

 private:
  double margin_;
  std::unique_ptr<abut_universe, Delete> universe_;
  std::unique_ptr<abut_response, Delete> response_;
};

// Blocks and balls above each other, not quite in line.
inline std::vector<abut_part_id> drop_twelve(Scene& scene) {
  std::vector<abut_part_id> parts;
  for (int i = 0; i < 12; ++i) {
    const abut_pose pose{{0.3 * (i % 3), 0.2 * (i % 2), 1.0 + 1.3 * i}, no_turn};
    parts.push_back(scene.body(i % 2 == 0 ? block(0.4, 0.4, 0.4) : ball(0.5), pose, 1 + i % 4));
  }
  return parts;
}

inline double total_energy(const Scene& scene) { return scene.energy().kinetic + scene.energy().potential; }

}  // namespace response_test
