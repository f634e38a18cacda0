// SPDX-License-Identifier: Apache-2.0
// What the tests of the names of SOFA share: owners, small scenes, and lists of answers.
#pragma once

#include <abut/abut.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace sofa_names {

inline void require(abut_status status) { ASSERT_EQ(status, ABUT_OK) << abut_last_error_message(); }

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
  void operator()(abut_elements* elements) const { abut_elements_destroy(elements); }
};
using Shape = std::unique_ptr<abut_shape, Delete>;
using Elements = std::unique_ptr<abut_elements, Delete>;

// Of a create function and its arguments before the out-parameter.
template <class... Parameters, class... Arguments>
Shape make(abut_status (*create)(Parameters...), const Arguments&... arguments) {
  abut_shape* shape = nullptr;
  require(create(arguments..., &shape));
  return Shape(shape);
}
template <class Value>
Value filled_by(void (*init)(Value*, std::uint32_t)) {
  Value value;
  init(&value, sizeof value);
  return value;
}
// A list that is lent, or filled in after it was counted.
template <class Value, class Object>
std::span<const Value> list(abut_status (*lend)(const Object*, const Value**, std::size_t*), const Object* object) {
  const Value* first = nullptr;
  std::size_t count = 0;
  require(lend(object, &first, &count));
  return {first, count};
}
template <class Value>
std::vector<Value> found(abut_status (*ask)(abut_elements*, abut_elements*, const abut_elements_options*, Value*,
                                            std::size_t, std::size_t*),
                         const Elements& a, const Elements& b, const abut_elements_options& options) {
  std::size_t count = 0;
  require(ask(a.get(), b.get(), &options, nullptr, 0, &count));
  std::vector<Value> out(count);
  require(ask(a.get(), b.get(), &options, out.data(), out.size(), &count));
  return out;
}

constexpr abut_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

inline Shape ball(double radius) { return make(abut_sphere_create, radius); }
inline Shape block(double half) { return make(abut_box_create, half, half, half); }
inline Shape mesh_of(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles,
                     abut_sides sides = ABUT_SIDES_BOTH) {
  auto options = filled_by(abut_mesh_options_init);
  options.sides = sides;
  return make(abut_mesh_create, xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3,
              static_cast<const abut_mesh_options*>(&options));
}
// Two triangles at z = 0, from -1 to 1, with the diagonal from (-1, -1) to (1, 1).
inline const std::vector<double> square_xyz{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
inline const std::vector<std::uint32_t> square_triangles{0, 1, 2, 0, 2, 3};
inline Shape square(abut_sides sides = ABUT_SIDES_BOTH) { return mesh_of(square_xyz, square_triangles, sides); }
// Right-angled, with legs of 1 along the axes; wound with the outside in front.
inline const std::vector<double> corner_xyz{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<std::uint32_t> corner_triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
// A triangle whose first corner points down to (x, y, z).
inline Shape tip(double x, double y, double z) {
  return mesh_of({x, y, z, x + 0.3, y, z + 1, x, y + 0.3, z + 1}, {0, 1, 2});
}

inline Elements elements_of(const Shape& shape) {
  abut_elements* elements = nullptr;
  require(abut_elements_create(shape.get(), &elements));
  return Elements(elements);
}
inline abut_elements_options within(double reach, abut_closest_method method = ABUT_CLOSEST_FEATURES) {
  auto options = filled_by(abut_elements_options_init);
  options.reach = reach;
  options.method = method;
  return options;
}
inline std::vector<abut_stencil> closest(const Elements& a, const Elements& b, const abut_elements_options& options) {
  return found(abut_elements_closest, a, b, options);
}
inline std::size_t count_of(std::span<const abut_stencil> stencils, abut_stencil_kind kind) {
  std::size_t count = 0;
  for (const abut_stencil& its : stencils) count += its.kind == kind ? 1 : 0;
  return count;
}
inline Elements nothing() { return {}; }

// A universe that reports what comes near.
class World {
 public:
  explicit World(abut_universe_options options = filled_by(abut_universe_options_init)) {
    options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
    abut_universe* made = nullptr;
    require(abut_universe_create(&options, &made));
    universe_.reset(made);
  }
  [[nodiscard]] abut_universe* get() const { return universe_.get(); }

  abut_part_id part(const abut_pose& pose, abut_motion motion = ABUT_MOTION_DYNAMIC) {
    auto options = filled_by(abut_part_options_init);
    options.pose = pose;
    options.motion = motion;
    abut_part_id out{};
    require(abut_part_create(get(), &options, &out));
    return out;
  }
  abut_geometry_id put(abut_part_id on, const Shape& shape, abut_geometry_options options) {
    abut_geometry_id out{};
    require(abut_geometry_create(get(), on, shape.get(), &options, &out));
    return out;
  }
  abut_geometry_id put(abut_part_id on, const Shape& shape, double tolerance = 0) {
    auto options = filled_by(abut_geometry_options_init);
    options.tolerance = tolerance;
    return put(on, shape, options);
  }
  // On a part of its own.
  abut_geometry_id add(const Shape& shape, const abut_pose& pose, double tolerance = 0,
                       abut_motion motion = ABUT_MOTION_DYNAMIC) {
    return put(part(pose, motion), shape, tolerance);
  }
  void move(abut_part_id which, const abut_pose& pose) { require(abut_part_set_pose(get(), which, &pose)); }
  std::span<const abut_contact> step(double dt = 0.01) {
    require(abut_universe_step(get(), dt));
    return list(abut_universe_contacts, static_cast<const abut_universe*>(get()));
  }
  [[nodiscard]] std::span<const abut_element_contact> element_contacts() const {
    return list(abut_universe_element_contacts, static_cast<const abut_universe*>(get()));
  }
  [[nodiscard]] std::span<const abut_event> events() const {
    return list(abut_universe_events, static_cast<const abut_universe*>(get()));
  }
  [[nodiscard]] abut_step_stats stats() const {
    auto out = filled_by(abut_step_stats_init);
    require(abut_universe_stats(get(), &out));
    return out;
  }
  [[nodiscard]] std::uint64_t hash() const {
    std::uint64_t out = 0;
    require(abut_universe_hash(get(), &out));
    return out;
  }

 private:
  std::unique_ptr<abut_universe, Delete> universe_;
};

}  // namespace sofa_names
