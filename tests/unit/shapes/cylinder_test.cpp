// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "curved_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.cylinder;

namespace {

using abut::Cylinder;
using abut::Errc;
using abut::Vec3;
using test::made;

constexpr double radius = 0.75, half_height = 1.25;

Cylinder can() { return made<Cylinder>({radius, half_height}); }

test::Known known(double r, double h) {
  return {{{test::ring(0, h, r, h), test::ring(r, h, r, -h), test::ring(r, -h, 0, -h)}},
          [=](const Vec3& p) { return std::fmax(std::hypot(p.x, p.y) - r, std::fabs(p.z) - h); },
          [=](const Vec3& d) { return r * std::hypot(d.x, d.y) + h * std::fabs(d.z); },
          std::hypot(r, h)};
}

TEST(Cylinder, KeepsItsParameters) {
  EXPECT_EQ(can().parameters(), (std::vector{radius, half_height}));
  EXPECT_EQ(can().radius(), 0);
  EXPECT_EQ(can().centre(), (Vec3{0, 0, 0}));
}

TEST(Cylinder, BadInputIsRefusedByName) {
  test::expect_refused<Cylinder>({-1, 1}, {}, {}, Errc::out_of_range, "radius is -1; it must be zero or positive");
  test::expect_refused<Cylinder>({1, -2}, {}, {}, Errc::out_of_range, "half_height is -2; it must be zero or positive");
  test::expect_refused<Cylinder>({2e70, 1}, {}, {}, Errc::out_of_range, "radius is 2e+70; it must be at most 1e70");
  test::expect_refused<Cylinder>({1, std::numeric_limits<double>::infinity()}, {}, {}, Errc::not_finite,
                                 "half_height is inf; it must be finite");
  test::expect_refused<Cylinder>({1}, {}, {}, Errc::invalid_argument, "parameter_count is 1; it must be 2");
  test::expect_refused<Cylinder>({1, 1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Cylinder>({1, 1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Cylinder, BoxIsTight) {
  for (const Vec3& sizes : {Vec3{radius, half_height, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    const auto reach = [&](const abut::Pose& pose, const Vec3& direction) {
      return dot(pose.position, direction) + known(sizes.x, sizes.y).reach(pose.rotation.undo(direction));
    };
    test::expect_tight_boxes(made<Cylinder>({sizes.x, sizes.y}), reach, 1.5, 341);
  }
}

TEST(Cylinder, SupportIsOnARim) {
  for (const Vec3& sizes :
       {Vec3{radius, half_height, 0}, Vec3{1e-3, 10, 0}, Vec3{10, 1e-3, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    test::expect_curved_support(made<Cylinder>({sizes.x, sizes.y}), known(sizes.x, sizes.y), 342);
  }
  EXPECT_EQ(can().support({3, 4, 0}).index, abut::no_index);
  EXPECT_LE(largest_magnitude(can().support({3e-200, 4e-200, -1e-200}).point - Vec3{0.45, 0.6, -half_height}), 1e-15);
}

TEST(Cylinder, FacesAreCapsAndALineAlongTheSide) {
  test::expect_curved_faces(can(), known(radius, half_height), radius, 343);
  test::expect_curved_faces(made<Cylinder>({10, 0.1}), known(10, 0.1), 10, 344);
  for (const bool up : {true, false}) {
    const abut::Face cap = can().supporting_face({0.3, 0.2, up ? 1.0 : -1.0});
    ASSERT_EQ(cap.vertices.size(), 16u);
    EXPECT_EQ(cap.index, up ? 0u : 1u);
    EXPECT_EQ(cap.normal, (Vec3{0, 0, up ? 1.0 : -1.0}));
    std::uint32_t seen = 0;
    for (const abut::FaceVertex& corner : cap.vertices.span()) {
      seen |= 1u << corner.vertex;
      const double angle = (corner.vertex % 16) * std::numbers::pi / 8;
      const Vec3 expected{radius * std::cos(angle), radius * std::sin(angle), up ? half_height : -half_height};
      EXPECT_LE(largest_magnitude(corner.point - expected), 1e-15);
      EXPECT_EQ(corner.edge / 16, up ? 0u : 1u);
    }
    EXPECT_EQ(seen, up ? 0x0000ffffu : 0xffff0000u);
  }
}

TEST(Cylinder, SideIsAnEdgeWithTwoEnds) {
  const abut::Face side = can().supporting_face({-3, 4, 1});
  ASSERT_EQ(side.vertices.size(), 2u);
  EXPECT_EQ(side.vertices[0].vertex, 32u);
  EXPECT_EQ(side.vertices[1].vertex, 33u);
  EXPECT_EQ(side.vertices[0].edge, 32u);
  EXPECT_EQ(abut::feature_of(side), (abut::Feature{abut::FeatureKind::edge, 32}));
  EXPECT_LE(largest_magnitude(side.vertices[0].point - Vec3{-0.45, 0.6, -half_height}), 1e-15);
  EXPECT_LE(largest_magnitude(side.vertices[1].point - Vec3{-0.45, 0.6, half_height}), 1e-15);
}

TEST(Cylinder, FlatOnesHaveTwoFacesAndThinOnesOneEdge) {
  const Cylinder disc = made<Cylinder>({1, 0}), needle = made<Cylinder>({0, 2}), nothing = made<Cylinder>({0, 0});
  test::expect_curved_faces(disc, known(1, 0), 1, 345);
  test::expect_curved_faces(needle, known(0, 2), 0, 346);
  EXPECT_EQ(disc.supporting_face({1, 0, 0.01}).vertices.size(), 16u);
  EXPECT_EQ(disc.supporting_face({1, 0, 0.01}).index, 0u);
  EXPECT_EQ(disc.supporting_face({1, 0, -0.01}).index, 1u);
  EXPECT_EQ(needle.supporting_face({0, 0, 1}).vertices.size(), 2u);
  ASSERT_EQ(nothing.supporting_face({0, 0, 1}).vertices.size(), 1u);
  EXPECT_EQ(nothing.supporting_face({0, 1, 0}).vertices[0].point, (Vec3{0, 0, 0}));
}

TEST(Cylinder, NearestPointIsThatOfASearch) {
  for (const Vec3& sizes :
       {Vec3{radius, half_height, 0}, Vec3{2, 0.1, 0}, Vec3{0.01, 3, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    test::expect_nearest(made<Cylinder>({sizes.x, sizes.y}), known(sizes.x, sizes.y), 347);
  }
}

TEST(Cylinder, NearestPointByHand) {
  const double r = radius, h = half_height;
  test::expect_same(can().nearest({0.25, 0.5, 3}), {0.25, 0.5, h}, {0, 0, 1}, 1.75);
  test::expect_same(can().nearest({0.25, 0.5, -3}), {0.25, 0.5, -h}, {0, 0, -1}, 1.75);
  test::expect_same(can().nearest({0, -2, 0.5}), {0, -r, 0.5}, {0, -1, 0}, 1.25);
  test::expect_same(can().nearest({r + 3, 0, h + 4}), {r, 0, h}, {0.6, 0, 0.8}, 5);
  test::expect_same(can().nearest({0, r + 3, -h - 4}), {0, r, -h}, {0, 0.6, -0.8}, 5);
  test::expect_same(can().nearest({0, 0.5, 0.25}), {0, r, 0.25}, {0, 1, 0}, -0.25);
  test::expect_same(can().nearest({0.25, 0, 1}), {0.25, 0, h}, {0, 0, 1}, -0.25);
  test::expect_same(can().nearest({0, 0, -4}), {0, 0, -h}, {0, 0, -1}, 2.75);
  test::expect_same(can().nearest({0, 0, h}), {0, 0, h}, {0, 0, 1}, 0);
  const abut::SurfacePoint centre = can().nearest({0, 0, 0});  // any side will do
  EXPECT_EQ(centre.distance, -r);
  EXPECT_NEAR(std::hypot(centre.point.x, centre.point.y), r, 1e-15);
  EXPECT_EQ(centre.point.z, 0);
  test::expect_nearest_at(can(), known(r, h), {0, 0, 0.3});
  test::expect_nearest_at(can(), known(r, h), {r, 0, h});
  test::expect_nearest_at(can(), known(r, h), {1e-200, 0, 0});
  test::expect_nearest_at(can(), known(r, h), {1e4, 2e4, 3e4});
}

TEST(Cylinder, NearestPointOfFlatAndThinOnes) {
  const Cylinder disc = made<Cylinder>({1, 0}), needle = made<Cylinder>({0, 2}), nothing = made<Cylinder>({0, 0});
  test::expect_same(disc.nearest({0.5, 0, 2}), {0.5, 0, 0}, {0, 0, 1}, 2);
  test::expect_same(disc.nearest({0.5, 0, -1e-12}), {0.5, 0, 0}, {0, 0, -1}, 1e-12);
  test::expect_same(disc.nearest({4, 0, 0}), {1, 0, 0}, {1, 0, 0}, 3);
  EXPECT_EQ(disc.nearest({0.5, 0, 0}).distance, 0);
  EXPECT_EQ(std::fabs(disc.nearest({0.5, 0, 0}).normal.z), 1);
  test::expect_same(needle.nearest({0, 3, 1}), {0, 0, 1}, {0, 1, 0}, 3);
  test::expect_same(needle.nearest({0, 0, 5}), {0, 0, 2}, {0, 0, 1}, 3);
  test::expect_same(needle.nearest({3, 0, 6}), {0, 0, 2}, {0.6, 0, 0.8}, 5);
  EXPECT_EQ(needle.nearest({0, 0, 1}).distance, 0);
  test::expect_same(nothing.nearest({3, 0, -4}), {0, 0, 0}, {0.6, 0, -0.8}, 5);
  EXPECT_EQ(nothing.nearest({0, 0, 0}).distance, 0);
  EXPECT_NEAR(norm(nothing.nearest({0, 0, 0}).normal), 1, 1e-15);
}

TEST(Cylinder, RaysMeetTheFirstCrossing) {
  test::expect_rays(can(), known(radius, half_height).outside, 1.5, 348);
  test::expect_rays(made<Cylinder>({2, 0.5}), known(2, 0.5).outside, 2, 349);
}

TEST(Cylinder, RaysNameTheFaceTheyMeet) {
  using abut::Feature, abut::FeatureKind;
  const auto along = [](int axis, double sign) {
    return abut::UnitVec3::from_unit_unchecked(test::axis_vector(axis, sign));
  };
  EXPECT_EQ(can().cast_ray({0.5, 0, 5}, along(2, -1), 10)->distance, 3.75);
  EXPECT_EQ(can().cast_ray({0.5, 0, 5}, along(2, -1), 10)->feature, (Feature{FeatureKind::face, 0}));
  EXPECT_EQ(can().cast_ray({0.5, 0, -5}, along(2, 1), 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_EQ(can().cast_ray({0.5, 0, -5}, along(2, 1), 10)->feature, (Feature{FeatureKind::face, 1}));
  EXPECT_EQ(can().cast_ray({5, 0, 1}, along(0, -1), 10)->distance, 4.25);
  EXPECT_EQ(can().cast_ray({5, 0, 1}, along(0, -1), 10)->feature, (Feature{FeatureKind::face, 2}));
  EXPECT_EQ(can().cast_ray({0, 0, 0}, along(1, -1), 10)->normal, (Vec3{0, -1, 0}));
  EXPECT_EQ(can().cast_ray({0, 0, 0}, along(2, 1), 10)->distance, half_height);
  EXPECT_FALSE(can().cast_ray({5, 0, 1.3}, along(0, -1), 10).has_value());
  EXPECT_FALSE(can().cast_ray({0.8, 0, 5}, along(2, -1), 10).has_value());
  EXPECT_FALSE(can().cast_ray({5, 0, 1}, along(0, 1), 10).has_value());
  EXPECT_FALSE(can().cast_ray({5, 0, 1}, along(0, -1), 4.2).has_value());
  // Along the side, and across the top of it: touching counts.
  EXPECT_EQ(can().cast_ray({radius, 0, 5}, along(2, -1), 10)->distance, 3.75);
  EXPECT_EQ(can().cast_ray({-5, radius, 0}, along(0, 1), 10)->distance, 5);
  EXPECT_EQ(can().cast_ray({-5, 0, half_height}, along(0, 1), 10)->distance, 4.25);
}

TEST(Cylinder, RaysAtTheRimAndFromFarAwayMeetTheFirstCrossing) {
  const auto rim = [](test::Random& random) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), z = random.uniform(0, 1) < 0.5 ? 1 : -1;
    const Vec3 outward{std::cos(angle), std::sin(angle), 0};
    return test::Aim{radius * outward + Vec3{0, 0, z * half_height}, outward, {0, 0, z}};
  };
  const auto side = [](test::Random& random) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), z = random.uniform(-1, 1);
    const Vec3 outward{std::cos(angle), std::sin(angle), 0};
    return test::Aim{radius * outward + Vec3{0, 0, z}, outward, outward};
  };
  test::expect_rays_at(can(), rim, 3, 1e-13, 350);
  test::expect_rays_at(can(), side, 3, 1e-13, 351);
  test::expect_rays_at(can(), side, 1e6, 1e-8, 352);
}

TEST(Cylinder, RaysMeetFlatOnes) {
  const Cylinder disc = made<Cylinder>({1, 0});
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, 3}, down, 10)->distance, 3);
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, 3}, down, 10)->normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, -3}, -down, 10)->distance, 3);
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, -3}, -down, 10)->normal, (Vec3{0, 0, -1}));  // as of a flat box
  EXPECT_FALSE(disc.cast_ray({0.8, 0.8, 3}, down, 10).has_value());
  EXPECT_FALSE(disc.cast_ray({0.5, 0.5, 3}, -down, 10).has_value());
  EXPECT_FALSE(made<Cylinder>({0, 1}).cast_ray({0.1, 0, 3}, down, 10).has_value());
}

}  // namespace
