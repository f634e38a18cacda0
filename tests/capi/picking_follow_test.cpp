// SPDX-License-Identifier: Apache-2.0
// picking.h: a picker answers what its universe answers, whatever was edited before.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace picking_test;

constexpr double scene_size = 30;

// A universe that is edited at random.
class Editor {
 public:
  Editor(World& world, Random& random) : world_(world), random_(random), shapes_(shapes_of_every_kind(random)) {
    for (std::size_t i = 0; i < 3 * shapes_.size(); ++i) add(i % shapes_.size());
    add_plane();
  }

  void edit() {
    for (int i = 0; i < 12; ++i) edit_one(random_.below(9));
    EXPECT_EQ(abut_universe_refresh(world_.universe()), ABUT_OK);
  }

  abut_query_filter filter() {
    abut_query_filter filter;
    abut_query_filter_init(&filter, sizeof filter);
    if (random_.one_in(3)) filter.flags = ABUT_QUERY_FILTER_SKIP_SENSORS;
    if (random_.one_in(3)) filter.mask = some_bits();
    if (random_.one_in(3)) filter.layers = some_bits();
    if (random_.one_in(3)) filter.ignore_part = any().part;
    if (random_.one_in(3)) filter.ignore_geometry = any().geometry;
    return filter;
  }

  // Half of the rays are aimed at a geometry.
  abut_ray ray() {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    EXPECT_EQ(abut_geometry_describe(world_.universe(), any().geometry, &info), ABUT_OK);
    const abut_vec3 from = random_.point(random_.one_in(3) ? 30 : 8);
    const abut_vec3 to = random_.one_in(2) ? info.pose.position + random_.point(0.4) : random_.point(5);
    return {from, random_.in(0.1, 5) * (to - from), random_.one_in(4) ? random_.in(0, 20) : infinity};
  }

 private:
  const Placed& any() { return placed_[random_.below(placed_.size())]; }
  std::uint64_t some_bits() { return 1 + random_.below(15); }

  abut_geometry_options options() {
    abut_geometry_options options;
    abut_geometry_options_init(&options, sizeof options);
    options.layers = random_.one_in(12) ? 0 : some_bits();
    options.mask = random_.one_in(12) ? 0 : (random_.one_in(2) ? ~std::uint64_t{0} : some_bits());
    options.flags = random_.one_in(4) ? ABUT_GEOMETRY_SENSOR : 0;
    options.parking = random_.one_in(10) ? ABUT_PARKING_LONG_TERM : ABUT_PARKING_NONE;
    return options;
  }
  void add(std::size_t shape) {
    placed_.push_back(world_.add(shapes_[shape], random_.point(6), random_.turn()));
    const abut_geometry_options its = options();
    EXPECT_EQ(abut_geometry_set_options(world_.universe(), placed_.back().geometry, &its), ABUT_OK);
  }
  void add_plane() { placed_.push_back(world_.add(plane({0.1, 0.2, 1}, -6), {0, 0, 0})); }

  // Changes the shape of a geometry in place, where it is of a kind that can.
  void edit_shape(abut_geometry_id geometry) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    ASSERT_EQ(abut_geometry_describe(world_.universe(), geometry, &info), ABUT_OK);
    const std::string kind = abut_shape_kind_name(abut_shape_kind_of(info.shape));
    abut_universe* const universe = world_.universe();
    const abut_vec3 place = random_.point(0.8);
    const std::array numbers{random_.in(0.2, 0.8), random_.in(0.2, 0.8), random_.in(0.2, 0.8)};
    if (kind == "uv_grid") {
      // Only along Z.
      const abut_vec3 lifted{2.0 / 7 - 1, -1, random_.in(-0.4, 0.4)};
      EXPECT_EQ(abut_geometry_set_vertices(universe, geometry, 1, &lifted.x, 1), ABUT_OK) << abut_last_error_message();
    } else if (kind == "mesh") {
      EXPECT_EQ(abut_geometry_set_vertices(universe, geometry, 1, &place.x, 1), ABUT_OK) << abut_last_error_message();
    } else if (kind == "height_field") {
      EXPECT_EQ(abut_geometry_set_heights(universe, geometry, 3, 4, 3, 1, numbers.data()), ABUT_OK);
    } else if (kind == "distance_field") {
      EXPECT_EQ(abut_geometry_set_field_values(universe, geometry, 2, 3, 4, 3, 1, 1, numbers.data()), ABUT_OK);
    } else if (kind == "particles") {
      EXPECT_EQ(abut_geometry_set_particles(universe, geometry, 2, &place.x, nullptr, 1), ABUT_OK);
    } else if (kind == "box" || kind == "ellipsoid") {
      EXPECT_EQ(abut_geometry_set_parameters(universe, geometry, numbers.data(), 3), ABUT_OK);
    } else if (kind == "capsule" || kind == "cylinder" || kind == "cone") {
      EXPECT_EQ(abut_geometry_set_parameters(universe, geometry, numbers.data(), 2), ABUT_OK);
    }
  }

  void edit_one(std::size_t kind) {
    const std::size_t index = random_.below(placed_.size());
    const Placed chosen = placed_[index];
    abut_universe* const universe = world_.universe();
    const abut_geometry_options its = options();
    const auto parking = static_cast<abut_parking>(random_.below(3));
    switch (kind) {
      case 0: add(random_.below(shapes_.size())); return;
      case 1:
        world_.remove(chosen);
        placed_.erase(placed_.begin() + static_cast<std::ptrdiff_t>(index));
        return;
      case 2: world_.move(chosen, random_.point(6), random_.turn()); return;
      case 3: EXPECT_EQ(abut_geometry_park(universe, chosen.geometry, parking), ABUT_OK); return;
      case 4: EXPECT_EQ(abut_geometry_park(universe, chosen.geometry, ABUT_PARKING_NONE), ABUT_OK); return;
      case 5:
        EXPECT_EQ(abut_geometry_set_shape(universe, chosen.geometry, shapes_[random_.below(shapes_.size())].get()),
                  ABUT_OK);
        return;
      case 6:
      case 7: edit_shape(chosen.geometry); return;
      default: EXPECT_EQ(abut_geometry_set_options(universe, chosen.geometry, &its), ABUT_OK); return;
    }
  }

  World& world_;
  Random& random_;
  std::vector<Shape> shapes_;
  std::vector<Placed> placed_;
};

