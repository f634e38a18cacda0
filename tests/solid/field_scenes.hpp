// SPDX-License-Identifier: Apache-2.0
// Solid height fields with holes, the same solids as meshes, and bodies near their sides and floors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solids.hpp"

namespace solid {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::uint32_t below(std::uint32_t count) {
    return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(random_);
  }
  abut_vec3 direction() {
    for (;;) {
      const abut_vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      const double square = v.x * v.x + v.y * v.y + v.z * v.z;
      if (square > 0.01 && square < 1)
        return {v.x / std::sqrt(square), v.y / std::sqrt(square), v.z / std::sqrt(square)};
    }
  }
  abut_quat turn() {
    const abut_vec3 axis = direction();
    const double half = between(0, 3.14159);
    return {std::cos(half), std::sin(half) * axis.x, std::sin(half) * axis.y, std::sin(half) * axis.z};
  }

 private:
  std::mt19937_64 random_;
};

// The heights of a field, and which way its cells are cut.
struct Ground {
  std::uint32_t columns, rows;
  double spacing_x, spacing_y;
  abut_diagonal diagonal;
  std::vector<double> heights;

  [[nodiscard]] double floor() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const double height : heights) lowest = std::fmin(lowest, height);
    return lowest - std::fmax((columns - 1) * spacing_x, (rows - 1) * spacing_y);
  }
  [[nodiscard]] bool is_falling(std::uint32_t i, std::uint32_t j) const {
    return diagonal == ABUT_DIAGONAL_FALLING || (diagonal == ABUT_DIAGONAL_ALTERNATING && (i + j) % 2 == 1);
  }
};

inline ShapePtr field_of(const Ground& ground, abut_below below = ABUT_BELOW_SOLID) {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = ground.columns;
  desc.rows = ground.rows;
  desc.spacing_x = ground.spacing_x;
  desc.spacing_y = ground.spacing_y;
  desc.diagonal = ground.diagonal;
  desc.heights = ground.heights.data();
  desc.below = below;
  return made([&](abut_shape** out) { return abut_height_field_create(&desc, out); });
}

// The same solid as a closed mesh: what is below each triangle of the ground, down to the floor. Sides are cut the
// other way round than those of the library.
inline test::Surface prism_of(const Ground& ground) {
  test::Surface out;
  const std::uint32_t all = ground.columns * ground.rows;
  for (const bool is_floor : {false, true}) {
    for (std::uint32_t place = 0; place < all; ++place) {
      const double height = is_floor || std::isnan(ground.heights[place]) ? ground.floor() : ground.heights[place];
      out.xyz.insert(out.xyz.end(),
                     {place % ground.columns * ground.spacing_x, place / ground.columns * ground.spacing_y, height});
    }
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (std::isnan(ground.heights[a] + ground.heights[b] + ground.heights[c])) return;
    out.triangles.insert(out.triangles.end(), {a, b, c, all + b, all + a, all + c});
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[edge];
  };
  for (std::uint32_t j = 0; j + 1 < ground.rows; ++j) {
    for (std::uint32_t i = 0; i + 1 < ground.columns; ++i) {
      const std::uint32_t a = j * ground.columns + i, b = a + 1, c = a + ground.columns, d = c + 1;
      if (ground.is_falling(i, j)) {
        add(a, b, c);
        add(b, d, c);
      } else {
        add(a, b, d);
        add(a, d, c);
      }
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto& [from, to] = edge;
    if (!edges.contains({to, from})) {
      out.triangles.insert(out.triangles.end(), {from, all + from, to, to, all + from, all + to});
    }
  }
  return out;
}

inline Ground random_ground(Numbers& numbers) {
  Ground ground{2 + numbers.below(6),      2 + numbers.below(6), numbers.between(0.5, 1.5),
                numbers.between(0.5, 1.5), numbers.below(3),     {}};
  const double steep = std::array{0.0, 0.3, 1.5}[numbers.below(3)],
               share = std::array{0.0, 0.1, 0.25}[numbers.below(3)];
  const double level = numbers.between(-2, 2);
  do {
    ground.heights.clear();
    for (std::uint32_t k = 0; k < ground.columns * ground.rows; ++k) {
      const double height = level + steep * numbers.between(-1, 1);
      ground.heights.push_back(numbers.between(0, 1) < share ? std::nan("") : height);
    }
  } while (prism_of(ground).triangles.empty());
  return ground;
}

struct Body {
  std::string name;
  ShapePtr shape;
  double size;  // how far it reaches
  bool is_curved = false;
  bool has_children = false;  // of which the deepest tells the depth
};

inline ShapePtr made_of_kind(const std::string& kind, const std::vector<double>& parameters,
                             const std::vector<double>& reals = {}) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind.c_str());
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = reals.data();
  desc.real_count = reals.size();
  return made([&](abut_shape** out) { return abut_shape_create(&desc, out); });
}

