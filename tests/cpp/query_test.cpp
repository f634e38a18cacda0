// SPDX-License-Identifier: Apache-2.0
// Queries on a universe of balls in a row, two apart, along X.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

struct Row {
  Row() {
    const abut::Shape ball = abut::Shape::sphere(0.5);
    for (int i = 0; i < 40; ++i) {
      const auto part = universe.create_part(abut::PartOptions().with_pose(abut::pose({2.0 * i, 0, 0})));
      balls.push_back(universe.create_geometry(part, ball));
    }
    universe.refresh();
  }

  abut::Universe universe;
  std::vector<abut::GeometryId> balls;
};

const abut::Ray along{{-5, 0, 0}, {1, 0, 0}, INFINITY};

TEST(Rays, MeetWhatLiesOnTheirWay) {
  const Row row;
  const auto hit = row.universe.cast_ray(along);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->geometry, row.balls[0]);
  EXPECT_EQ(hit->distance, 4.5);
  const auto second = row.universe.cast_ray(along, abut::QueryFilter().with_ignore_geometry(row.balls[0]));
  EXPECT_EQ(second->geometry, row.balls[1]);
  EXPECT_TRUE(row.universe.cast_ray(along, {}, ABUT_HIT_ANY));
  EXPECT_FALSE(row.universe.cast_ray(along, abut::QueryFilter().with_mask(2)));
  EXPECT_EQ(row.universe.cast_ray_all(along).size(), 40U);

  const std::vector<abut::Ray> rays{along, {{0, 9, 0}, {0, 1, 0}, 5}};
  const std::vector<abut::QueryHit> hits = row.universe.cast_rays(rays);
  EXPECT_EQ(hits[0].geometry, row.balls[0]);
  EXPECT_TRUE(abut::is_null(hits[1].geometry));
  std::vector<abut::QueryHit> out(2);
  row.universe.cast_rays(rays, out);
  EXPECT_EQ(out[0].distance, 4.5);
  EXPECT_THROW(row.universe.cast_rays(rays, abut::Span<abut::QueryHit>(out.data(), 1)), abut::Error);
}

TEST(Shapes, AreCastThroughAUniverse) {
  const Row row;
  const abut::Shape ball = abut::Shape::sphere(0.5);
  const auto hit = row.universe.cast_shape(ball, abut::pose({-3, 0, 0}), {4, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->fraction, 0.5, 1e-9);
  EXPECT_EQ(row.universe.cast_shape_all(ball, abut::pose({-3, 0, 0}), {200, 0, 0}).size(), 40U);
  EXPECT_FALSE(row.universe.cast_shape(ball, abut::pose({-3, 0, 0}), {-4, 0, 0}));
  const auto hits =
      row.universe.cast_shapes({ball, ball}, {abut::pose({-3, 0, 0}), abut::pose({0, 9, 0})}, {{4, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(hits[0].geometry, row.balls[0]);
  EXPECT_TRUE(abut::is_null(hits[1].geometry));
  EXPECT_THROW(static_cast<void>(row.universe.cast_shapes({ball}, {abut::pose()}, {})), abut::Error);
}

TEST(Overlaps, AreListed) {
  const Row row;
  const abut::Shape box = abut::Shape::box(100, 1, 1), ball = abut::Shape::sphere(0.5);
  EXPECT_EQ(row.universe.overlaps(box, abut::pose()).size(), 40U);
  EXPECT_EQ(row.universe.overlaps(ball, abut::pose({0, 2, 0})).size(), 0U);
  EXPECT_EQ(row.universe.overlaps(ball, abut::pose({0, 2, 0}), 1.5).size(), 1U);
  std::vector<abut::GeometryId> few(3);
  EXPECT_EQ(row.universe.overlaps(box, abut::pose(), 0, few), 40U);
  EXPECT_EQ(few[2], row.balls[2]);

  const auto lists =
      row.universe.overlaps_of_each({ball, box, ball}, {abut::pose(), abut::pose(), abut::pose({1, 9, 0})});
  ASSERT_EQ(lists.query_count(), 3U);
  EXPECT_EQ(lists.of(0).size(), 1U);
  EXPECT_EQ(lists.of(1).size(), 40U);
  EXPECT_EQ(lists.of(1)[39], row.balls[39]);
  EXPECT_TRUE(lists.of(2).empty());
}

TEST(Points, LieInSolids) {
  const Row row;
  EXPECT_EQ(row.universe.at_point({2, 0, 0.25}).at(0), row.balls[1]);
  const auto lists = row.universe.at_points({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(lists.of(0).size(), 1U);
  EXPECT_TRUE(lists.of(1).empty());
}

TEST(Closest, IsTheNearestWithinADistance) {
  const Row row;
  const abut::Shape point = abut::Shape::point();
  const auto closest = row.universe.closest(point, abut::pose({-2, 0, 0}), INFINITY);
  ASSERT_TRUE(closest);
  EXPECT_EQ(closest->geometry, row.balls[0]);
  EXPECT_EQ(closest->distance.distance, 1.5);
  EXPECT_FALSE(row.universe.closest(point, abut::pose({-2, 0, 0}), 1));
  EXPECT_EQ(
      row.universe.closest_to_each({point, point}, {abut::pose({-2, 0, 0}), abut::pose({79, 0, 0})}, 2)[1].geometry,
      row.balls[39]);
}

}  // namespace