// Rays one by one, in both kinds of batch, and the first crossing of each geometry.
void compare(World& world, Editor& editor, int rays, const abut_query_filter* filter) {
  std::vector<abut_ray> asked;
  for (int i = 0; i < rays; ++i) asked.push_back(editor.ray());
  std::array<std::vector<abut_pick>, 2> batches;
  for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
    batches[coherence].resize(asked.size());
    ASSERT_EQ(
        abut_picker_cast_rays(world.picker(), asked.data(), asked.size(), coherence, filter, batches[coherence].data()),
        ABUT_OK)
        << abut_last_error_message();
  }
  std::array<std::vector<std::uint32_t>, 2> met;
  for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
    met[coherence].resize(asked.size());
    ASSERT_EQ(
        abut_picker_rays_hit(world.picker(), asked.data(), asked.size(), coherence, filter, met[coherence].data()),
        ABUT_OK)
        << abut_last_error_message();
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    SCOPED_TRACE("ray " + std::to_string(i));
    const abut_pick expected = hit_of_universe(world, asked[i], filter);
    std::uint32_t is_met = 2;
    ASSERT_EQ(abut_picker_ray_hits(world.picker(), &asked[i], filter, &is_met), ABUT_OK);
    EXPECT_EQ(is_met, expected.geometry.slot == 0 ? 0U : 1U);
    EXPECT_EQ(met[ABUT_COHERENCE_NONE][i], is_met);
    EXPECT_EQ(met[ABUT_COHERENCE_NEIGHBOURS][i], is_met);
    abut_pick single{};
    ASSERT_EQ(abut_picker_cast_ray(world.picker(), &asked[i], filter, &single), ABUT_OK) << abut_last_error_message();
    EXPECT_TRUE(is_same_pick(single, expected, scene_size));
    EXPECT_TRUE(is_same_pick(batches[ABUT_COHERENCE_NONE][i], expected, scene_size));
    EXPECT_TRUE(is_same_pick(batches[ABUT_COHERENCE_NEIGHBOURS][i], expected, scene_size));
    const std::vector<abut_pick> all = world.pick_all(asked[i], filter);
    std::size_t geometries = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto is_before = [&](const abut_pick& pick) { return same(pick.geometry, all[k].geometry); };
      geometries += std::none_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), is_before) ? 1 : 0;
    }
    const std::vector<abut_query_hit> hits = hits_of_universe(world, asked[i], filter);
    EXPECT_EQ(geometries, hits.size());
    for (const abut_query_hit& hit : hits) {
      const auto is_of = [&](const abut_pick& pick) { return same(pick.geometry, hit.geometry); };
      const auto first = std::find_if(all.begin(), all.end(), is_of);
      ASSERT_NE(first, all.end()) << "geometry " << hit.geometry.slot;
      EXPECT_TRUE(is_same_pick(*first, {hit.geometry, hit.feature, hit.child, 0, hit.distance, hit.point, hit.normal},
                               scene_size));
    }
  }
}

