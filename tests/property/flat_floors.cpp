// SPDX-License-Identifier: Apache-2.0
#include "flat_floors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace property {

namespace {

template <class Create, class... Arguments>
ShapePtr made(Create create, Arguments... arguments) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(create(arguments..., &shape), ABUT_OK) << abut_last_error_message();
  return ShapePtr(shape);
}

double support_of_points(const std::vector<Vec>& points, const Vec& n) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec& point : points) most = std::max(most, dot(point, n));
  return most;
}

}  // namespace

Body ball(double r) {
  return {"ball", made(abut_sphere_create, r), r, [=](const Vec& n) { return r * length(n); }};
}
Body capsule(const std::string& name, double r, double h) {
  return {name, made(abut_capsule_create, r, h), r, [=](const Vec& n) { return r * length(n) + h * std::abs(n[2]); }};
}
Body box(const std::string& name, double x, double y, double z) {
  return {name, made(abut_box_create, x, y, z), 0,
          [=](const Vec& n) { return x * std::abs(n[0]) + y * std::abs(n[1]) + z * std::abs(n[2]); }};
}
Body hull(const std::string& name, const std::vector<Vec>& points) {
  return {name, made(abut_hull_create, points[0].data(), points.size()), 0,
          [=](const Vec& n) { return support_of_points(points, n); }};
}

std::vector<Body> convex_bodies(Random& random) {
  std::vector<Body> all;
  all.push_back(ball(0.5));
  all.push_back(capsule("capsule", 0.5, 1));
  all.push_back(box("box", 0.5, 0.4, 0.3));
  all.push_back({"cylinder", made(abut_cylinder_create, 0.4, 0.6), 0,
                 [](const Vec& n) { return 0.4 * std::hypot(n[0], n[1]) + 0.6 * std::abs(n[2]); }});
  all.push_back({"cone", made(abut_cone_create, 0.5, 0.7), 0,
                 [](const Vec& n) { return std::max(0.5 * std::hypot(n[0], n[1]) - 0.7 * n[2], 0.7 * n[2]); }});
  all.push_back({"ellipsoid", made(abut_ellipsoid_create, 0.6, 0.4, 0.3), 0,
                 [](const Vec& n) { return length({0.6 * n[0], 0.4 * n[1], 0.3 * n[2]}); }});
  std::vector<Vec> points;
  for (int i = 0; i < 16; ++i) {
    const Vec p = vec(property::random_direction(random));
    points.push_back({0.6 * p[0], 0.5 * p[1], 0.4 * p[2]});
  }
  all.push_back(hull("hull", points));
  all.push_back({"point", made(abut_point_create), 0, [](const Vec&) { return 0.0; }});
  all.push_back({"segment", made(abut_segment_create, 0.8), 0, [](const Vec& n) { return 0.8 * std::abs(n[2]); }});
  const std::vector<Vec> corners{{0.7, 0, 0.1}, {-0.3, 0.6, 0}, {-0.4, -0.5, -0.2}};
  const abut_vec3 a{0.7, 0, 0.1}, b{-0.3, 0.6, 0}, c{-0.4, -0.5, -0.2};
  all.push_back({"triangle", made(abut_triangle_create, &a, &b, &c), 0,
                 [=](const Vec& n) { return support_of_points(corners, n); }});
  all.push_back(box("plate of aspect 100", 1, 0.75, 0.01));
  all.push_back(box("rod of aspect 1000", 1, 0.001, 0.001));
  all.push_back(capsule("thin capsule", 0.01, 1));
  all.push_back({"disc of aspect 1000", made(abut_cylinder_create, 1.0, 0.001), 0,
                 [](const Vec& n) { return std::hypot(n[0], n[1]) + 0.001 * std::abs(n[2]); }});
  return all;
}

std::string text_of(const FlatFloor& floor) {
  const char* const kinds[] = {"mesh", "uv_grid", "height field"};
  return std::string(kinds[static_cast<int>(floor.kind)]) + ", sides " + std::to_string(floor.sides) + ", " +
         std::to_string(floor.cells) + " cells, damage " + std::to_string(static_cast<int>(floor.damage)) +
         (floor.as_float ? ", as float" : "") + (floor.shuffled ? ", shuffled" : "");
}

ShapePtr mesh_of(const std::vector<Vec>& vertices, const std::vector<std::uint32_t>& triangles, FloorKind kind,
                 abut_sides sides) {
  abut_shape* shape = nullptr;
  if (kind == FloorKind::mesh) {
    abut_mesh_options options;
    abut_mesh_options_init(&options, sizeof options);
    options.sides = sides;
    EXPECT_EQ(
        abut_mesh_create(vertices[0].data(), vertices.size(), triangles.data(), triangles.size() / 3, &options, &shape),
        ABUT_OK);
  } else {
    abut_uv_grid_options options;
    abut_uv_grid_options_init(&options, sizeof options);
    options.sides = sides;
    EXPECT_EQ(abut_uv_grid_create(vertices[0].data(), vertices.size(), triangles.data(), triangles.size() / 3, &options,
                                  &shape),
              ABUT_OK);
  }
  return ShapePtr(shape);
}

