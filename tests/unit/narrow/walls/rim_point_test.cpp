// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "../../made.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.walls.rim_point;
import abut.shapes.box;

namespace {

using abut::Distance;
using abut::RimContact;
using abut::Vec3;

constexpr double noise = 1e-14;

// From a body to a point.
Distance of_surface(const Vec3& on_surface, const Vec3& point, const Vec3& outward, double distance) {
  Distance found{};
  found.distance = found.lower = found.upper = distance;
  found.point_a = on_surface;
  found.point_b = point;
  found.normal = outward;
  return found;
}
std::optional<Distance> to_plane(const Vec3& point, const Vec3& normal, double offset) {
  const double height = dot(normal, point) - offset;
  return of_surface(point - height * normal, point, normal, height);
}
// Around Z, seen from inside.
std::optional<Distance> to_cavity(const Vec3& point, double radius) {
  const Vec3 across{point.x, point.y, 0};
  const Vec3 outward = (1 / norm(across)) * across;
  return of_surface(radius * outward + Vec3{0, 0, point.z}, point, -outward, radius - norm(across));
}
// From a point to a body.
std::optional<Distance> from_point(Distance found) {
  std::swap(found.point_a, found.point_b);
  found.normal = -found.normal;
  return found;
}

// A ball over the edge of a step, which is the line y = z = 0: nearest where the centre is.
TEST(RimPoint, IsNearestUnderTheCentreOfABall) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 centre{number(random), number(random), number(random)};
    const double radius = 0.01 + 2 * std::fabs(number(random));
    const auto rim_near = [&](const Vec3& place) {
      return abut::rim_point_near(
          place, noise, [](const Vec3& p) { return to_plane(p, {0, 0, 1}, 0); },
          [](const Vec3& p) { return to_plane(p, {0, 0.6, 0.8}, 0); });
    };
    const auto to_ball = [&](const Vec3& p) {
      const double far = norm(p - centre);
      const Vec3 outward = (1 / far) * (p - centre);
      return from_point(of_surface(centre + radius * outward, p, outward, far - radius));
    };
    const auto start = rim_near({4 * number(random), number(random), number(random)});
    ASSERT_TRUE(start);
    const RimContact found =
        abut::nearest_on_rim({*start, *to_ball(start->place)}, 2 * radius, noise, rim_near, to_ball);
    EXPECT_NEAR(found.found.distance, std::hypot(centre.y, centre.z) - radius, 1e-13);
    EXPECT_NEAR(found.rim.place.x, centre.x, 1e-5) << "where the distance has its flat bottom";
  }
}

// A box in a round hole through a plate, whose rim is the unit circle: least at a corner of the distance, where another
// face of the box comes nearest. Compared with many points of the rim.
TEST(RimPoint, IsDeepestWhereAnotherFaceComesNearest) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  int deep = 0, found_least = 0;
  for (int i = 0; i < 300; ++i) {
    const auto box = test::made<abut::Box>({0.6, 0.5, 0.4});
    const abut::Pose pose{abut::Rotation::from({number(random), number(random), number(random), 1.5}),
                          {0.9 + 0.3 * number(random), 0.3 * number(random), 0.3 * number(random)}};
    const auto rim_near = [&](const Vec3& place) {
      return abut::rim_point_near(
          place, noise, [](const Vec3& p) { return to_plane(p, {0, 0, 1}, 0); },
          [](const Vec3& p) { return to_cavity(p, 1); });
    };
    const auto to_box = [&](const Vec3& p) {
      const abut::SurfacePoint near = box.nearest(pose.undo(p));
      return from_point(of_surface(pose * near.point, p, pose.rotation * near.normal, near.distance));
    };
    constexpr int count = 4000;
    double least = 1e9, at = 0;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / count;
      const double distance = to_box({std::cos(angle), std::sin(angle), 0})->distance;
      at = distance < least ? angle : at;
      least = std::min(least, distance);
    }
    const auto start = rim_near({std::cos(at + 0.2 * number(random)), std::sin(at + 0.2 * number(random)), 0});
    ASSERT_TRUE(start);
    const RimContact found = abut::nearest_on_rim({*start, *to_box(start->place)}, 1.2, noise, rim_near, to_box);
    found_least += found.found.distance <= least + 1e-12 ? 1 : 0;
    const double turned = std::atan2(found.rim.place.y, found.rim.place.x);
    for (int k = -1000; k <= 1000; ++k) {
      const double angle = turned + 1e-5 * k;
      EXPECT_GE(to_box({std::cos(angle), std::sin(angle), 0})->distance, found.found.distance - 1e-13) << i;
    }
    EXPECT_NEAR(std::hypot(found.rim.place.x, found.rim.place.y), 1, 1e-12);
    deep += least < 0 ? 1 : 0;
  }
  EXPECT_GT(deep, 100);
  EXPECT_GE(found_least, 250);
}

TEST(RimPoint, IsNoneWhereSurfacesDoNotCross) {
  const auto plane = [](const Vec3& p) { return to_plane(p, {0, 0, 1}, 0); };
  const auto above = [](const Vec3& p) { return to_plane(p, {0, 0, 1}, 1); };
  EXPECT_FALSE(abut::rim_point_near({0, 0, 0}, noise, plane, above));
  EXPECT_FALSE(abut::rim_point_near({0, 0, 0}, noise, plane,
                                    [](const Vec3&) -> std::optional<Distance> { return std::nullopt; }));
}

}  // namespace
