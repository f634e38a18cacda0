// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <algorithm>

namespace demo {
namespace {

// On a ridge that the bodies leave bare, its foot in the ground.
Triangles statue_of(Triangles bunny, const Terrain& terrain) {
  constexpr double x = 390.0, y = -1136.0, sunk = 12.0, tall = 300.0;
  const Vec3 foot{x, y, terrain.height(x, y) - sunk};
  for (Vec3& v : bunny.vertices) {
    v = foot + v * tall;
  }
  return bunny;
}

}  // namespace

Scene::Scene(const std::filesystem::path& data, std::size_t bodies, std::uint64_t seed, std::uint32_t threads)
    : Scene(data, load_obj(data / "bunny.obj"), bodies, seed, threads) {}

Scene::Scene(const std::filesystem::path& data, const Triangles& bunny, std::size_t bodies, std::uint64_t seed,
             std::uint32_t threads)
    : terrain_(Terrain::load(data / "jacksboro_dem.pgm")),
      catalogue_(bunny, Random(seed)),
      statue_(statue_of(bunny, terrain_)),
      cloth_(statue_, Random(seed), threads) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.threads = threads;
  abut_universe* universe = nullptr;
  check(abut_universe_create(&options, &universe), "cannot create the universe");
  universe_.reset(universe);
  add_terrain();
  add_still(statue_, Kind::statue);
  sheet_ = add_still(cloth_.sheet(), Kind::cloth);
  Random random(~seed);
  sliders_ = lay_out(catalogue_, terrain_, bodies, random);
  for (const Slider& slider : sliders_) {
    add_body(slider);
  }
}

void Scene::add_terrain() {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = ABUT_MOTION_STATIC;
  options.pose = terrain_.pose();
  abut_part_id part;
  check(abut_part_create(universe_.get(), &options, &part), "cannot create the part of the terrain");
  const ShapeOwner shape = terrain_.make_shape();
  ground_ = add_geometry(part, shape.get(), {{0.0, 0.0, 0.0}, no_rotation}, Owner{});
}

// Shown, and met by nothing: the cloth has a universe of its own.
abut_geometry_id Scene::add_still(const Triangles& triangles, Kind kind) {
  abut_part_options part_options;
  abut_part_options_init(&part_options, sizeof part_options);
  part_options.motion = ABUT_MOTION_STATIC;
  abut_part_id part;
  check(abut_part_create(universe_.get(), &part_options, &part), "cannot create a part beside the bodies");
  const abut_geometry_id geometry =
      add_geometry(part, make_mesh(triangles).get(), {{0.0, 0.0, 0.0}, no_rotation}, Owner{kind, 0, 0});
  const abut_collidable still{ABUT_COLLIDABLE_GEOMETRY, geometry.slot, geometry.generation};
  const abut_collidable any{ABUT_COLLIDABLE_ANY, 0, 0};
  check(abut_rule_set(universe_.get(), &still, &any, ABUT_RULE_DISABLE), "cannot leave pairs out");
  return geometry;
}

// A cut through the slope on which the bodies lie, from the south-west to the north-east.
void Scene::excavate() {
  constexpr double start_x = 250.0, start_y = -1150.0, speed_x = 30.0, speed_y = 40.0, metres_per_step = 3.0;
  const double seconds = step_seconds * steps_;
  const Samples changed = terrain_.dig(start_x + seconds * speed_x, start_y + seconds * speed_y, metres_per_step);
  check(abut_geometry_set_heights(universe_.get(), ground_, changed.column, changed.row, changed.columns, changed.rows,
                                  changed.heights.data()),
        "cannot dig");
}

void Scene::add_body(const Slider& slider) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = ABUT_MOTION_DYNAMIC;
  options.pose = pose_of(slider, terrain_);
  const auto number = static_cast<std::uint32_t>(parts_.size() + 1);
  options.user_data = number;
  abut_part_id part;
  check(abut_part_create(universe_.get(), &options, &part), "cannot create the part of a body");
  parts_.push_back(part);
  poses_.push_back(options.pose);
  std::uint32_t index = 0;
  const Design& design = catalogue_.design(slider.design);
  for (const Piece& piece : design.pieces) {
    add_geometry(part, catalogue_.shape(piece.shape), piece.pose, {design.kind, number, index});
    ++index;
    ++geometry_count_;
  }
}

abut_geometry_id Scene::add_geometry(abut_part_id part, const abut_shape* shape, const abut_pose& pose,
                                     const Owner& owner) {
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.pose = pose;
  options.user_data = owner.body;
  abut_geometry_id geometry;
  check(abut_geometry_create(universe_.get(), part, shape, &options, &geometry), "cannot place a shape");
  owners_.resize(std::max<std::size_t>(owners_.size(), std::size_t{geometry.slot} + 1));
  owners_[geometry.slot] = owner;
  return geometry;
}

void Scene::move() {
  excavate();
  ++steps_;
  for (std::size_t i = 0; i < sliders_.size(); ++i) {
    advance(sliders_[i], terrain_);
    poses_[i] = pose_of(sliders_[i], terrain_);
  }
  check(abut_parts_set_poses(universe_.get(), parts_.data(), poses_.data(), parts_.size()), "cannot place the bodies");
}

void Scene::move_cloth() {
  cloth_.advance(step_seconds);
  const std::vector<Vec3>& places = cloth_.sheet().vertices;
  check(abut_geometry_set_vertices(universe_.get(), sheet_, 0, &places.front().x, places.size()),
        "cannot move the cloth");
}

void Scene::detect() { check(abut_universe_step(universe_.get(), step_seconds), "cannot run a step"); }

}  // namespace demo
