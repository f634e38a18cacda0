// SPDX-License-Identifier: Apache-2.0
// Queries on a universe, as a program of the C interface asks them.
#include <cmath>
#include <limits>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double endless = std::numeric_limits<double>::infinity();

// Three balls of radius 1 in a row along X, 4 apart.
struct Row {
  Universe universe;
  Shape ball = make_sphere(1.0);
  std::array<abut_geometry_id, 3> balls{};

  Row() {
    for (std::size_t i = 0; i < balls.size(); ++i)
      balls.at(i) = universe.add(ball, at(4.0 * static_cast<double>(i), 0, 0));
    EXPECT_TRUE(succeeded(abut_universe_refresh(universe)));
  }
};

std::vector<abut_query_hit> cast_ray(const abut_universe* universe, const abut_ray& ray, abut_hit_mode mode,
                                     const abut_query_filter* filter = nullptr) {
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_universe_cast_ray(universe, &ray, filter, mode, nullptr, 0, &count)));
  std::vector<abut_query_hit> hits(count);
  EXPECT_TRUE(succeeded(abut_universe_cast_ray(universe, &ray, filter, mode, hits.data(), hits.size(), &count)));
  EXPECT_EQ(count, hits.size());
  return hits;
}

TEST(QueriesInUse, RaysReportTheNearestAnyOrAll) {
  Row row;
  const abut_ray ray{{-5, 0, 0}, {3, 0, 0}, endless};
  const auto nearest = cast_ray(row.universe, ray, ABUT_HIT_NEAREST);
  ASSERT_EQ(nearest.size(), 1U);
  EXPECT_TRUE(nearest.front().geometry == row.balls[0]);
  EXPECT_NEAR(nearest.front().distance, 4, 1e-14);
  EXPECT_NEAR(nearest.front().point.x, -1, 1e-14);
  EXPECT_NEAR(nearest.front().normal.x, -1, 1e-14);
  const auto all = cast_ray(row.universe, ray, ABUT_HIT_ALL);
  ASSERT_EQ(all.size(), 3U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all.at(i).geometry == row.balls.at(i));
    EXPECT_NEAR(all.at(i).distance, 4 + 4.0 * static_cast<double>(i), 1e-14);
  }
  EXPECT_EQ(cast_ray(row.universe, ray, ABUT_HIT_ANY).size(), 1U);
  EXPECT_TRUE(cast_ray(row.universe, {{-5, 3, 0}, {1, 0, 0}, endless}, ABUT_HIT_ANY).empty());
}

TEST(QueriesInUse, AShortArrayGetsTheFirstHits) {
  Row row;
  const abut_ray ray{{-5, 0, 0}, {1, 0, 0}, endless};
  OutArray<abut_query_hit> hits{3};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_cast_ray(row.universe, &ray, nullptr, ABUT_HIT_ALL, hits.data(), 2, &count)));
  EXPECT_EQ(count, 3U);
  EXPECT_TRUE(hits[0].geometry == row.balls[0] && hits[1].geometry == row.balls[1]);
  EXPECT_TRUE(hits.is_untouched_from(2));
}

TEST(QueriesInUse, BatchesOfRaysAnswerEach) {
  Row row;
  const std::array<abut_ray, 3> rays{
      {{{0, 0, 9}, {0, 0, -1}, 20}, {{2, 0, 9}, {0, 0, -1}, 20}, {{8, 0, 9}, {0, 0, -1}, 8}}};
  OutArray<abut_query_hit> hits{4};
  ASSERT_TRUE(succeeded(abut_universe_cast_rays(row.universe, rays.data(), rays.size(), nullptr, hits.data())));
  EXPECT_TRUE(hits[0].geometry == row.balls[0]);
  EXPECT_TRUE(hits[1].geometry == abut_geometry_id{});
  EXPECT_TRUE(hits[2].geometry == row.balls[2]) << "a ray that just reaches a surface meets it";
  EXPECT_NEAR(hits[2].distance, 8, 0);
  EXPECT_TRUE(hits.is_untouched_from(3));
}

