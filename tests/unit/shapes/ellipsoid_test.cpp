// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "curved_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.ellipsoid;

namespace {

using abut::Ellipsoid;
using abut::Errc;
using abut::Vec3;
using test::made;

constexpr Vec3 radii{0.5, 1, 2};

Ellipsoid with(const Vec3& r) { return made<Ellipsoid>({r.x, r.y, r.z}); }
Ellipsoid egg() { return with(radii); }

// As far from the unit ball as the point that is stretched to p, in the largest radius; beside a flat one, as
// far as from its plane.
double outside(const Vec3& r, const Vec3& p) {
  const double largest = std::fmax(r.x, std::fmax(r.y, r.z));
  double square = 0, beside = -abut::infinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (r[axis] > 0) {
      square += p[axis] * p[axis] / (r[axis] * r[axis]);
    } else {
      beside = std::fmax(beside, std::fabs(p[axis]));
    }
  }
  return std::fmax(largest * (std::sqrt(square) - 1), beside);
}

// The sides of a cube, blown up to a ball and stretched: no poles to get stuck at.
test::Known known(const Vec3& r) {
  test::Surface surface{{}, false};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      surface.patches.emplace_back([=](double u, double v) {
        const double s = 2 * u - 1, t = 2 * v - 1, length = std::hypot(1, s, t);
        const Vec3 ball = axis == 0 ? Vec3{side, s, t} : axis == 1 ? Vec3{t, side, s} : Vec3{s, t, side};
        return Vec3{r.x * ball.x / length, r.y * ball.y / length, r.z * ball.z / length};
      });
    }
  }
  return {surface, [=](const Vec3& p) { return outside(r, p); },
          [=](const Vec3& d) { return std::hypot(r.x * d.x, r.y * d.y, r.z * d.z); },
          std::fmax(r.x, std::fmax(r.y, r.z))};
}

TEST(Ellipsoid, KeepsItsRadii) {
  EXPECT_EQ(egg().parameters(), (std::vector{0.5, 1.0, 2.0}));
  EXPECT_EQ(egg().radius(), 0);
  EXPECT_EQ(egg().extent(), 2);
}