inline Body random_body(Numbers& numbers) {
  const double a = numbers.between(0.05, 0.6), b = numbers.between(0.05, 0.6), c = numbers.between(0.05, 0.6);
  switch (numbers.below(12)) {
    case 0: return {"sphere", sphere(a), a};
    case 1: return {"box", box(a, b, c), std::hypot(a, b, c)};
    case 2: return {"capsule", made_of_kind("capsule", {a, b}), a + b};
    case 3: return {"cylinder", made_of_kind("cylinder", {a, b}), std::hypot(a, b), true};
    case 4: return {"cone", made_of_kind("cone", {a, b}), std::hypot(a, b), true};
    case 5: return {"ellipsoid", made_of_kind("ellipsoid", {a, b, c}), std::fmax(a, std::fmax(b, c)), true};
    case 6: return {"point", made_of_kind("point", {}), 0};
    case 7: return {"segment", made_of_kind("segment", {a}), a};
    case 8: return {"plate", box(a, b, 0.01), std::hypot(a, b)};
    case 9: {
      std::vector<double> points;
      for (int i = 0; i < 3 * 14; ++i) points.push_back(numbers.between(-a, a));
      return {"hull", made_of_kind("hull", {}, points), 1.8 * a};
    }
    case 10: {
      std::vector<double> points;
      for (int i = 0; i < 3 * 5; ++i) points.push_back(numbers.between(-b, b));
      return {"particles", made_of_kind("particles", {0.3 * a}, points), 1.8 * b + 0.3 * a, false, true};
    }
    default: {
      const ShapePtr one = box(a, 0.1, 0.1), other = sphere(0.2);
      const std::array<const abut_shape*, 2> children{one.get(), other.get()};
      const std::array<abut_pose, 2> poses{at(0, 0, 0), at(a, 0, 0.1)};
      return {"composite",
              made([&](abut_shape** out) { return abut_composite_create(children.data(), poses.data(), 2, out); }),
              a + 0.4, false, true};
    }
  }
}

// A pose in which a body is near a place of a surface of triangles.
inline abut_pose near_surface(const test::Surface& surface, double size, Numbers& numbers) {
  const std::size_t triangle = 3 * std::size_t{numbers.below(static_cast<std::uint32_t>(surface.triangles.size() / 3))};
  double u = numbers.between(0, 1), v = numbers.between(0, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  std::array<double, 3> place{};
  const std::array weights{1 - u - v, u, v};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis] += weights[k] * surface.xyz[3 * std::size_t{surface.triangles[triangle + k]} + axis];
    }
  }
  const abut_vec3 way = numbers.direction();
  const double far = numbers.between(0, 1.3 * size + 0.1);
  return {{place[0] + far * way.x, place[1] + far * way.y, place[2] + far * way.z}, numbers.turn()};
}

inline bool overlaps(const ShapePtr& a, const ShapePtr& b, const abut_pose& pose_b) {
  const abut_pose here = at(0, 0, 0);
  std::uint32_t out = 2;
  EXPECT_EQ(abut_pair_overlaps(a.get(), &here, b.get(), &pose_b, nullptr, &out), ABUT_OK) << abut_last_error_message();
  return out == 1;
}
inline abut_pose moved(abut_pose pose, const abut_vec3& way, double length) {
  pose.position.x += length * way.x;
  pose.position.y += length * way.y;
  pose.position.z += length * way.z;
  return pose;
}

}  // namespace solid
