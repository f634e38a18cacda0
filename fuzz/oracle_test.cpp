// SPDX-License-Identifier: Apache-2.0
// The judge must be able to say no.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
import abut.capability;
import abut.core;
import abut.fuzz;
import abut.math;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace {

using namespace abut;
using namespace abut::fuzz;

constexpr std::string_view box_kind = "box";

std::size_t box() { return find_kind(box_kind).value(); }

// Two boxes, apart or overlapping by 0.25 along X.
Scene boxes(bool apart) {
  Record record;
  record.a = {1, 1, 1};
  record.b = {1, 0.5, 0.5};
  record.position = {apart ? 2.5 : 1.75, 0.25, 0};
  return make_scene(box(), box(), record).value();
}

Distance answer(const Scene& scene) {
  Distance found{};
  EXPECT_EQ(pair_distance(scene.a, scene.b, scene.ab, {}, found), Outcome::ok);
  return found;
}

template <class Change>
void expect_refused(Change change) {
  for (const bool apart : {false, true}) {
    const Scene scene = boxes(apart);
    Distance found = answer(scene);
    ASSERT_EQ(judge_distance(scene, found), std::nullopt);
    change(found);
    EXPECT_NE(judge_distance(scene, found), std::nullopt) << (apart ? "apart" : "overlapping");
  }
}

TEST(FuzzOracle, RefusesANegatedNormal) {
  expect_refused([](Distance& found) { found.normal = -found.normal; });
}

TEST(FuzzOracle, RefusesANegatedNormalWithNegatedDistance) {
  expect_refused([](Distance& found) {
    found.normal = -found.normal;
    found.distance = -found.distance;
    found.lower = found.upper = found.distance;
  });
}

TEST(FuzzOracle, RefusesADistanceOffByOnePerCent) {
  expect_refused([](Distance& found) {
    found.point_b = found.point_a + 1.01 * found.distance * found.normal;
    found.lower = found.upper = found.distance *= 1.01;
  });
}

TEST(FuzzOracle, RefusesNotANumber) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  expect_refused([&](Distance& found) { found.distance = nan; });
  expect_refused([&](Distance& found) { found.point_a.y = nan; });
  expect_refused([&](Distance& found) { found.normal.z = nan; });
  expect_refused([&](Distance& found) { found.upper = nan; });
}

TEST(FuzzOracle, RefusesANormalThatIsNotUnit) {
  expect_refused([](Distance& found) { found.normal = 1.001 * found.normal; });
}

TEST(FuzzOracle, RefusesPointsOffTheSurface) {
  expect_refused([](Distance& found) {
    found.point_a.y += 3;
    found.point_b.y += 3;
  });
  expect_refused([](Distance& found) {
    found.point_a.x -= 0.1;
    found.point_b.x -= 0.1;
  });
}

TEST(FuzzOracle, RefusesBoundsThatMissTheDistance) {
  expect_refused([](Distance& found) { found.upper = found.distance - 0.01; });
  expect_refused([](Distance& found) { found.lower = found.distance + 0.01; });
}

TEST(FuzzOracle, RefusesADepthThatIsNotTheLeast) {
  const Scene scene = boxes(false);
  Distance found = answer(scene);
  found.normal = {0, 0, 1};
  found.point_a = {0.9, 0, 1};
  found.point_b = {0.9, 0, -0.5};
  found.distance = found.lower = found.upper = -1.5;
  EXPECT_NE(judge_distance(scene, found), std::nullopt);
}

TEST(FuzzOracle, RefusesADistanceThatGjkAndEpaRuleOut) {
  for (const bool apart : {false, true}) {
    const Scene scene = boxes(apart);
    const Distance found = answer(scene);
    EXPECT_EQ(judge_other_routes(scene, found), std::nullopt);
    for (const Real change : {0.01, -0.01}) {
      Distance other = found;
      other.distance += change;
      EXPECT_NE(judge_other_routes(scene, other), std::nullopt) << change;
    }
  }
}