TEST(Ellipsoid, BadInputIsRefusedByName) {
  test::expect_refused<Ellipsoid>({-1, 1, 1}, {}, {}, Errc::out_of_range,
                                  "radius_x is -1; it must be zero or positive");
  test::expect_refused<Ellipsoid>({1, -2, 1}, {}, {}, Errc::out_of_range,
                                  "radius_y is -2; it must be zero or positive");
  test::expect_refused<Ellipsoid>({1, 1, 2e70}, {}, {}, Errc::out_of_range,
                                  "radius_z is 2e+70; it must be at most 1e70");
  test::expect_refused<Ellipsoid>({1, 1, std::numeric_limits<double>::infinity()}, {}, {}, Errc::not_finite,
                                  "radius_z is inf; it must be finite");
  test::expect_refused<Ellipsoid>({1, 1}, {}, {}, Errc::invalid_argument, "parameter_count is 2; it must be 3");
  test::expect_refused<Ellipsoid>({1, 1, 1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Ellipsoid>({1, 1, 1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Ellipsoid, BoxIsTight) {
  for (const Vec3& r : {radii, Vec3{1, 0.5, 0}, Vec3{0, 0, 2}, Vec3{0, 0, 0}}) {
    const auto reach = [&](const abut::Pose& pose, const Vec3& direction) {
      return dot(pose.position, direction) + known(r).reach(pose.rotation.undo(direction));
    };
    test::expect_tight_boxes(with(r), reach, 2, 381);
  }
}

TEST(Ellipsoid, SupportIsTheImageOfThatOfTheBall) {
  for (const Vec3& r : {radii, Vec3{1, 1, 1}, Vec3{1e-3, 1e-3, 10}, Vec3{1, 0.5, 0}, Vec3{0, 0, 2}}) {
    test::expect_curved_support(with(r), known(r), 382);
  }
  EXPECT_EQ(egg().support({1, 2, 3}).index, abut::no_index);
  EXPECT_EQ(with({1, 0.5, 0}).support({0, 0, 1}).point, (Vec3{0, 0, 0}));
}

TEST(Ellipsoid, FaceIsItsSupportPoint) {
  test::expect_curved_faces(egg(), known(radii), 0, 383);
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{-3, 2, 1}, Vec3{0, 1e-200, 0}}) {
    const abut::Face face = egg().supporting_face(direction);
    ASSERT_EQ(face.vertices.size(), 1u);
    EXPECT_EQ(face.normal, (Vec3{0, 0, 0}));
    EXPECT_EQ(abut::supporting_feature(egg(), direction), abut::feature_of(face));
  }
  EXPECT_EQ(egg().supporting_face({0, -1e-200, 0}).vertices[0].point.y, -1);
}

TEST(Ellipsoid, NearestPointIsThatOfASearch) {
  for (const Vec3& r : {radii, Vec3{2, 1, 0.5}, Vec3{1, 1, 1}, Vec3{1, 1, 0.1}, Vec3{0.2, 1, 1}, Vec3{0.05, 0.05, 3}}) {
    test::expect_nearest(with(r), known(r), 384);
  }
}

TEST(Ellipsoid, NearestPointByHand) {
  test::expect_same(egg().nearest({0, 0, 5}), {0, 0, 2}, {0, 0, 1}, 3);
  test::expect_same(egg().nearest({0, -4, 0}), {0, -1, 0}, {0, -1, 0}, 3);
  test::expect_same(egg().nearest({0.25, 0, 0}), {0.5, 0, 0}, {1, 0, 0}, -0.25);
  EXPECT_EQ(egg().nearest({0, 0, 0}).distance, -0.5);
  EXPECT_EQ(std::fabs(egg().nearest({0, 0, 0}).point.x), 0.5);
  // On the long axis inside the nearest point leaves the axis where 4 z < 15: sin(t) = 2 z / 3.75 on the
  // ellipse of radii 0.5 and 2.
  for (const double z : {0.3, 1.0, 1.8}) {
    const double sine = 2 * z / 3.75, cosine = std::sqrt(1 - sine * sine);
    const abut::SurfacePoint found = egg().nearest({0, 0, z});
    EXPECT_NEAR(found.point.z, 2 * sine, 1e-14);
    EXPECT_NEAR(std::fabs(found.point.x), 0.5 * cosine, 1e-14);
    EXPECT_NEAR(found.distance, -std::hypot(2 * sine - z, 0.5 * cosine), 1e-14);
  }
  test::expect_same(egg().nearest({0, 0, 1.9}), {0, 0, 2}, {0, 0, 1}, 1.9 - 2);
  test::expect_same(with({2, 2, 2}).nearest({3, 0, 4}), {1.2, 0, 1.6}, {0.6, 0, 0.8}, 3);
  test::expect_same(with({2, 2, 2}).nearest({0.3, 0, -0.4}), {1.2, 0, -1.6}, {0.6, 0, -0.8}, -1.5);
  EXPECT_EQ(with({2, 2, 2}).nearest({0, 0, 0}).distance, -2);
  test::expect_nearest_at(egg(), known(radii), {1e4, 2e4, 3e4});
}

// Inside, on planes of symmetry and next to them by as little as can be.
TEST(Ellipsoid, NearestPointNextToPlanesOfSymmetry) {
  test::Random random(385);
  for (const Vec3& r : {radii, Vec3{2, 0.5, 1}, Vec3{1, 2, 0.5}}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = random.point(1.5);
      for (const double beside : {0.0, 1e-300, 1e-200, 1e-20, 1e-17, 1e-16, 1e-13, 1e-10, 1e-6}) {
        for (int axis = 0; axis < 3; ++axis) {
          SCOPED_TRACE(::testing::Message() << "seed 385, beside " << beside << ", axis " << axis);
          const auto of = [&](int k) { return k == axis ? beside : p[k]; };
          ASSERT_NO_FATAL_FAILURE(test::expect_nearest_at(with(r), known(r), {of(0), of(1), of(2)}));
        }
      }
    }
  }
}

TEST(Ellipsoid, NearestPointOfFlatAndThinOnes) {
  for (const Vec3& r : {Vec3{1, 0.5, 0}, Vec3{0, 1, 2}, Vec3{0, 0, 2}, Vec3{0, 1, 0}, Vec3{0, 0, 0}}) {
    SCOPED_TRACE(::testing::Message() << "radii " << r.x << ", " << r.y << ", " << r.z);
    test::Known flat = known(r);
    flat.size = 2;
    test::Random random(386);
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = random.point(3);
      test::expect_nearest_at(with(r), flat, p);
      test::expect_nearest_at(with(r), flat, {r.x > 0 ? p.x : 0, r.y > 0 ? p.y : 0, r.z > 0 ? p.z : 0});
    }
    test::expect_nearest_at(with(r), flat, {0, 0, 0});
    test::expect_nearest_at(with(r), flat, r);
  }
  test::expect_same(with({1, 0.5, 0}).nearest({0.5, 0, -2}), {0.5, 0, 0}, {0, 0, -1}, 2);
  test::expect_same(with({1, 0.5, 0}).nearest({4, 0, 0}), {1, 0, 0}, {1, 0, 0}, 3);
  test::expect_same(with({0, 0, 2}).nearest({3, 0, 1}), {0, 0, 1}, {1, 0, 0}, 3);
  test::expect_same(with({0, 0, 2}).nearest({3, 0, 6}), {0, 0, 2}, {0.6, 0, 0.8}, 5);
  test::expect_same(with({0, 0, 0}).nearest({3, 0, -4}), {0, 0, 0}, {0.6, 0, -0.8}, 5);
}

