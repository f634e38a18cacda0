// SPDX-License-Identifier: Apache-2.0
// The judge of contacts of surfaces on scenes that a sheet of paper solves, with right answers and wrong ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "exact.hpp"
#include "surface_judge.hpp"
#include "winding.hpp"

namespace {

using oracle::Fault;
using oracle::Meeting;
using oracle::Part;
using oracle::Pose;
using oracle::quad;
using oracle::Side;
using oracle::Soup;
using oracle::Touch;
using oracle::Triple;
using oracle::Vec;

constexpr oracle::Doubt doubt{1e-12, 1e-12, 1e-6};

Pose at(double x, double y, double z) { return Pose::from({x, y, z}, {1, 0, 0, 0}); }
Vec vec(double x, double y, double z) { return {quad(x), quad(y), quad(z)}; }

const Soup square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

struct Scene {
  Side a, b;
  Meeting meeting = oracle::meeting_of(a, b);
};

Scene scene_of(const Soup& soup, bool is_one_sided, const oracle::Body& body, const Pose& pose) {
  return {side_of(soup, is_one_sided, at(0, 0, 0), {}), side_of(body, pose, {})};
}

std::vector<std::string> faults(const Scene& scene, const std::vector<Touch>& contacts, double margin = 0) {
  std::vector<std::string> facts;
  const Meeting meeting = oracle::meeting_of(scene.a, scene.b, margin);
  for (const Fault& fault : judge_surface_contacts(scene.a, scene.b, meeting, contacts, margin, doubt)) {
    facts.push_back(fault.fact);
  }
  return facts;
}

bool has(const std::vector<std::string>& facts, const std::string& fact) { return std::ranges::count(facts, fact) > 0; }

// A ball that is sunk into the square by 0.2, away from the diagonal.
Scene ball() { return scene_of(square, false, oracle::make_sphere(0.5), at(0.6, 0.3, 0.3)); }
Touch touch_of_ball() { return {vec(0.6, 0.3, 0), vec(0.6, 0.3, -0.2), vec(0, 0, 1), -0.2}; }

TEST(SurfaceJudge, TakesTheRightContactOfABall) { EXPECT_TRUE(faults(ball(), {touch_of_ball()}).empty()); }

TEST(SurfaceJudge, RefusesNoContact) { EXPECT_TRUE(has(faults(ball(), {}), "a contact where shapes overlap")); }

TEST(SurfaceJudge, RefusesNoContactWithinTheMargin) {
  const Scene above = scene_of(square, false, oracle::make_sphere(0.5), at(0.6, 0.3, 0.75));
  EXPECT_TRUE(faults(above, {}, 0.2).empty());
  EXPECT_TRUE(has(faults(above, {}, 0.3), "a contact within the margin"));
}

TEST(SurfaceJudge, RefusesAContactOfShapesThatAreApart) {
  const Scene above = scene_of(square, false, oracle::make_sphere(0.5), at(0.6, 0.3, 0.75));
  const Touch nearest{vec(0.6, 0.3, 0), vec(0.6, 0.3, 0.25), vec(0, 0, 1), 0.25};
  EXPECT_TRUE(faults(above, {nearest}, 0.3).empty());
  EXPECT_TRUE(has(faults(above, {nearest}, 0.2), "no contact of shapes that are apart"));
  Touch further = nearest;
  further.point_b.z += quad(0.01);
  further.distance += 0.01;
  EXPECT_TRUE(has(faults(above, {further}, 0.3), "a contact as near as the nearest parts"));
}

TEST(SurfaceJudge, RefusesALesserDepth) {
  Touch wrong = touch_of_ball();
  wrong.point_b.z += quad(1e-9);
  wrong.distance += 1e-9;
  EXPECT_TRUE(has(faults(ball(), {wrong}), "a contact as deep as each two parts"));
}

TEST(SurfaceJudge, RefusesAGreaterDepth) {
  Touch wrong = touch_of_ball();
  wrong.point_b.z -= quad(1e-5);
  wrong.distance -= 1e-5;
  EXPECT_TRUE(has(faults(ball(), {wrong}), "no contact deeper than a way out"));
}

TEST(SurfaceJudge, RefusesPointsThatDoNotGiveTheDistance) {
  Touch wrong = touch_of_ball();
  wrong.distance = -0.2 - 1e-9;
  EXPECT_TRUE(has(faults(ball(), {wrong}), "points that give the distance"));
  wrong.distance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(has(faults(ball(), {wrong}), "points that give the distance"));
}

TEST(SurfaceJudge, RefusesANegatedNormal) {
  Touch wrong = touch_of_ball();
  wrong.normal = -wrong.normal;
  EXPECT_TRUE(has(faults(ball(), {wrong}), "points that give the distance"));
}

TEST(SurfaceJudge, RefusesALongNormal) {
  Touch wrong = touch_of_ball();
  wrong.normal = vec(0, 0, 1 + 1e-14);
  EXPECT_TRUE(has(faults(ball(), {wrong}), "a unit normal"));
}

TEST(SurfaceJudge, RefusesPointsOffTheSurfaces) {
  Touch aside = touch_of_ball();
  aside.point_a.x += quad(1e-6);
  EXPECT_TRUE(has(faults(ball(), {aside}), "points across each other"));
  Touch above = touch_of_ball();
  above.point_a.z += quad(1e-9);
  above.point_b.z += quad(1e-9);
  EXPECT_TRUE(has(faults(ball(), {above}), "point_a on its surface"));
  EXPECT_TRUE(has(faults(ball(), {above}), "point_b on its surface"));
}

// At a point within a face, by a thousandth.
TEST(SurfaceJudge, RefusesANormalThatLeans) {
  const Vec normal = oracle::unit(vec(1e-3, 0, 1)), centre = vec(0.6, 0.3, 0.3);
  const double to_sheet = 0.3 / static_cast<double>(normal.z);
  const Touch wrong{centre - normal * quad(to_sheet), centre - normal * quad(0.5), normal, to_sheet - 0.5};
  EXPECT_TRUE(has(faults(ball(), {touch_of_ball(), wrong}), "a normal of the surface"));
  // A way out by itself, longer by half a millionth.
  const double depth = 0.2 / static_cast<double>(normal.z) + 1e-12;
  const Touch way_out{wrong.point_a, wrong.point_a - normal * quad(depth), normal, -depth};
  EXPECT_TRUE(has(faults(ball(), {way_out}), "a normal of the surface"));
}

// A roof whose ridge lies along Y, and slopes down to both sides.
const Soup roof{{{-1, -1, -1}, {0, -1, 0}, {1, -1, -1}, {-1, 1, -1}, {0, 1, 0}, {1, 1, -1}},
                {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
// The same turned upside down: a valley.
const Soup valley{{{-1, -1, 1}, {0, -1, 0}, {1, -1, 1}, {-1, 1, 1}, {0, 1, 0}, {1, 1, 1}},
                  {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};

TEST(SurfaceJudge, TakesNormalsBetweenTheFacesOfARidge) {
  const Side ridge = side_of(roof, false, at(0, 0, 0), {});
  for (const double lean : {-0.9, -0.5, 0.0, 0.3, 0.99}) {
    EXPECT_EQ(static_cast<double>(off_cone(ridge, vec(0, 0.1, 0), oracle::unit(vec(lean, 0, 1)), quad(1e-12))), 0)
        << lean;
  }
  for (const double lean : {-1.2, 1.1, 3.0}) {
    EXPECT_GT(static_cast<double>(off_cone(ridge, vec(0, 0.1, 0), oracle::unit(vec(lean, 0, 1)), quad(1e-12))), 0.04)
        << lean;
  }
  EXPECT_EQ(static_cast<double>(off_cone(ridge, vec(0, 0.1, 0.1), vec(0, 0, 1), quad(1e-12))), 2);
}

// A valley is met at its faces alone: between their normals nothing leads out of both.
TEST(SurfaceJudge, RefusesNormalsBetweenTheFacesOfAValley) {
  const Side groove = side_of(valley, false, at(0, 0, 0), {});
  EXPECT_GT(static_cast<double>(off_cone(groove, vec(0, 0.1, 0), vec(0, 0, 1), quad(1e-12))), 0.5);
  EXPECT_LT(static_cast<double>(off_cone(groove, vec(0, 0.1, 0), oracle::unit(vec(1, 0, 1)), quad(1e-12))), 1e-12);
}

TEST(SurfaceJudge, RefusesThePushThroughAFront) {
  const Scene scene = scene_of(square, true, oracle::make_sphere(0.5), at(0.6, 0.3, 0.3));
  EXPECT_TRUE(faults(scene, {touch_of_ball()}).empty());
  const Touch through{vec(0.6, 0.3, 0), vec(0.6, 0.3, 0.8), vec(0, 0, -1), -0.8};
  EXPECT_TRUE(has(faults(scene, {through}), "a normal to the front"));
}

// A ball of radius 1 whose centre is 1 above the ground of the valley: 1 - sqrt(1/2) deep in each slope. It is free
// when the centre has risen to sqrt(2).
TEST(SurfaceJudge, BoundsTheDepthInAValleyFromBothSides) {
  const Scene scene = scene_of(valley, false, oracle::make_sphere(1), at(0, 0.1, 1));
  EXPECT_NEAR(static_cast<double>(least_depth(scene.meeting)), 1 - std::sqrt(0.5), 1e-15);
  const oracle::WayOut way = shortest_way_out(scene.a, scene.b, scene.meeting, {});
  ASSERT_TRUE(way.is_known);
  EXPECT_NEAR(static_cast<double>(way.depth), std::sqrt(2.0) - 1, 1e-5);
  EXPECT_GE(static_cast<double>(way.depth), std::sqrt(2.0) - 1);
}

// A cube of half extent 0.25 that stands 0.1 deep in the square, whose sides are further away.
TEST(SurfaceJudge, KnowsTheDepthOfABoxInASquare) {
  const Scene scene = scene_of(square, false, oracle::make_box(0.25, 0.25, 0.25), at(0.5, 0.5, 0.15));
  EXPECT_NEAR(static_cast<double>(least_depth(scene.meeting)), 0.1, 1e-15);
  const oracle::WayOut way = shortest_way_out(scene.a, scene.b, scene.meeting, {});
  EXPECT_NEAR(static_cast<double>(way.depth), 0.1, 1e-12);
}

// Two squares that cross at a right angle; the second one reaches 0.1 below the first.
TEST(SurfaceJudge, KnowsTheDepthOfTwoSurfaces) {
  const Soup wall{{{0.2, 0.5, -0.1}, {0.8, 0.5, -0.1}, {0.8, 0.5, 0.9}, {0.2, 0.5, 0.9}}, {{0, 1, 2}, {0, 2, 3}}};
  const Scene scene{side_of(square, false, at(0, 0, 0), {}), side_of(wall, false, at(0, 0, 0), {})};
  EXPECT_NEAR(static_cast<double>(least_depth(scene.meeting)), 0.1, 1e-15);
  EXPECT_NEAR(static_cast<double>(shortest_way_out(scene.a, scene.b, scene.meeting, {}).depth), 0.1, 1e-12);
  const Touch right{vec(0.5, 0.5, 0), vec(0.5, 0.5, -0.1), vec(0, 0, 1), -0.1};
  EXPECT_TRUE(faults(scene, {right}).empty());
  const Touch off_wall{vec(0.5, 0.4, 0), vec(0.5, 0.4, -0.1), vec(0, 0, 1), -0.1};
  EXPECT_TRUE(has(faults(scene, {off_wall}), "point_b on its surface"));
}

// A ball within a closed cube: no triangle is near, and the cube holds it.
TEST(SurfaceJudge, RefusesNoContactOfWhatIsInsideASolid) {
  const std::vector<double> xyz{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
  const std::vector<std::uint32_t> corners{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                           2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 3, 0, 4, 3, 4, 7};
  Soup cube;
  for (std::size_t i = 0; i < xyz.size(); i += 3) cube.points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    cube.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  const Vec centre = vec(0.3, 0, 0);
  const Scene scene = scene_of(cube, false, oracle::make_sphere(0.1), at(0.3, 0, 0));
  const oracle::Holds holds = [&](const Vec& move) {
    return oracle::winding_number(xyz, corners, centre + move) > 0.5L;
  };
  const auto none = judge_surface_contacts(scene.a, scene.b, scene.meeting, {}, 0, doubt, holds);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none.front().fact, "a contact of what is inside");
  EXPECT_NEAR(static_cast<double>(shortest_way_out(scene.a, scene.b, scene.meeting, {}, holds).depth), 0.8, 1e-6);
  const oracle::Inside is_inside = [&](const Vec& point) { return holds(point - centre); };
  EXPECT_NEAR(static_cast<double>(depth_of_points(scene.a, scene.b, is_inside)), 0.8, 1e-15);
}

TEST(ExactMeeting, TellsTheSideOfAPlaneWhereRoundingDoesNot) {
  const Vec a = vec(0, 0, 0), b = vec(1, 0, 0), c = vec(0, 1, 0);
  EXPECT_EQ(oracle::side_of_plane(a, b, c, vec(0.1, 0.1, 1e-300)), 1);
  EXPECT_EQ(oracle::side_of_plane(a, b, c, vec(0.1, 0.1, -1e-300)), -1);
  EXPECT_EQ(oracle::side_of_plane(a, b, c, vec(3, -7, 0)), 0);
  // Far away and askew: 113 bits of the products are not enough.
  const double one = 1, far = 0x1p52, step = 0x1p-50;
  const Vec p = vec(far, one, 0), q = vec(one, far, step), r = vec(-far, far, one);
  const Vec middle = (p + q) * quad(0.5);
  EXPECT_EQ(oracle::side_of_plane(p, q, r, middle), 0);
  EXPECT_NE(oracle::side_of_plane(p, q, r, middle + vec(0, 0, 0x1p-110)), 0);
  EXPECT_EQ(oracle::side_of_plane(p, q, r, middle + vec(0, 0, 0x1p-110)),
            -oracle::side_of_plane(p, q, r, middle - vec(0, 0, 0x1p-110)));
}

TEST(ExactMeeting, TellsTouchingTrianglesFromThoseApart) {
  const Triple ground{vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)};
  const auto standing = [](double z) { return Triple{vec(0.2, 0.2, z), vec(0.3, 0.2, 1), vec(0.2, 0.3, 1)}; };
  EXPECT_TRUE(oracle::meets(ground, standing(0)));
  EXPECT_TRUE(oracle::meets(ground, standing(-1e-30)));
  EXPECT_FALSE(oracle::meets(ground, standing(1e-30)));
  // In the same plane: by a corner on an edge, within, and beside.
  const auto beside = [](double x) { return Triple{vec(x, 0.5, 0), vec(x + 1, 0.5, 0), vec(x + 1, 1, 0)}; };
  EXPECT_TRUE(oracle::meets(ground, beside(0.5)));
  EXPECT_FALSE(oracle::meets(ground, beside(std::nextafter(0.5, 1))));
  EXPECT_TRUE(oracle::meets(ground, Triple{vec(0.1, 0.1, 0), vec(0.2, 0.1, 0), vec(0.1, 0.2, 0)}));
  EXPECT_TRUE(oracle::meets(vec(0.25, 0.25, 0), vec(0.25, 0.25, 0), ground));
  EXPECT_FALSE(oracle::meets(vec(0.75, 0.75, 0), vec(0.75, 0.75, 0), ground));
}

TEST(ExactMeeting, TellsATriangleWithinAHull) {
  const oracle::Features box = oracle::features_of(oracle::make_box(1, 1, 1).core);
  const auto triangle = [](double x) { return Triple{vec(x, 0, 0), vec(x + 0.1, 0, 0), vec(x, 0.1, 0)}; };
  EXPECT_TRUE(oracle::meets(triangle(0), box));
  EXPECT_TRUE(oracle::meets(triangle(1), box));
  EXPECT_FALSE(oracle::meets(triangle(1 + 1e-15), box));
}

}  // namespace