TEST(QueriesInUse, FiltersLeaveOut) {
  Row row;
  const abut_ray ray{{-5, 0, 0}, {1, 0, 0}, endless};
  const auto first_of = [&](const abut_query_filter& filter) {
    const auto hits = cast_ray(row.universe, ray, ABUT_HIT_NEAREST, &filter);
    return hits.empty() ? abut_geometry_id{} : hits.front().geometry;
  };
  abut_query_filter filter = default_filter();
  EXPECT_TRUE(first_of(filter) == row.balls[0]);
  filter.ignore_geometry = row.balls[0];
  EXPECT_TRUE(first_of(filter) == row.balls[1]);
  filter.ignore_part = row.universe.describe(row.balls[1]).part;
  EXPECT_TRUE(first_of(filter) == row.balls[2]);

  abut_geometry_options options = default_geometry_options();
  options.layers = 6;
  options.mask = 8;
  options.flags = ABUT_GEOMETRY_SENSOR;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(row.universe, row.balls[0], &options)));
  ASSERT_TRUE(succeeded(abut_universe_refresh(row.universe)));
  filter = default_filter();
  EXPECT_TRUE(first_of(filter) == row.balls[0]);
  filter.mask = 1;
  EXPECT_TRUE(first_of(filter) == row.balls[1]);
  filter = default_filter();
  filter.layers = 4;
  EXPECT_TRUE(first_of(filter) == row.balls[1]);
  filter = default_filter();
  filter.flags = ABUT_QUERY_FILTER_SKIP_SENSORS;
  EXPECT_TRUE(first_of(filter) == row.balls[1]);
}

TEST(QueriesInUse, RaysStartInsideAsAskedFor) {
  Row row;
  const abut_ray ray{{0.5, 0, 0}, {1, 0, 0}, endless};
  abut_query_filter filter = default_filter();
  EXPECT_NEAR(cast_ray(row.universe, ray, ABUT_HIT_NEAREST, &filter).at(0).distance, 0.5, 1e-14);
  filter.ray_start = ABUT_RAY_START_SOLID;
  const auto solid = cast_ray(row.universe, ray, ABUT_HIT_NEAREST, &filter);
  ASSERT_EQ(solid.size(), 1U);
  EXPECT_EQ(solid.front().distance, 0);
  EXPECT_TRUE(solid.front().normal.x == 0 && solid.front().normal.y == 0 && solid.front().normal.z == 0);
  filter.ray_start = ABUT_RAY_START_SKIP;
  EXPECT_TRUE(cast_ray(row.universe, ray, ABUT_HIT_NEAREST, &filter).at(0).geometry == row.balls[1]);
}

TEST(QueriesInUse, MovingShapesMeetTheFirst) {
  Row row;
  const Shape box = make_box(0.5, 0.5, 0.5);
  const abut_pose from = at(-5, 0.25, 0);
  const abut_vec3 way{20, 0, 0};
  std::array<abut_cast_hit, 3> hits{};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_cast_shape(row.universe, box, &from, &way, nullptr, ABUT_HIT_NEAREST, hits.data(),
                                                 hits.size(), &count)));
  ASSERT_EQ(count, 1U);
  EXPECT_TRUE(hits[0].geometry == row.balls[0]);
  EXPECT_NEAR(hits[0].fraction, 3.5 / 20, 1e-12);
  EXPECT_NEAR(hits[0].contact.normal.x, 1, 1e-6);
  EXPECT_NEAR(hits[0].contact.point_b.x, -1, 1e-9);
  EXPECT_LE(hits[0].contact.upper, 1e-9);
  ASSERT_TRUE(succeeded(abut_universe_cast_shape(row.universe, box, &from, &way, nullptr, ABUT_HIT_ALL, hits.data(),
                                                 hits.size(), &count)));
  EXPECT_EQ(count, 3U);
  EXPECT_NEAR(hits[2].fraction, 11.5 / 20, 1e-12);

  const std::array<const abut_shape*, 2> shapes{box, box};
  const std::array<abut_pose, 2> poses{from, at(-5, 9, 0)};
  const std::array<abut_vec3, 2> ways{way, way};
  ASSERT_TRUE(succeeded(
      abut_universe_cast_shapes(row.universe, shapes.data(), poses.data(), ways.data(), 2, nullptr, hits.data())));
  EXPECT_TRUE(hits[0].geometry == row.balls[0]);
  EXPECT_TRUE(hits[1].geometry == abut_geometry_id{});
}

TEST(QueriesInUse, TwoShapesMayBothMove) {
  const Shape ball = make_sphere(1.0);
  const abut_pose left = at(-5, 0, 0);
  const abut_pose right = at(5, 0, 0);
  const abut_vec3 forth{10, 0, 0};
  const abut_vec3 back{-6, 0, 0};
  Out<abut_cast_hit> hit;
  std::uint32_t found = 7;
  ASSERT_TRUE(succeeded(abut_pair_cast(ball, &left, &forth, ball, &right, &back, nullptr, hit.address(), &found)));
  ASSERT_EQ(found, 1U);
  EXPECT_NEAR(hit.value().fraction, 0.5, 1e-14);
  EXPECT_NEAR(hit.value().contact.point_a.x, 1, 1e-13);
  EXPECT_TRUE(hit.value().geometry == abut_geometry_id{});
  Out<abut_cast_hit> none;
  ASSERT_TRUE(succeeded(abut_pair_cast(ball, &left, &back, ball, &right, &forth, nullptr, none.address(), &found)));
  EXPECT_EQ(found, 0U);
  EXPECT_TRUE(none.is_untouched());
}