TEST(Picker, AnswersAsItsUniverseAfterAnyEdits) {
  for (const std::uint64_t seed : {101U, 102U, 103U}) {
    World world;
    ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SENSORS), ABUT_OK);
    Random random(seed);
    Editor editor(world, random);
    for (int round = 0; round < 8 && !testing::Test::HasFailure(); ++round) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
      editor.edit();
      compare(world, editor, 150, nullptr);
      const abut_query_filter filter = editor.filter();
      compare(world, editor, 150, &filter);
    }
  }
}

TEST(Picker, MeetsNoParkedGeometry) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const Placed still = world.add(ball_mesh(1, 10), {5, 0, 0});
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    ASSERT_EQ(abut_geometry_park(world.universe(), ball.geometry, parking), ABUT_OK);
    EXPECT_TRUE(same(world.pick(along_x).geometry, still.geometry));
    ASSERT_EQ(abut_geometry_park(world.universe(), still.geometry, parking), ABUT_OK);
    EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
    ASSERT_EQ(abut_geometry_park(world.universe(), still.geometry, ABUT_PARKING_NONE), ABUT_OK);
    EXPECT_TRUE(same(world.pick(along_x).geometry, still.geometry));
    ASSERT_EQ(abut_geometry_park(world.universe(), ball.geometry, ABUT_PARKING_NONE), ABUT_OK);
    EXPECT_TRUE(same(world.pick(along_x).geometry, ball.geometry));
  }
}

TEST(Picker, MeetsTheNewShapeOfAGeometry) {
  World world;
  const Placed placed = world.add(sphere(1), {0, 0, 0});
  EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 9);
  const Shape larger = sphere(2);
  ASSERT_EQ(abut_geometry_set_shape(world.universe(), placed.geometry, larger.get()), ABUT_OK);
  EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 8);
  const Shape ball = ball_mesh(3, 10);
  ASSERT_EQ(abut_geometry_set_shape(world.universe(), placed.geometry, ball.get()), ABUT_OK);
  EXPECT_NEAR(world.pick(along_x).distance, 7, 1e-12);
}

TEST(Picker, SeesOptionsThatChange) {
  World world;
  ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SENSORS), ABUT_OK);
  const Placed placed = world.add(ball_mesh(1, 10), {0, 0, 0});
  EXPECT_NE(world.pick(along_x).geometry.slot, 0U);
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.layers = 0;
  ASSERT_EQ(abut_geometry_set_options(world.universe(), placed.geometry, &options), ABUT_OK);
  EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
  options.layers = 4;
  options.flags = ABUT_GEOMETRY_SENSOR;
  ASSERT_EQ(abut_geometry_set_options(world.universe(), placed.geometry, &options), ABUT_OK);
  EXPECT_NE(world.pick(along_x).geometry.slot, 0U);
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.mask = 3;
  EXPECT_EQ(world.pick(along_x, &filter).geometry.slot, 0U);
  filter.mask = 4;
  EXPECT_NE(world.pick(along_x, &filter).geometry.slot, 0U);
  filter.flags = ABUT_QUERY_FILTER_SKIP_SENSORS;
  EXPECT_EQ(world.pick(along_x, &filter).geometry.slot, 0U);
  ASSERT_EQ(abut_picker_set_flags(world.picker(), 0), ABUT_OK);
  EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
  options.flags = 0;
  ASSERT_EQ(abut_geometry_set_options(world.universe(), placed.geometry, &options), ABUT_OK);
  EXPECT_NE(world.pick(along_x).geometry.slot, 0U);
}

TEST(Picker, LeavesTheLastMessageWhenItSucceeds) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  ASSERT_EQ(abut_set_last_error(ABUT_OK, "mine"), ABUT_OK);
  EXPECT_NE(world.pick(along_x).geometry.slot, 0U);
  EXPECT_STREQ(abut_last_error_message(), "mine");
}

TEST(Picker, NamesTheChildOfAComposite) {
  World world;
  const Shape ball = sphere(1);
  const Shape cube = box(1, 1, 1);
  world.add(composite(std::array{&ball, &cube, &ball},
                      std::array{abut_pose{{0, 3, 0}, no_turn}, abut_pose{{0, 0, 0}, no_turn},
                                 abut_pose{{0, -3, 0}, no_turn}}),
            {0, 0, 0});
  for (const auto& [y, child] : {std::pair{3.0, 0U}, {0.0, 1U}, {-3.0, 2U}}) {
    EXPECT_EQ(world.pick({{-10, y, 0}, {1, 0, 0}, infinity}).child, child);
  }
}