// Between points that are not nearest to each other, as contacts beside a hole are.
TEST(FuzzOracle, TakesAnyContactForTheDistanceOfWhatHolesLeave) {
  for (const char* kind : {"segment", "sphere_hole"}) {
    if (!find_kind(std::string_view(kind))) GTEST_SKIP() << "this build lacks " << kind;
  }
  const ShapeHandle solid = make_shape(box(), std::array{1.0, 1.0, 1.0}, {}, {}).value();
  const ShapeHandle hole =
      make_shape(find_kind(std::string_view("sphere_hole")).value(), std::array{0.5}, {}, {}).value();
  const PlacedShape placed_solid{ShapeHandle(solid), Pose::identity()},
      placed_hole{ShapeHandle(hole), {Rotation::identity(), {1, 0, 0}}};
  // A needle over the hole, askew, and from beside the hole to the end that is further away.
  const ShapeHandle needle =
      make_shape(find_kind(std::string_view("segment")).value(), std::array{0.5}, {}, {}).value();
  const Pose askew{Rotation::from({0.9, 0, 0.2, 0}), {2, 0, 0}};
  const Vec3 end = askew * Vec3{0, 0, 0.5};
  const Real distance = end.x - 1;
  const Distance found{distance, 0, distance, {1, end.y, end.z}, end, {1, 0, 0}, Algorithm::analytic, 1};
  for (const bool is_holed : {false, true}) {
    const std::array both{placed_solid, placed_hole};
    const Scene scene{make_composite(std::span(both).first(is_holed ? 2 : 1)).value(), needle, askew, 0, 4};
    EXPECT_EQ(judge_distance(scene, found) == std::nullopt, is_holed);
  }
}

// A field with one sample that is inside, which means take away or leave.
TEST(FuzzOracle, TakesAPointBesideTheBoxOfAFieldForNothingOnly) {
  const auto field = find_kind(std::string_view("distance_field")), point = find_kind(std::string_view("point"));
  if (!field || !point) GTEST_SKIP() << "this build lacks distance fields or points";
  for (const Real least : {-0.01, -10.0}) {
    std::array<Real, 125> values{};
    values.fill(0.4);
    values[62] = least;
    const std::array<Real, 11> parameters{5, 5, 5, 1, 1, 1, -2, -2, -2, 0, 1};
    const Scene scene{make_shape(*field, parameters, values, {}).value(),
                      make_shape(*point, {}, {}, {}).value(),
                      {Rotation::identity(), {1.9, 0, 0}},
                      0,
                      4};
    Distance found = answer(scene);
    EXPECT_EQ(judge_distance(scene, found), std::nullopt);
    found.point_a = {4, 0, 0};
    found.normal = {-1, 0, 0};
    found.distance = 2.1;
    found.lower = 0;
    found.upper = infinity;
    EXPECT_EQ(judge_distance(scene, found) == std::nullopt, least == -0.01);
    found.upper = 2.1;
    EXPECT_NE(judge_distance(scene, found), std::nullopt);
    // Below zero although the boxes are apart.
    found.point_a = {1.5, 0, 0};
    found.distance = found.lower = -0.4;
    EXPECT_NE(judge_distance(scene, found), std::nullopt);
    found.upper = infinity;
    EXPECT_EQ(judge_distance(scene, found) == std::nullopt, least == -0.01);
  }
}

TEST(FuzzOracle, RefusesWrongContacts) {
  const Scene scene = boxes(false);
  const Distance found = answer(scene);
  Manifold contacts;
  ASSERT_EQ(pair_contacts(scene.a, scene.b, scene.ab, {}, contacts), Outcome::ok);
  ASSERT_FALSE(contacts.empty());
  ASSERT_EQ(judge_contacts(scene, found, contacts), std::nullopt);
  EXPECT_NE(judge_contacts(scene, found, {}), std::nullopt) << "none";
  EXPECT_NE(judge_contacts(boxes(true), answer(boxes(true)), contacts), std::nullopt) << "apart";
  Manifold wrong = contacts;
  wrong[0].normal = -wrong[0].normal;
  EXPECT_NE(judge_contacts(scene, found, wrong), std::nullopt) << "normal";
  wrong = contacts;
  for (ContactPoint& contact : wrong) {
    contact.point_b += 0.01 * contact.normal;
    contact.distance += 0.01;
  }
  EXPECT_NE(judge_contacts(scene, found, wrong), std::nullopt) << "all too shallow";
  wrong = contacts;
  wrong[0].point_a.z += 5;
  wrong[0].point_b.z += 5;
  EXPECT_NE(judge_contacts(scene, found, wrong), std::nullopt) << "off the shape";
}