TEST(QueriesInUse, OverlapsComeAloneAndInBatches) {
  Row row;
  const Shape probe = make_sphere(1.5);
  const std::array<const abut_shape*, 3> shapes{probe, probe, probe};
  const std::array<abut_pose, 3> poses{at(2, 0, 0), at(0, 9, 0), at(8, 0, 0)};
  std::array<std::uint64_t, 4> offsets{};
  std::array<abut_geometry_id, 3> found{};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(
      abut_universe_overlaps(row.universe, probe, poses.data(), nullptr, 0, found.data(), found.size(), &count)));
  EXPECT_EQ(count, 2U);
  EXPECT_TRUE(found[0] == row.balls[0] && found[1] == row.balls[1]);
  ASSERT_TRUE(succeeded(abut_universe_overlaps_of_each(row.universe, shapes.data(), poses.data(), 3, nullptr, 0,
                                                       offsets.data(), found.data(), found.size(), &count)));
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(offsets, (std::array<std::uint64_t, 4>{0, 2, 2, 3}));
  EXPECT_TRUE(found[2] == row.balls[2]);
  // Too little room: the offsets are whole all the same.
  OutArray<abut_geometry_id> few{3};
  ASSERT_TRUE(succeeded(abut_universe_overlaps_of_each(row.universe, shapes.data(), poses.data(), 3, nullptr, 0,
                                                       offsets.data(), few.data(), 1, &count)));
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(offsets[3], 3U);
  EXPECT_TRUE(few[0] == row.balls[0] && few.is_untouched_from(1));
}

TEST(QueriesInUse, PointsAreFoundInSolids) {
  Row row;
  const std::array<abut_vec3, 3> points{{{0.5, 0, 0}, {2, 0, 0}, {8, 0, 1}}};
  std::array<std::uint64_t, 4> offsets{};
  std::array<abut_geometry_id, 3> found{};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(
      abut_universe_at_points(row.universe, points.data(), 3, nullptr, offsets.data(), found.data(), 3, &count)));
  EXPECT_EQ(offsets, (std::array<std::uint64_t, 4>{0, 1, 1, 2}));
  EXPECT_TRUE(found[0] == row.balls[0] && found[1] == row.balls[2]);
  ASSERT_TRUE(succeeded(abut_universe_at_point(row.universe, points.data(), nullptr, found.data(), 3, &count)));
  EXPECT_EQ(count, 1U);
}

// A point has no size, and there rounding has none either.
TEST(QueriesInUse, APointOnASheetAtTheOriginIsFound) {
  Universe universe;
  universe.add(make_square_mesh(1), identity);
  universe.step();
  const abut_vec3 origin{0, 0, 0}, aside{0.5, 0.25, 0.5};
  std::array<abut_geometry_id, 2> found{};
  std::size_t count = 0;
  require(abut_universe_at_point(universe, &origin, nullptr, found.data(), found.size(), &count));
  EXPECT_EQ(count, 1U);
  require(abut_universe_at_point(universe, &aside, nullptr, found.data(), found.size(), &count));
  EXPECT_EQ(count, 0U);
}

TEST(QueriesInUse, TheClosestIsFound) {
  Row row;
  const Shape probe = make_box(0.5, 0.5, 0.5);
  const abut_pose pose = at(4, 0, 5);
  abut_closest closest{};
  std::uint32_t found = 0;
  ASSERT_TRUE(succeeded(abut_universe_closest(row.universe, probe, &pose, endless, nullptr, &closest, &found)));
  ASSERT_EQ(found, 1U);
  EXPECT_TRUE(closest.geometry == row.balls[1]);
  EXPECT_NEAR(closest.distance.distance, 3.5, 1e-13);
  EXPECT_NEAR(closest.distance.normal.z, -1, 1e-13);
  ASSERT_TRUE(succeeded(abut_universe_closest(row.universe, probe, &pose, 3, nullptr, &closest, &found)));
  EXPECT_EQ(found, 0U);
  const std::array<const abut_shape*, 2> shapes{probe, probe};
  const std::array<abut_pose, 2> poses{pose, at(0, 0, 50)};
  std::array<abut_closest, 2> each{};
  ASSERT_TRUE(
      succeeded(abut_universe_closest_to_each(row.universe, shapes.data(), poses.data(), 2, 4, nullptr, each.data())));
  EXPECT_TRUE(each[0].geometry == row.balls[1]);
  EXPECT_TRUE(each[1].geometry == abut_geometry_id{});
}

}  // namespace
