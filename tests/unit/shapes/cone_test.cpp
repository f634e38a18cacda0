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
import abut.shapes.cone;

namespace {

using abut::Cone;
using abut::Errc;
using abut::Vec3;
using test::made;

// A base of radius 1.5 and a height of 2: the side is 2.5 long and its normal (0.8, 0.6) across and up.
constexpr double radius = 1.5, half_height = 1;

Cone hat() { return made<Cone>({radius, half_height}); }

test::Known known(double r, double h) {
  const double slant = std::hypot(r, 2 * h), out = slant > 0 ? 2 * h / slant : 0, up = slant > 0 ? r / slant : 1;
  return {{{test::ring(0, -h, r, -h), test::ring(r, -h, 0, h)}},
          [=](const Vec3& p) { return std::fmax((std::hypot(p.x, p.y) - r) * out + (p.z + h) * up, -h - p.z); },
          [=](const Vec3& d) { return std::fmax(h * d.z, r * std::hypot(d.x, d.y) - h * d.z); },
          std::hypot(r, h)};
}

TEST(Cone, KeepsItsParameters) {
  EXPECT_EQ(hat().parameters(), (std::vector{radius, half_height}));
  EXPECT_EQ(hat().radius(), 0);
  EXPECT_EQ(hat().centre(), (Vec3{0, 0, 0}));
}

TEST(Cone, BadInputIsRefusedByName) {
  test::expect_refused<Cone>({-1, 1}, {}, {}, Errc::out_of_range, "radius is -1; it must be zero or positive");
  test::expect_refused<Cone>({1, -2}, {}, {}, Errc::out_of_range, "half_height is -2; it must be zero or positive");
  test::expect_refused<Cone>({1, 2e70}, {}, {}, Errc::out_of_range, "half_height is 2e+70; it must be at most 1e70");
  test::expect_refused<Cone>({std::numeric_limits<double>::quiet_NaN(), 1}, {}, {}, Errc::not_finite, "radius is nan;");
  test::expect_refused<Cone>({1, 1, 1}, {}, {}, Errc::invalid_argument, "parameter_count is 3; it must be 2");
  test::expect_refused<Cone>({1, 1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Cone>({1, 1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

// At a corner the normal has to be one of the corner's, also where the point is beside it by nothing but rounding.
TEST(Cone, NearestToSpecksBesideCornersHasTheirNormals) {
  for (const Vec3& sizes : {Vec3{radius, half_height, 0}, Vec3{0.3, 0.7, 0}, Vec3{1e-3, 1.1, 0}, Vec3{3.3, 1e-2, 0}}) {
    const Cone cone = made<Cone>({sizes.x, sizes.y});
    const double ulp = std::numeric_limits<double>::epsilon() * std::fmax(sizes.x, sizes.y);
    for (const Vec3& corner : {Vec3{0, 0, sizes.y}, Vec3{sizes.x, 0, -sizes.y}, Vec3{0, -sizes.x, -sizes.y}}) {
      for (int x = -4; x <= 4; ++x) {
        for (int y = -4; y <= 4; ++y) {
          for (int z = -4; z <= 4; ++z) {
            const Vec3 p = corner + 0.125 * ulp * Vec3{x * 1.0, y * 1.0, z * 1.0};
            const abut::SurfacePoint near = cone.nearest(p);
            const double beyond = dot(near.normal, cone.support(near.normal).point - near.point);
            EXPECT_LE(beyond, 4 * ulp) << sizes.x << " " << sizes.y << ": " << x << " " << y << " " << z;
            EXPECT_NEAR(dot(near.normal, near.normal), 1, 1e-14);
            EXPECT_LE(std::fabs(near.distance), 2 * ulp);
          }
        }
      }
    }
  }
}

TEST(Cone, BoxIsTight) {
  for (const Vec3& sizes : {Vec3{radius, half_height, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.1, 1, 0}}) {
    const auto reach = [&](const abut::Pose& pose, const Vec3& direction) {
      return dot(pose.position, direction) + known(sizes.x, sizes.y).reach(pose.rotation.undo(direction));
    };
    test::expect_tight_boxes(made<Cone>({sizes.x, sizes.y}), reach, 2, 361);
  }
}

TEST(Cone, SupportIsTheApexOrOnTheRim) {
  for (const Vec3& sizes :
       {Vec3{radius, half_height, 0}, Vec3{1e-3, 10, 0}, Vec3{10, 1e-3, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    test::expect_curved_support(made<Cone>({sizes.x, sizes.y}), known(sizes.x, sizes.y), 362);
  }
  EXPECT_EQ(hat().support({0, 0, 1}).index, 16u);
  EXPECT_EQ(hat().support({0, 0, 1e-200}).point, (Vec3{0, 0, half_height}));
  EXPECT_EQ(hat().support({1, 0, 0}).index, abut::no_index);
  EXPECT_LE(largest_magnitude(hat().support({3e-200, -4e-200, 1e-200}).point - Vec3{0.9, -1.2, -half_height}), 1e-15);
}

TEST(Cone, FacesAreTheBaseALineAlongTheSideAndTheApex) {
  test::expect_curved_faces(hat(), known(radius, half_height), radius, 363);
  test::expect_curved_faces(made<Cone>({0.1, 4}), known(0.1, 4), 0.1, 364);
  test::expect_curved_faces(made<Cone>({4, 0.1}), known(4, 0.1), 4, 365);
  const abut::Face base = hat().supporting_face({0.1, 0.1, -1});
  ASSERT_EQ(base.vertices.size(), 16u);
  EXPECT_EQ(base.index, 0u);
  EXPECT_EQ(base.normal, (Vec3{0, 0, -1}));
  std::uint32_t seen = 0;
  for (const abut::FaceVertex& corner : base.vertices.span()) {
    ASSERT_LT(corner.vertex, 16u);
    ASSERT_LT(corner.edge, 16u);
    seen |= 1u << corner.vertex;
    const double angle = corner.vertex * std::numbers::pi / 8;
    EXPECT_LE(largest_magnitude(corner.point - Vec3{radius * std::cos(angle), radius * std::sin(angle), -half_height}),
              1e-15);
  }
  EXPECT_EQ(seen, 0xffffu);
}

TEST(Cone, SideIsAnEdgeAndTheTopAVertex) {
  const abut::Face side = hat().supporting_face({0.8, 0, 0.6});
  ASSERT_EQ(side.vertices.size(), 2u);
  EXPECT_EQ(abut::feature_of(side), (abut::Feature{abut::FeatureKind::edge, 16}));
  EXPECT_EQ(side.vertices[0].vertex, 16u);
  EXPECT_EQ(side.vertices[0].point, (Vec3{0, 0, half_height}));
  EXPECT_EQ(side.vertices[1].vertex, 17u);
  EXPECT_EQ(side.vertices[1].point, (Vec3{radius, 0, -half_height}));
  const abut::Face top = hat().supporting_face({0.1, 0, 1});
  ASSERT_EQ(top.vertices.size(), 1u);
  EXPECT_EQ(abut::feature_of(top), (abut::Feature{abut::FeatureKind::vertex, 16}));
  EXPECT_EQ(top.vertices[0].point, (Vec3{0, 0, half_height}));
}

TEST(Cone, FlatOnesHaveTwoFacesAndThinOnesOneEdge) {
  const Cone disc = made<Cone>({1, 0}), needle = made<Cone>({0, 2}), nothing = made<Cone>({0, 0});
  test::expect_curved_faces(disc, known(1, 0), 1, 366);
  test::expect_curved_faces(needle, known(0, 2), 0, 367);
  EXPECT_EQ(disc.supporting_face({0.1, 0, -1}).index, 0u);
  EXPECT_EQ(disc.supporting_face({0.1, 0, 1}).index, 1u);
  EXPECT_EQ(needle.supporting_face({1, 0, 0}).vertices.size(), 2u);
  ASSERT_EQ(nothing.supporting_face({0, 1, 0}).vertices.size(), 1u);
  EXPECT_EQ(nothing.supporting_face({0, 1, 0}).vertices[0].point, (Vec3{0, 0, 0}));
}

TEST(Cone, NearestPointIsThatOfASearch) {
  for (const Vec3& sizes :
       {Vec3{radius, half_height, 0}, Vec3{2, 0.1, 0}, Vec3{0.01, 3, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    test::expect_nearest(made<Cone>({sizes.x, sizes.y}), known(sizes.x, sizes.y), 368);
  }
}

TEST(Cone, NearestPointByHand) {
  const double r = radius, h = half_height;
  test::expect_same(hat().nearest({0.25, 0.5, -3}), {0.25, 0.5, -h}, {0, 0, -1}, 2);
  test::expect_same(hat().nearest({r + 3, 0, -h - 4}), {r, 0, -h}, {0.6, 0, -0.8}, 5);
  test::expect_same(hat().nearest({0, r + 3, -h}), {0, r, -h}, {0, 1, 0}, 3);
  test::expect_same(hat().nearest({0, 0, 4}), {0, 0, h}, {0, 0, 1}, 3);
  test::expect_same(hat().nearest({3, 0, h + 4}), {0, 0, h}, {0.6, 0, 0.8}, 5);
  // Out of the middle of the side, and into it.
  test::expect_same(hat().nearest({0.75 + 4, 0, 3}), {0.75, 0, 0}, {0.8, 0, 0.6}, 5);
  test::expect_same(hat().nearest({0, 0.75 - 0.2, -0.15}), {0, 0.75, 0}, {0, 0.8, 0.6}, -0.25);
  test::expect_same(hat().nearest({0.25, 0, -0.9}), {0.25, 0, -h}, {0, 0, -1}, -0.1);
  test::expect_same(hat().nearest({0, 0, -h}), {0, 0, -h}, {0, 0, -1}, 0);
  EXPECT_NEAR(hat().nearest({0, 0, 0}).distance, -0.6, 1e-15);
  EXPECT_NEAR(hat().nearest({0, 0, h}).distance, 0, 1e-15);
  for (const Vec3& p :
       {Vec3{0, 0, 0.3}, Vec3{0, 0, h}, Vec3{r, 0, -h}, Vec3{0, 0, -0.25}, Vec3{1e-200, 0, 0}, Vec3{1e4, 2e4, 3e4}}) {
    test::expect_nearest_at(hat(), known(r, h), p);
  }
}

TEST(Cone, NearestPointOfFlatAndThinOnes) {
  const Cone disc = made<Cone>({1, 0}), needle = made<Cone>({0, 2}), nothing = made<Cone>({0, 0});
  test::expect_same(disc.nearest({0.5, 0, 2}), {0.5, 0, 0}, {0, 0, 1}, 2);
  test::expect_same(disc.nearest({0, 0, 2}), {0, 0, 0}, {0, 0, 1}, 2);
  test::expect_same(disc.nearest({0.5, 0, -1e-12}), {0.5, 0, 0}, {0, 0, -1}, 1e-12);
  test::expect_same(disc.nearest({4, 0, 0}), {1, 0, 0}, {1, 0, 0}, 3);
  test::expect_same(disc.nearest({4, 0, 4}), {1, 0, 0}, {0.6, 0, 0.8}, 5);
  EXPECT_EQ(disc.nearest({0.5, 0, 0}).distance, 0);
  test::expect_same(needle.nearest({0, 3, 1}), {0, 0, 1}, {0, 1, 0}, 3);
  test::expect_same(needle.nearest({0, 0, 5}), {0, 0, 2}, {0, 0, 1}, 3);
  test::expect_same(needle.nearest({0, 0, -5}), {0, 0, -2}, {0, 0, -1}, 3);
  test::expect_same(needle.nearest({3, 0, 6}), {0, 0, 2}, {0.6, 0, 0.8}, 5);
  EXPECT_EQ(needle.nearest({0, 0, 1}).distance, 0);
  test::expect_same(nothing.nearest({3, 0, -4}), {0, 0, 0}, {0.6, 0, -0.8}, 5);
  EXPECT_EQ(nothing.nearest({0, 0, 0}).distance, 0);
  EXPECT_NEAR(norm(nothing.nearest({0, 0, 0}).normal), 1, 1e-15);
}

TEST(Cone, RaysMeetTheFirstCrossing) {
  test::expect_rays(hat(), known(radius, half_height).outside, 1.8, 369);
  test::expect_rays(made<Cone>({0.7, 2}), known(0.7, 2).outside, 2, 370);
}

TEST(Cone, RaysNameTheFaceTheyMeet) {
  using abut::Feature, abut::FeatureKind;
  const auto along = [](int axis, double sign) {
    return abut::UnitVec3::from_unit_unchecked(test::axis_vector(axis, sign));
  };
  EXPECT_EQ(hat().cast_ray({0.5, 0, -5}, along(2, 1), 10)->distance, 4);
  EXPECT_EQ(hat().cast_ray({0.5, 0, -5}, along(2, 1), 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_EQ(hat().cast_ray({0.5, 0, -5}, along(2, 1), 10)->feature, (Feature{FeatureKind::face, 0}));
  const auto beside = hat().cast_ray({5, 0, 0}, along(0, -1), 10),
             above = hat().cast_ray({0, 0.75, 5}, along(2, -1), 10);
  EXPECT_NEAR(beside->distance, 4.25, 1e-14);
  EXPECT_LE(largest_magnitude(beside->normal - Vec3{0.8, 0, 0.6}), 1e-14);
  EXPECT_EQ(beside->feature, (Feature{FeatureKind::face, 1}));
  EXPECT_NEAR(above->distance, 5, 1e-14);
  EXPECT_LE(largest_magnitude(above->normal - Vec3{0, 0.8, 0.6}), 1e-14);
  EXPECT_NEAR(hat().cast_ray({0, 0, 0}, along(1, -1), 10)->distance, 0.75, 1e-15);
  EXPECT_EQ(hat().cast_ray({0.25, 0, 0}, along(2, -1), 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_FALSE(hat().cast_ray({5, 0, 1.1}, along(0, -1), 10).has_value());  // between the cone and its mirror image
  EXPECT_FALSE(hat().cast_ray({5, 0, 2}, along(0, -1), 10).has_value());    // through the mirror image
  EXPECT_FALSE(hat().cast_ray({1.6, 0, 5}, along(2, -1), 10).has_value());
  EXPECT_FALSE(hat().cast_ray({5, 0, 0}, along(0, -1), 4.2).has_value());
  EXPECT_FALSE(hat().cast_ray({5, 0, 0}, along(0, 1), 10).has_value());
}

// Where faces meet neither may leave the hit to the other.
TEST(Cone, RaysAtTheRimAndFromFarAwayMeetTheFirstCrossing) {
  const auto outward_at = [](double angle) { return Vec3{0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6}; };
  const auto rim = [&](test::Random& random) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    return test::Aim{{radius * std::cos(angle), radius * std::sin(angle), -half_height}, outward_at(angle), {0, 0, -1}};
  };
  const auto side = [&](test::Random& random) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), share = random.uniform(0.1, 1), r = share * radius;
    const Vec3 outward = outward_at(angle);
    return test::Aim{{r * std::cos(angle), r * std::sin(angle), half_height * (1 - 2 * share)}, outward, outward};
  };
  test::expect_rays_at(hat(), rim, 3, 1e-12, 371);
  test::expect_rays_at(hat(), side, 3, 1e-12, 372);
  test::expect_rays_at(hat(), side, 1e6, 1e-8, 373);
}

// Close to the apex both crossings of the side fall together, and the ray must not slip through to the base.
TEST(Cone, RaysAtTheApexDoNotSlipThrough) {
  test::Random random(374);
  for (const double beside : {0.0, 1e-14, 1e-11, 1e-9, 1e-6}) {
    for (int i = 0; i < 2000; ++i) {
      const double r = random.uniform(0.3, 2), h = random.uniform(0.3, 2), distance = random.uniform(0.5, 20);
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      const Vec3 target{beside * std::cos(angle), beside * std::sin(angle), h - 2 * h * beside / r};
      // Steeper than the side, so that the ray goes on within.
      const double lean = random.uniform(0, 0.8) * std::atan2(r, 2 * h), round = i % 4 == 0 ? 0 : lean;
      const double turn = random.uniform(0, 2 * std::numbers::pi);
      const Vec3 direction{std::sin(round) * std::cos(turn), std::sin(round) * std::sin(turn), -std::cos(round)};
      const auto way = abut::UnitVec3::from_unit_unchecked(direction);
      const auto hit = made<Cone>({r, h}).cast_ray(target - distance * direction, way, 100);
      ASSERT_TRUE(hit.has_value()) << "seed 374, beside " << beside << ", ray " << i;
      ASSERT_NEAR(hit->distance, distance, 1e-12)
          << "seed 374, beside " << beside << ", ray " << i << ", r " << r << ", h " << h;
    }
  }
}

TEST(Cone, RaysMeetFlatOnes) {
  const Cone disc = made<Cone>({1, 0});
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, 3}, down, 10)->distance, 3);
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, 3}, down, 10)->normal, (Vec3{0, 0, 1}));  // as of a flat box
  EXPECT_EQ(disc.cast_ray({0.5, 0.5, -3}, -down, 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_FALSE(disc.cast_ray({0.8, 0.8, 3}, down, 10).has_value());
  EXPECT_FALSE(disc.cast_ray({0.5, 0.5, 3}, -down, 10).has_value());
  EXPECT_FALSE(made<Cone>({0, 1}).cast_ray({0.1, 0, 3}, down, 10).has_value());
}

}  // namespace