// A box that stands a tenth of a unit in a square of two triangles.
TEST(FuzzOracle, RefusesContactsDeeperThanWhatPartsASurface) {
  const auto mesh = find_kind(std::string_view("mesh"));
  if (!mesh) GTEST_SKIP() << "this build lacks meshes";
  const std::array<Real, 12> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  const ShapeHandle square = make_shape(*mesh, std::array{0.0}, corners, triangles).value(),
                    cube = make_shape(box(), std::array{0.25, 0.25, 0.25}, {}, {}).value();
  const Scene upright{square, cube, {Rotation::identity(), {0.5, 0.5, 0.15}}, 0, 1};
  for (const bool is_swapped : {false, true}) {
    const Scene scene = is_swapped ? swapped(upright) : upright;
    Manifold contacts;
    ASSERT_EQ(pair_contacts(scene.a, scene.b, scene.ab, {}, contacts), Outcome::ok);
    EXPECT_NEAR(depth_bound(scene, contacts).value_or(0), 0.1, 1e-12);
    EXPECT_EQ(judge_contacts(scene, answer(scene), contacts), std::nullopt);
    // The points of the cube, further in.
    for (ContactPoint& contact : contacts) {
      if (is_swapped) {
        contact.point_a += 0.01 * contact.normal;
      } else {
        contact.point_b += -0.01 * contact.normal;
      }
      contact.distance -= 0.01;
    }
    EXPECT_NE(judge_contacts(scene, answer(scene), contacts), std::nullopt);
  }
}

// A plate between two walls that face each other, 0.5e-10 deep in each: within the tolerance, and beyond rounding. Of
// the ways that both walls leave, the shortest one slides the plate out between them. Walls without fronts leave the
// way through them.
TEST(FuzzOracle, KnowsNoWayThroughAFront) {
  const auto mesh = find_kind(std::string_view("mesh"));
  if (!mesh) GTEST_SKIP() << "this build lacks meshes";
  const Real gap = 3e-10;
  const std::array<Real, 18> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, gap, 0, 1, gap, 1, 0, gap};
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 3, 4, 5};
  const ShapeHandle plate = make_shape(box(), std::array{0.25, 0.25, 2e-10}, {}, {}).value();
  const Pose between{Rotation::identity(), {0.25, 0.25, 0.5 * gap}};
  const auto bound = [&](Real is_one_sided) {
    const ShapeHandle walls = make_shape(*mesh, std::array{is_one_sided}, corners, triangles).value();
    const Manifold along_x{
        {.point_a = {}, .point_b = {}, .normal = {-1, 0, 0}, .distance = 0, .feature_a = {}, .feature_b = {}, .id = 0}};
    return depth_bound({walls, plate, between, 0, 1}, along_x).value_or(0);
  };
  EXPECT_NEAR(bound(1), 0.5, 1e-9);
  EXPECT_NEAR(bound(0), 0, 1e-9);
}

// The same box. Its contacts are less deep than it is in each triangle, or there are none.
TEST(FuzzOracle, RefusesContactsLessDeepThanTwoParts) {
  const auto mesh = find_kind(std::string_view("mesh"));
  if (!mesh) GTEST_SKIP() << "this build lacks meshes";
  const std::array<Real, 12> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  const ShapeHandle square = make_shape(*mesh, std::array{0.0}, corners, triangles).value(),
                    front = make_shape(*mesh, std::array{1.0}, corners, triangles).value(),
                    cube = make_shape(box(), std::array{0.25, 0.25, 0.25}, {}, {}).value();
  const Pose sunk{Rotation::identity(), {0.5, 0.5, 0.15}};
  const Scene scene{square, cube, sunk, 0, 1};
  EXPECT_NEAR(least_depth(scene, {}, 0).value_or(0), 0.1, 1e-9);
  EXPECT_NEAR(least_depth(swapped(scene), {}, 0).value_or(0), 0.1, 1e-9);
  EXPECT_EQ(least_depth(scene, {}, 0.2), 0.2);
  EXPECT_EQ(least_depth({front, cube, sunk, 0, 1}, {}, 0), 0) << "one side";
  EXPECT_EQ(least_depth(boxes(false), {}, 0), std::nullopt) << "no surface";
  // What a library says that is wrong in the distance and in the contacts alike.
  Manifold contacts;
  ASSERT_EQ(pair_contacts(scene.a, scene.b, scene.ab, {}, contacts), Outcome::ok);
  Distance found = answer(scene);
  EXPECT_EQ(judge_contacts(scene, found, contacts), std::nullopt);
  for (ContactPoint& contact : contacts) {
    contact.point_b += 0.01 * contact.normal;
    contact.distance += 0.01;
  }
  found.distance += 0.01;
  EXPECT_NE(judge_contacts(scene, found, contacts), std::nullopt);
  found.distance = 0;
  EXPECT_NE(judge_contacts(scene, found, {}), std::nullopt);
}

