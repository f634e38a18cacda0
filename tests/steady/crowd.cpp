// SPDX-License-Identifier: Apache-2.0
#include "crowd.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace steady {
namespace {

using namespace abut_test;

// So close that all neighbours overlap.
constexpr double spacing = 0.9;

Shape make_particles() {
  const std::vector<double> xyz{0, 0, 0, 0.4, 0.1, 0, -0.3, 0.3, 0.2, 0.1, -0.4, -0.3, 0.2, 0.2, 0.4};
  abut_shape* shape = nullptr;
  require(abut_particles_create(xyz.data(), xyz.size() / 3, 0.3, &shape));
  return Shape(shape);
}

Shape make_row(std::size_t count) {
  const Shape ball = make_sphere(0.3), box = make_box(0.2, 0.3, 0.2);
  std::vector<const abut_shape*> children;
  std::vector<abut_pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    children.push_back(i % 2 == 0 ? ball : box);
    poses.push_back(
        at(1.2 * static_cast<double>(i) / static_cast<double>(count) - 0.6, 0.1 * static_cast<double>(i % 3), 0));
  }
  return make_composite(children, poses);
}

}  // namespace

Shape make_tube() {
  const Shape solid = make_of_kind("cylinder", {0.7, 0.5}), hole = make_of_kind("cylinder_hole", {0.4, 0.5, 3});
  return make_composite({solid, hole}, {identity, identity});
}

std::vector<Shape> make_moving_shapes() {
  std::vector<Shape> shapes;
  shapes.push_back(make_sphere(0.7));
  shapes.push_back(make_box(0.6, 0.7, 0.6));
  shapes.push_back(make_capsule(0.4, 0.4));
  shapes.push_back(make_octahedron(0.9));
  shapes.push_back(make_square_mesh(0.8));
  shapes.push_back(make_of_kind("point", {}));
  shapes.push_back(make_of_kind("segment", {0.8}));
  shapes.push_back(make_of_kind("triangle", {-0.8, -0.6, 0, 0.8, -0.6, 0, 0, 0.9, 0.1}));
  shapes.push_back(make_of_kind("cylinder", {0.6, 0.6}));
  shapes.push_back(make_of_kind("cone", {0.7, 0.6}));
  shapes.push_back(make_of_kind("ellipsoid", {0.6, 0.7, 0.8}));
  shapes.push_back(make_particles());
  shapes.push_back(make_row(3));
  shapes.push_back(make_row(12));
  return shapes;
}

std::vector<Shape> make_shapes_of_all_kinds() {
  std::vector<Shape> shapes = make_moving_shapes();
  // A ball of samples, a grid of four cells that bulges, and a tetrahedron.
  std::vector<double> values, xyz;
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i) {
        values.push_back(std::sqrt((i - 3.5) * (i - 3.5) + (j - 3.5) * (j - 3.5) + (k - 3.5) * (k - 3.5)) / 4 - 0.6);
      }
    }
  }
  abut_distance_field_desc field = filled_by(abut_distance_field_desc_init);
  field.columns = field.rows = field.layers = 8;
  field.spacing = {0.25, 0.25, 0.25};
  field.origin = {-0.875, -0.875, -0.875};
  field.values = values.data();
  abut_shape* made = nullptr;
  require(abut_distance_field_create(&field, &made));
  shapes.emplace_back(made);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < 3; ++j) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      xyz.insert(xyz.end(), {0.7 * i - 0.7, 0.7 * j - 0.7, i == 1 && j == 1 ? 0.2 : 0.0});
      const std::uint32_t first = 3 * j + i;
      if (i < 2 && j < 2) {
        triangles.insert(triangles.end(), {first, first + 1, first + 4, first, first + 4, first + 3});
      }
    }
  }
  require(abut_uv_grid_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &made));
  shapes.emplace_back(made);
  shapes.push_back(make_of_kind("mesh", {2}, {-0.6, -0.6, -0.5, 0.8, -0.6, -0.5, -0.6, 0.8, -0.5, 0, 0, 0.8},
                                {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  shapes.push_back(make_tube());
  return shapes;
}

Crowd::Crowd(const abut_universe_options& options, const std::vector<Shape>& shapes, std::size_t side,
             abut_geometry_flags flags)
    : side_(side), universe_(&options) {
  abut_geometry_options flagged = default_geometry_options();
  flagged.flags = flags;
  std::mt19937_64 random(11);  // the same everywhere, unlike distributions
  for (std::size_t body = 0; body < side * side * side; ++body) {
    parts_.push_back(universe_.add_part(pose_of(body, 0)));
    const Shape& shape = shapes.at(random() % shapes.size());
    universe_.add_geometry(parts_.back(), shape, body % 4 == 0 ? flagged : default_geometry_options());
  }
  universe_.add(make_plane({0, 0, 1}, 0), at(0, 0, -0.5), ABUT_MOTION_STATIC);
  universe_.add(make_terrain(9, 0.5 * static_cast<double>(side)), at(0, 0, -0.3), ABUT_MOTION_STATIC);
}

// A place in the block, and a small circle and a turn to and fro around it.
abut_pose Crowd::pose_of(std::size_t body, std::size_t frame) const {
  const double phase =
      2 * std::numbers::pi * static_cast<double>((frame + 5 * body) % period) / static_cast<double>(period);
  const double turn = 0.4 * static_cast<double>(body % 7) + 0.1 * std::sin(phase);
  const auto place = [&](std::size_t cell) { return spacing * static_cast<double>(cell % side_); };
  return {{place(body) + 0.15 * std::cos(phase), place(body / side_) + 0.15 * std::sin(phase),
           place(body / (side_ * side_))},
          {std::cos(turn), 0.6 * std::sin(turn), 0.8 * std::sin(turn), 0}};
}

void Crowd::move(std::size_t frame) {
  for (std::size_t body = 0; body < parts_.size(); ++body) {
    if (body % 3 != 0) {
      universe_.move(parts_.at(body), pose_of(body, frame));
    }
  }
}

void Crowd::step() { require(abut_universe_step(universe_, 0.01)); }

abut_vec3 Crowd::middle() const {
  const double half = 0.5 * spacing * static_cast<double>(side_);
  return {half, half, half};
}

}  // namespace steady
