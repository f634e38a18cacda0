// SPDX-License-Identifier: Apache-2.0
// Cylinders and cones whose sides lie along edges, and points of contacts of hulls that are nearly flat.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "../support.hpp"

namespace {

using namespace abut_test;

abut_quat turn_about(const abut_vec3& axis, double angle) {
  const double sine = std::sin(angle / 2);
  return {std::cos(angle / 2), sine * axis.x, sine * axis.y, sine * axis.z};
}

abut_vec3 turned(const abut_quat& q, const abut_vec3& v) {
  const abut_vec3 t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

// A body along the edge x = y = 0 of a wedge that lies at x < 0, the whole scene turned.
struct Scene {
  Shape wedge = make_of_kind("hull", {}, {0, 0, -1, 0, 0, 1, -1, 0.5, -1, -1, 0.5, 1, -1, -0.5, -1, -1, -0.5, 1});
  abut_quat turn;

  std::vector<abut_contact> contacts(const abut_shape* body, const abut_pose& pose, double margin) const {
    const abut_quat& p = pose.orientation;
    const abut_quat q{turn.w * p.w - turn.x * p.x - turn.y * p.y - turn.z * p.z,
                      turn.w * p.x + turn.x * p.w + turn.y * p.z - turn.z * p.y,
                      turn.w * p.y - turn.x * p.z + turn.y * p.w + turn.z * p.x,
                      turn.w * p.z + turn.x * p.y - turn.y * p.x + turn.z * p.w};
    return contacts_of(wedge, {{0, 0, 0}, turn}, body, {turned(turn, pose.position), q}, margin);
  }
};

void expect_line(const Scene& scene, const std::vector<abut_contact>& found, double gap, double low, double high) {
  ASSERT_EQ(found.size(), 2U);
  const abut_vec3 along = turned(scene.turn, {0, 0, 1}), outward = turned(scene.turn, {1, 0, 0});
  std::vector<double> heights;
  for (const abut_contact& contact : found) {
    const abut_vec3 &n = contact.normal, &p = contact.point_a;
    heights.push_back(p.x * along.x + p.y * along.y + p.z * along.z);
    EXPECT_NEAR(n.x * outward.x + n.y * outward.y + n.z * outward.z, 1, 1e-14);
    EXPECT_NEAR(contact.distance, gap, 1e-9);
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_NEAR(heights[0], low, 1e-8);
  EXPECT_NEAR(heights[1], high, 1e-8);
}

TEST(SideAlongAnEdge, OfACylinderHasTwoContacts) {
  Scene scene{.turn = turn_about({1, 0, 0}, 0.1)};
  expect_line(scene, scene.contacts(make_of_kind("cylinder", {0.5, 1}), at(0.49, 0, 0.5), 0), -0.01, -0.5, 1);
}

TEST(SideAlongAnEdge, HasTwoContactsHoweverItIsTurned) {
  constexpr std::uint32_t seed = 31;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  const Shape cylinder = make_of_kind("cylinder", {0.5, 1});
  // The side of this cone is 2 long and leans by as much as its apex is half as wide. Turned about y, it stands where
  // the edge is, from z = -0.86 on.
  const Shape cone = make_of_kind("cone", {1.2, 0.8});
  const double lean = std::atan2(1.2, 1.6), beside = 0.6 * std::cos(lean);
  for (const double gap : {-0.1, -0.01, -1e-6, 1e-9, 1e-6, 0.01}) {
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(testing::Message() << "gap " << gap << ", turn " << i);
      const double a = angle(random), b = angle(random);
      Scene scene{.turn = turn_about({std::cos(a), std::sin(a), 0}, b)};
      const double margin = 0.02;
      expect_line(scene, scene.contacts(cylinder, at(0.5 + gap, 0, 0.5), margin), gap, -0.5, 1);
      const abut_pose pose{{beside + gap, 0, 0.5}, turn_about({0, 1, 0}, -lean)};
      expect_line(scene, scene.contacts(cone, pose, margin), gap, -0.86, 1);
    }
  }
}

// Points of contacts lie on the shapes that they are of.
void expect_on_shapes(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b) {
  const Shape point = make_of_kind("point", {});
  for (const abut_contact& contact : contacts_of(a, pose_a, b, pose_b)) {
    EXPECT_LE(distance_of(a, pose_a, point, {contact.point_a, no_rotation}), 1e-8);
    EXPECT_LE(distance_of(b, pose_b, point, {contact.point_b, no_rotation}), 1e-8);
  }
}

TEST(ThinHull, HasItsContactsOnItself) {
  const Shape hull = make_of_kind("hull", {},
                                  {-0.7000000000000001,
                                   0.9,
                                   6.111555803909597e-13,
                                   -0.7000000000000001,
                                   0.7000000000000001,
                                   -4.2295596786666455e-13,
                                   -0.7000000000000001,
                                   0.4,
                                   -6.304099946664455e-13,
                                   0.1,
                                   0.30000000000000004,
                                   -2.3152354432164767e-13,
                                   0.8,
                                   0.30000000000000004,
                                   3.242780515871387e-13,
                                   -0.9,
                                   -0.8,
                                   2.65186684229551e-13,
                                   -0.8,
                                   -0.8,
                                   -3.6423699261979234e-13});
  const abut_pose pose{{0.05504031956656397, 0.42617386488329834, 0.38393775674377273},
                       {0.21977153099071228, 0.25431620886343226, -0.9386813537294513, 0.07681833268155712}};
  expect_on_shapes(hull, pose, make_of_kind("cylinder", {0.8419679313757767, 0.5698125682115136}), identity);
}

TEST(ThinHull, HasItsContactsOnItselfWhereverItIs) {
  constexpr std::uint32_t seed = 32;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(testing::Message() << "pair " << i);
    const double thickness = std::pow(10, -12 + number());
    std::vector<double> xyz;
    for (int corner = 0; corner < 7; ++corner) {
      xyz.insert(xyz.end(), {std::round(10 * number()) / 10, std::round(10 * number()) / 10, thickness * number()});
    }
    const double w = number(), x = number(), y = number(), z = number(),
                 length = std::hypot(std::hypot(w, x), std::hypot(y, z));
    const abut_pose pose{{0.6 * number(), 0.6 * number(), 0.6 * number()},
                         {w / length, x / length, y / length, z / length}};
    const Shape hull = make_of_kind("hull", {}, xyz);
    expect_on_shapes(hull, pose,
                     make_of_kind(i % 2 == 0 ? "cylinder" : "cone", {0.9 + 0.4 * number(), 0.9 + 0.4 * number()}),
                     identity);
  }
}

}  // namespace