// Two squares that cross at a right angle, 0.1 deep.
TEST(FuzzOracle, KnowsHowDeepTwoSurfacesAreAtLeast) {
  const auto mesh = find_kind(std::string_view("mesh"));
  if (!mesh) GTEST_SKIP() << "this build lacks meshes";
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  const std::array<Real, 12> flat{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
      upright{0.2, 0.5, -0.1, 0.8, 0.5, -0.1, 0.8, 0.5, 0.9, 0.2, 0.5, 0.9};
  const Scene scene{make_shape(*mesh, std::array{0.0}, flat, triangles).value(),
                    make_shape(*mesh, std::array{0.0}, upright, triangles).value(), Pose::identity(), 0, 1};
  EXPECT_NEAR(least_depth(scene, {}, 0).value_or(0), 0.1, 1e-9);
}

TEST(FuzzRecord, KeepsItsLayout) {
  Record record;
  record.flags = 3;
  record.a[0] = 1;
  record.extra[1] = -2;
  const auto bytes = bytes_of(record);
  EXPECT_EQ(bytes[0], 1);
  EXPECT_EQ(bytes[1], 3);
  EXPECT_EQ(bytes[8], 0xf0);
  EXPECT_EQ(bytes[9], 0x3f);
  EXPECT_EQ(bytes[201], 0xc0);
  EXPECT_EQ(bytes_of(read_record(bytes)), bytes);
  EXPECT_EQ(read_record(std::span(bytes).first(10)).a[0], 1);
}

TEST(FuzzRecord, AnyBytesGiveAScene) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (std::size_t a = 0; a < shape_kind_count; ++a) {
    for (const Real value : {0.0, -0.0, 1e300, -1e-300, infinity, nan}) {
      for (unsigned flags = 0; flags < 256; ++flags) {
        Record record{.flags = static_cast<std::uint8_t>(flags)};
        for (std::size_t i = 0; i < number_count; ++i) {
          set_number(record, i, value);
        }
        const auto scene = make_scene(a, a, record);
        ASSERT_TRUE(scene.has_value()) << kind_name(a) << " " << value << " " << flags << " " << scene.error().message;
      }
    }
  }
}

TEST(FuzzMutation, SnappedShapesTouch) {
  Record record;
  record.a = {1, 1, 1};
  record.b = {1, 0.5, 0.5};
  record.rotation = {0.9, 0.3, 0.1, 0.3};
  record.position = {4, 1, 2};
  snap_to_touching(box(), box(), record);
  EXPECT_NEAR(answer(make_scene(box(), box(), record).value()).distance, 0, 1e-12);
}

// Two boxes of which one flies at the other, turns, and meets it.
MovingScene flying_boxes() {
  MovingRecord record;
  record.scene.a = {1, 1, 1};
  record.scene.b = {1, 0.5, 0.5};
  record.scene.position = {2.5, 0.25, 0};
  record.motion[15] = -0.5;
  record.motion[19] = 2;
  return make_moving_scene(box(), box(), record).value();
}

TEST(FuzzOracle, RefusesWrongTimesOfImpact) {
  const MovingScene moving = flying_boxes();
  Impact found;
  const Outcome outcome = time_of_impact({moving.scene.a, moving.path_a}, {moving.scene.b, moving.path_b}, {}, found);
  if (outcome == Outcome::unsupported) {
    GTEST_SKIP() << "a build without the feature motion";
  }
  ASSERT_EQ(outcome, Outcome::ok);
  ASSERT_EQ(found.state, ImpactState::touches);
  ASSERT_EQ(judge_impact(moving, found), std::nullopt);
  const auto expect_impact_refused = [&](auto change) {
    Impact wrong = found;
    change(wrong);
    EXPECT_NE(judge_impact(moving, wrong), std::nullopt);
  };
  expect_impact_refused([](Impact& wrong) { wrong.lower = wrong.upper *= 0.9; });
  expect_impact_refused([](Impact& wrong) { wrong.lower = wrong.upper *= 1.2; });
  expect_impact_refused([](Impact& wrong) { wrong.upper = 0.9 * wrong.lower; });
  expect_impact_refused([](Impact& wrong) { wrong.upper = 2; });
  expect_impact_refused([](Impact& wrong) { wrong.state = ImpactState::apart; });
  expect_impact_refused([](Impact& wrong) {
    wrong.state = ImpactState::apart;
    wrong.lower = wrong.upper = 1;
  });
  expect_impact_refused([](Impact& wrong) { wrong.contact.point_a.x = std::numeric_limits<Real>::quiet_NaN(); });
}

}  // namespace