// From points in the ellipsoid and beside it by rounding: whichever way the normal points, nothing lies further out.
TEST(Ellipsoid, NormalOfFlatOnesIsAcrossThem) {
  test::Random random(391);
  for (const Vec3& r : {Vec3{1.5, 0, 1.25}, Vec3{1.3, 1.4, 0}, Vec3{0, 0.3, 7}, Vec3{0, 0, 2}, Vec3{0, 1.3, 0},
                        Vec3{1e-3, 0, 0}, Vec3{0, 0, 0}}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 ball = random.point(0.57);
      const double beside = i % 3 == 0 ? 0 : i % 3 == 1 ? 1e-17 : 1e-300;
      const auto part = [&](int axis) { return r[axis] > 0 ? r[axis] * ball[axis] : beside; };
      const Vec3 p{part(0), part(1), part(2)};
      const abut::SurfacePoint found = with(r).nearest(p);
      ASSERT_NEAR(norm(found.normal), 1, 1e-15) << "seed 391, point " << i;
      ASSERT_EQ(known(r).reach(found.normal), 0) << "seed 391, point " << i;
      ASSERT_LE(norm(found.point - p), 4e-15) << "seed 391, point " << i;
    }
  }
  EXPECT_EQ(with({1.5, 0, 1.25}).nearest({1.28, 0, 0.625}).normal, (Vec3{0, 1, 0}));
}

TEST(Ellipsoid, RaysMeetTheFirstCrossing) {
  test::expect_rays(egg(), known(radii).outside, 1.5, 387);
  test::expect_rays(with({2, 2, 0.5}), known({2, 2, 0.5}).outside, 2, 388);
}

TEST(Ellipsoid, RaysAlongTheAxes) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto inward = abut::UnitVec3::from_unit_unchecked(test::axis_vector(axis, -1));
    const auto hit = egg().cast_ray(test::axis_vector(axis, 5), inward, 10);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 5 - radii[axis], 2e-15);
    EXPECT_EQ(hit->normal, test::axis_vector(axis, 1));
    EXPECT_EQ(hit->feature, (abut::Feature{abut::FeatureKind::whole, 0}));
    EXPECT_NEAR(egg().cast_ray({0, 0, 0}, inward, 10)->distance, radii[axis], 1e-15);
    EXPECT_EQ(egg().cast_ray({0, 0, 0}, inward, 10)->normal, test::axis_vector(axis, -1));
    EXPECT_FALSE(egg().cast_ray(test::axis_vector(axis, 5), inward, 0.99 * (5 - radii[axis])).has_value());
    EXPECT_FALSE(egg().cast_ray(test::axis_vector(axis, 5), -inward, 10).has_value());
  }
  const auto along_x = abut::UnitVec3::from_unit_unchecked({1, 0, 0});
  EXPECT_EQ(egg().cast_ray({-5, 0, 2}, along_x, 10)->distance, 5);  // touching counts
  EXPECT_FALSE(egg().cast_ray({-5, 0, 2.001}, along_x, 10).has_value());
}

TEST(Ellipsoid, RaysFromFarAwayKeepTheirDigits) {
  const auto aimed = [](test::Random& random) {
    const Vec3 ball = test::towards(random);
    const Vec3 outward = abut::UnitVec3::make({ball.x / radii.x, ball.y / radii.y, ball.z / radii.z}).value();
    return test::Aim{{ball.x * radii.x, ball.y * radii.y, ball.z * radii.z}, outward, outward};
  };
  test::expect_rays_at(egg(), aimed, 3, 1e-13, 389);
  test::expect_rays_at(egg(), aimed, 1e6, 1e-8, 390);
}

TEST(Ellipsoid, RaysMeetFlatOnes) {
  const Ellipsoid disc = with({1, 0.5, 0});
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  EXPECT_EQ(disc.cast_ray({0.5, 0.25, 3}, down, 10)->distance, 3);
  EXPECT_EQ(disc.cast_ray({0.5, 0.25, 3}, down, 10)->normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(disc.cast_ray({0.5, 0.25, -3}, -down, 10)->normal, (Vec3{0, 0, -1}));  // as of a flat box
  EXPECT_FALSE(disc.cast_ray({0.5, 0.45, 3}, down, 10).has_value());
  EXPECT_FALSE(disc.cast_ray({0.5, 0.25, 3}, down, 2.9).has_value());
  EXPECT_FALSE(disc.cast_ray({0.5, 0.25, 3}, -down, 10).has_value());
  EXPECT_FALSE(disc.cast_ray({-3, 0, 0}, abut::UnitVec3::from_unit_unchecked({1, 0, 0}), 10).has_value());
  // Along the disc, however far and whatever the sign of nothing.
  EXPECT_FALSE(
      disc.cast_ray({-3, 0, 1}, abut::UnitVec3::from_unit_unchecked({1, 0, -0.0}), abut::infinity).has_value());
  EXPECT_FALSE(disc.cast_ray({-3, 0, -1}, abut::UnitVec3::from_unit_unchecked({1, 0, 0}), abut::infinity).has_value());
  EXPECT_FALSE(with({0, 0, 1}).cast_ray({0, 0, 3}, down, 10).has_value());
}

}  // namespace