ShapePtr field_of(std::uint32_t columns, double spacing, const std::vector<double>& heights, abut_below below) {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = columns;
  desc.rows = static_cast<std::uint32_t>(heights.size() / columns);
  desc.spacing_x = desc.spacing_y = spacing;
  desc.heights = heights.data();
  desc.diagonal = ABUT_DIAGONAL_ALTERNATING;
  desc.below = below;
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_height_field_create(&desc, &shape), ABUT_OK);
  return ShapePtr(shape);
}

namespace {

// A height field lies where its frame puts it: only its slope is taken from `frame`.
Ground field_ground(const FlatFloor& floor, Random& random) {
  const double spacing = 2 * floor.size / floor.cells;
  const double slope_x = between(random, -0.5, 0.5), slope_y = between(random, -0.5, 0.5);
  std::vector<double> heights;
  for (std::uint32_t j = 0; j <= floor.cells; ++j) {
    for (std::uint32_t i = 0; i <= floor.cells; ++i) {
      const double height = slope_x * (i * spacing) + slope_y * (j * spacing);
      heights.push_back(floor.as_float ? static_cast<double>(static_cast<float>(height)) : height);
    }
  }
  const double size = length({-slope_x, -slope_y, 1});
  return {field_of(floor.cells + 1, spacing, heights, ABUT_BELOW_OPEN),
          {},
          {-slope_x / size, -slope_y / size, 1 / size},
          0,
          floor.as_float ? 1e-6 : 1e-14};
}

}  // namespace

Ground ground_of(const FlatFloor& floor, Random& random) {
  if (floor.kind == FloorKind::height_field) return field_ground(floor, random);
  const std::uint32_t side = floor.cells + 1;
  std::vector<Vec> vertices;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const double step = 2 * floor.size / floor.cells;
      Vec p = placed(floor.frame, {i * step - floor.size, j * step - floor.size, 0});
      if (floor.as_float) {
        for (double& coordinate : p) coordinate = static_cast<double>(static_cast<float>(coordinate));
      }
      vertices.push_back(p);
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t j = 0; j < floor.cells; ++j) {
    for (std::uint32_t i = 0; i < floor.cells; ++i) {
      const std::uint32_t a = j * side + i, b = a + 1, c = a + side, d = c + 1;
      if (floor.damage == FloorDamage::no_area && random() % 4 == 0) {
        triangles.push_back({a, a, d});
      }
      if (floor.damage == FloorDamage::slivers && random() % 4 == 0) {
        // The diagonal is there twice, with a triangle between.
        const auto middle = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(times(0.5, plus(vertices[a], vertices[d])));
        triangles.insert(triangles.end(), {{a, b, d}, {a, d, middle}, {a, middle, c}, {middle, d, c}});
        continue;
      }
      if ((i + j) % 2 == 0) {
        triangles.insert(triangles.end(), {{a, b, d}, {a, d, c}});
      } else {
        triangles.insert(triangles.end(), {{a, b, c}, {b, d, c}});
      }
    }
  }
  if (floor.shuffled) {
    std::shuffle(triangles.begin(), triangles.end(), random);
    for (auto& triangle : triangles) {
      std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(random() % 3), triangle.end());
    }
  }
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  const Vec normal = turned(floor.frame.orientation, {0, 0, 1});
  ShapePtr shape = mesh_of(vertices, indices, floor.kind, floor.sides);
  return {std::move(shape), vertices, normal, dot(normal, vec(floor.frame.position)), floor.as_float ? 1e-6 : 1e-13};
}

std::vector<FlatFloor> flat_floors(Random& random) {
  std::vector<FlatFloor> all;
  for (const FloorKind kind : {FloorKind::mesh, FloorKind::uv_grid}) {
    for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
      for (const std::uint32_t cells : {1u, 4u, 20u, 80u}) {
        for (const bool is_turned : {false, true}) {
          FlatFloor floor{kind, sides, cells};
          if (is_turned) floor.frame = {{0.3, -0.2, 0.1}, random_orientation(random)};
          if (is_turned && kind == FloorKind::uv_grid) floor.frame.orientation = unit(1, 0.2, 0.1, 0.3);
          floor.shuffled = is_turned;
          all.push_back(floor);
        }
      }
      for (const FloorDamage damage : {FloorDamage::no_area, FloorDamage::slivers}) {
        FlatFloor floor{kind, sides, 20};
        floor.damage = damage;
        all.push_back(floor);
      }
      FlatFloor rounded{kind, sides, 20};
      rounded.frame = {{0.3, -0.2, 0.1}, unit(1, 0.2, 0.1, 0.3)};
      rounded.as_float = rounded.shuffled = true;
      all.push_back(rounded);
    }
  }
  for (const bool as_float : {false, true}) {
    FlatFloor field{FloorKind::height_field, ABUT_SIDES_FRONT, 20};
    field.as_float = as_float;
    all.push_back(field);
  }
  return all;
}

}  // namespace property