// Faces of a prism have several triangles each. Still, then moved.
TEST(Picker, NamesFacesAsTheUniverseDoes) {
  World world;
  Random random(7);
  const Placed placed = world.add(prism(12), {0, 0, 0});
  world.add(box(1, 2, 3), {10, 0, 0}, random.turn());
  ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
  for (int i = 0; i < 1000; ++i) {
    if (i == 500) {
      world.move(placed, {0, 0, 0.1}, random.turn());
      ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
    }
    const abut_vec3 to = (i % 2 == 0 ? abut_vec3{0, 0, 0} : abut_vec3{10, 0, 0}) + random.point(0.3);
    const abut_vec3 from = random.point(20);
    const abut_ray ray{from, to - from, infinity};
    EXPECT_TRUE(is_same_pick(world.pick(ray), hit_of_universe(world, ray, nullptr), scene_size)) << i;
  }
}

std::vector<double> distances_of(const std::vector<abut_pick>& picks) {
  std::vector<double> distances;
  for (const abut_pick& pick : picks) distances.push_back(pick.distance);
  return distances;
}

void expect_distances(World& world, const std::vector<double>& expected) {
  const std::vector<double> found = distances_of(world.pick_all(along_x));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-11) << i;
}

TEST(CastRayAll, CrossesEveryChildOfAComposite) {
  World world;
  const Shape ball = sphere(1);
  const Shape cube = box(1, 1, 1);
  const Shape pill = capsule(0.5, 1);
  world.add(composite(std::array{&ball, &cube, &pill},
                      std::array{abut_pose{{0, 0, 0}, no_turn}, abut_pose{{5, 0.2, 0.1}, no_turn},
                                 abut_pose{{10, 0, 0}, no_turn}}),
            {0, 0, 0});
  expect_distances(world, {9, 11, 14, 16, 19.5, 20.5});
  const std::vector<abut_pick> picks = world.pick_all(along_x);
  for (std::size_t i = 0; i < picks.size(); ++i) {
    EXPECT_EQ(picks[i].child, i / 2);
    EXPECT_EQ(picks[i].normal.x < 0, i % 2 == 0);
  }
}

TEST(CastRayAll, CrossesEveryParticle) {
  World world;
  const std::array centres{0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 8.0, 0.0, 0.0, 8.0, 5.0, 0.0};
  world.add(shape_from([&](abut_shape** out) { return abut_particles_create(centres.data(), 4, 0.5, out); }),
            {0, 0, 0});
  expect_distances(world, {9.5, 10.5, 12.5, 13.5, 17.5, 18.5});
}

TEST(CastRayAll, CrossesChildrenInEachOther) {
  World world;
  const Shape inner = sphere(1);
  const Shape outer = box(2, 2, 2);
  world.add(composite(std::array{&inner, &outer},
                      std::array{abut_pose{{0, 0, 0}, no_turn}, abut_pose{{0, 0.3, 0.2}, no_turn}}),
            {0, 0, 0});
  expect_distances(world, {8, 9, 11, 12});
}

TEST(CastRayAll, CrossesWallsOfHoles) {
  World world;
  const Shape block = box(2, 2, 2);
  const Shape cavity = shape_of_kind("sphere_hole", std::array{1.0});
  world.add(composite(std::array{&block, &cavity},
                      std::array{abut_pose{{0, 0.3, 0.2}, no_turn}, abut_pose{{0, 0, 0}, no_turn}}),
            {0, 0, 0});
  expect_distances(world, {8, 9, 11, 12});
}

TEST(CastRayAll, NumbersTheFacesOfABox) {
  World world;
  world.add(box(1, 1, 1), {0, 0.25, 0.125});
  ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
  for (const abut_vec3& way : {abut_vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    const abut_ray ray{-10.0 * way, way, infinity};
    const abut_ray back{10.0 * way, -1.0 * way, infinity};
    const std::vector<abut_pick> picks = world.pick_all(ray);
    ASSERT_EQ(picks.size(), 2U);
    EXPECT_EQ(picks[0].feature.index, hit_of_universe(world, ray, nullptr).feature.index);
    EXPECT_EQ(picks[1].feature.index, hit_of_universe(world, back, nullptr).feature.index);
  }
}

// A ray in the plane of a face, along an edge, and through a corner.
TEST(CastRayAll, EndsForRaysAlongSurfaces) {
  World world;
  world.add(box(1, 1, 1), {0, 0, 0});
  world.add(shape_of_kind("cylinder", std::array{1.0, 1.0}), {4, 0, 0});
  world.add(shape_of_kind("triangle", std::array{-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 1.0, 0.0}), {8, 0, 1});
  for (const abut_ray& ray : {abut_ray{{-10, 0, 1}, {1, 0, 0}, infinity},
                              {{-10, 1, 1}, {1, 0, 0}, infinity},
                              {{-1, -1, -1}, {1, 1, 1}, infinity},
                              {{0, 0, 1}, {1, 0, 0}, infinity}}) {
    EXPECT_LE(world.pick_all(ray).size(), 8U);
  }
}

}  // namespace
