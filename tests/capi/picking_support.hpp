// SPDX-License-Identifier: Apache-2.0
// What the tests of the picker share: owners, shapes, and a universe with a picker.
#pragma once

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace picking_test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr abut_quat no_turn{1, 0, 0, 0};

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_picker* picker) const { abut_picker_destroy(picker); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Universe = std::unique_ptr<abut_universe, Delete>;
using PickerHandle = std::unique_ptr<abut_picker, Delete>;
using Shape = std::unique_ptr<abut_shape, Delete>;

inline abut_vec3 operator+(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline abut_vec3 operator-(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline abut_vec3 operator*(double s, const abut_vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }

template <class Create>
Shape shape_from(const Create& create) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(create(&shape), ABUT_OK) << abut_last_error_message();
  return Shape(shape);
}

inline Shape sphere(double radius) {
  return shape_from([&](abut_shape** out) { return abut_sphere_create(radius, out); });
}
inline Shape box(double x, double y, double z) {
  return shape_from([&](abut_shape** out) { return abut_box_create(x, y, z, out); });
}
inline Shape capsule(double radius, double half_height) {
  return shape_from([&](abut_shape** out) { return abut_capsule_create(radius, half_height, out); });
}
inline Shape plane(abut_vec3 normal, double offset) {
  return shape_from([&](abut_shape** out) { return abut_plane_create(&normal, offset, out); });
}
inline Shape mesh(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
  return shape_from([&](abut_shape** out) {
    return abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, out);
  });
}
inline Shape hull(const std::vector<double>& xyz) {
  return shape_from([&](abut_shape** out) { return abut_hull_create(xyz.data(), xyz.size() / 3, out); });
}

// A ball of triangles: a grid of longitudes and latitudes.
inline Shape ball_mesh(double radius, std::uint32_t count) {
  std::vector<double> xyz{0, 0, radius, 0, 0, -radius};
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t row = 1; row < count; ++row) {
    const double polar = std::numbers::pi * row / count;
    for (std::uint32_t column = 0; column < 2 * count; ++column) {
      const double azimuth = std::numbers::pi * column / count;
      xyz.insert(xyz.end(), {radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth),
                             radius * std::cos(polar)});
    }
  }
  const auto at = [&](std::uint32_t row, std::uint32_t column) {
    return 2 + (row - 1) * 2 * count + column % (2 * count);
  };
  for (std::uint32_t column = 0; column < 2 * count; ++column) {
    triangles.insert(triangles.end(), {0, at(1, column), at(1, column + 1)});
    for (std::uint32_t row = 1; row + 1 < count; ++row) {
      triangles.insert(triangles.end(), {at(row, column), at(row + 1, column), at(row + 1, column + 1)});
      triangles.insert(triangles.end(), {at(row, column), at(row + 1, column + 1), at(row, column + 1)});
    }
    triangles.insert(triangles.end(), {at(count - 1, column), 1, at(count - 1, column + 1)});
  }
  return mesh(xyz, triangles);
}

// Ground of count by count cells over [-half, half], with waves.
inline Shape ground_mesh(double half, std::uint32_t count, double wave) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j <= count; ++j) {
    for (std::uint32_t i = 0; i <= count; ++i) {
      const double x = half * (2.0 * i / count - 1);
      const double y = half * (2.0 * j / count - 1);
      xyz.insert(xyz.end(), {x, y, wave * std::sin(x) * std::cos(1.3 * y)});
    }
  }
  for (std::uint32_t j = 0; j < count; ++j) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = j * (count + 1) + i;
      triangles.insert(triangles.end(), {a, a + 1, a + count + 2, a, a + count + 2, a + count + 1});
    }
  }
  return mesh(xyz, triangles);
}

struct Placed {
  abut_geometry_id geometry;
  abut_part_id part;
};

class World {
 public:
  World() {
    abut_universe* universe = nullptr;
    EXPECT_EQ(abut_universe_create(nullptr, &universe), ABUT_OK);
    universe_.reset(universe);
    abut_picker* picker = nullptr;
    EXPECT_EQ(abut_picker_create(universe, &picker), ABUT_OK);
    picker_.reset(picker);
  }

  Placed add(const Shape& shape, const abut_vec3& position, const abut_quat& orientation = no_turn) {
    abut_part_options options;
    abut_part_options_init(&options, sizeof options);
    options.pose = {position, orientation};
    Placed placed{};
    EXPECT_EQ(abut_part_create(universe(), &options, &placed.part), ABUT_OK);
    EXPECT_EQ(abut_geometry_create(universe(), placed.part, shape.get(), nullptr, &placed.geometry), ABUT_OK);
    return placed;
  }
  void move(const Placed& placed, const abut_vec3& position, const abut_quat& orientation = no_turn) {
    const abut_pose pose{position, orientation};
    EXPECT_EQ(abut_part_set_pose(universe(), placed.part, &pose), ABUT_OK);
  }
  void remove(const Placed& placed) { EXPECT_EQ(abut_geometry_destroy(universe(), placed.geometry), ABUT_OK); }

  abut_pick pick(const abut_ray& ray, const abut_query_filter* filter = nullptr) {
    abut_pick pick{};
    EXPECT_EQ(abut_picker_cast_ray(picker(), &ray, filter, &pick), ABUT_OK) << abut_last_error_message();
    return pick;
  }
  std::vector<abut_pick> pick_all(const abut_ray& ray, const abut_query_filter* filter = nullptr) {
    std::size_t count = 0;
    EXPECT_EQ(abut_picker_cast_ray_all(picker(), &ray, filter, nullptr, 0, &count), ABUT_OK)
        << abut_last_error_message();
    std::vector<abut_pick> picks(count);
    EXPECT_EQ(abut_picker_cast_ray_all(picker(), &ray, filter, picks.data(), count, &count), ABUT_OK);
    EXPECT_EQ(count, picks.size());
    return picks;
  }

  // First hit over all geometries, each asked in double.
  abut_pick brute(const abut_ray& ray) const {
    std::size_t count = 0;
    EXPECT_EQ(abut_universe_geometries(universe_.get(), nullptr, 0, &count), ABUT_OK);
    std::vector<abut_geometry_id> ids(count);
    EXPECT_EQ(abut_universe_geometries(universe_.get(), ids.data(), count, &count), ABUT_OK);
    abut_pick best{{0, 0}, {0, 0}, 0, 0, infinity, {0, 0, 0}, {0, 0, 0}};
    for (const abut_geometry_id id : ids) {
      abut_geometry_info info;
      abut_geometry_info_init(&info, sizeof info);
      EXPECT_EQ(abut_geometry_describe(universe_.get(), id, &info), ABUT_OK);
      abut_ray_hit hit{};
      std::uint32_t found = 0;
      EXPECT_EQ(abut_shape_cast_ray(info.shape, &info.pose, &ray, &hit, &found), ABUT_OK);
      if (found != 0 && hit.distance < best.distance)
        best = {id, hit.feature, hit.child, 0, hit.distance, hit.point, hit.normal};
    }
    return best;
  }

  abut_universe* universe() { return universe_.get(); }
  abut_picker* picker() { return picker_.get(); }

 private:
  Universe universe_;
  PickerHandle picker_;
};

inline bool same(const abut_geometry_id& a, const abut_geometry_id& b) {
  return a.slot == b.slot && a.generation == b.generation;
}

inline constexpr abut_ray along_x{{-10, 0, 0}, {1, 0, 0}, infinity};

}  // namespace picking_test
