// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;

namespace {

using abut::AnyShape;
using abut::ShapeHandle;
using abut::Errc;
using abut::Outcome;
using abut::Pose;
using abut::Vec3;

std::size_t place_of(std::string_view name) { return abut::find_kind(name).value(); }
ShapeHandle made(std::string_view name, const std::vector<double>& parameters, const std::vector<double>& reals = {},
                 const std::vector<std::uint32_t>& indices = {}) {
  return abut::make_shape(place_of(name), parameters, reals, indices).value();
}
ShapeHandle ball(double radius) { return made("sphere", {radius}); }
ShapeHandle cube() { return made("box", {1, 1, 1}); }
ShapeHandle field() { return made("height_field", {2, 2, 4, 4}, {0, 0, 0, 0}); }

TEST(Kinds, HaveTheNumbersOfTheInterface) {
  const std::vector<std::pair<std::string_view, std::uint32_t>> kinds{
      {"sphere", 1}, {"box", 2}, {"capsule", 3}, {"plane", 4}, {"hull", 5}, {"mesh", 6}, {"height_field", 7}};
  for (const auto& [name, number] : kinds) {
    const auto place = abut::find_kind(number);
    ASSERT_TRUE(place.has_value()) << name;
    EXPECT_EQ(abut::kind_name(*place), name);
    EXPECT_EQ(abut::find_kind(name), place);
  }
}

TEST(Kinds, UnknownOnesAreNotFound) {
  EXPECT_FALSE(abut::find_kind(0u).has_value());
  EXPECT_FALSE(abut::find_kind(4000000000u).has_value());
  EXPECT_FALSE(abut::find_kind("").has_value());
  EXPECT_FALSE(abut::find_kind("Sphere").has_value());
}

TEST(Kinds, NameTheirParameters) {
  EXPECT_EQ(abut::kind_parameter_count(place_of("capsule")), 2u);
  EXPECT_EQ(abut::kind_parameter_name(place_of("capsule"), 0), "radius");
  EXPECT_EQ(abut::kind_parameter_name(place_of("capsule"), 1), "half_height");
  EXPECT_EQ(abut::kind_parameter_count(place_of("hull")), 0u);
  for (std::size_t place = 0; place < abut::shape_kind_count; ++place) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < abut::kind_parameter_count(place); ++i) {
      EXPECT_TRUE(names.insert(abut::kind_parameter_name(place, i)).second);
    }
  }
}

TEST(AnyShape, ComesFromNumbersAndTellsThem) {
  const ShapeHandle capsule = made("capsule", {0.5, 2});
  EXPECT_EQ(abut::kind_in_pairs(capsule), place_of("capsule"));
  EXPECT_EQ(abut::parameters_of(capsule), (std::vector{0.5, 2.0}));
  EXPECT_EQ(abut::parameters_of(field()), (std::vector{2.0, 2.0, 4.0, 4.0, 0.0, 0.0}));
}

TEST(AnyShape, BadNumbersAreRefusedByTheKind) {
  const auto result = abut::make_shape(place_of("sphere"), std::vector{-1.0}, {}, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, Errc::out_of_range);
  EXPECT_EQ(result.error().message, "radius is -1; it must be positive");
  EXPECT_EQ(abut::make_shape(place_of("hull"), {}, {}, {}).error().code, Errc::empty);
}

TEST(AnyShape, AnswersAsItsKindDoes) {
  const abut::Aabb box = abut::aabb_of(ball(2), {abut::Rotation::identity(), {10, 20, 30}});
  EXPECT_EQ(box.low, (Vec3{8, 18, 28}));
  EXPECT_EQ(box.high, (Vec3{12, 22, 32}));
  const auto hit = abut::cast_ray(ball(2), {0, 0, -5}, abut::UnitVec3::axis_z(), 10);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 3);
  EXPECT_FALSE(abut::cast_ray(ball(2), {0, 0, -5}, abut::UnitVec3::axis_z(), 2.5).has_value());
}

TEST(AnyShape, CurvedAndUnboundedOnesHaveNoTriangles) {
  EXPECT_FALSE(abut::triangles_of(ball(1)).has_value());
  EXPECT_FALSE(abut::triangles_of(made("capsule", {1, 1})).has_value());
  EXPECT_FALSE(abut::triangles_of(made("plane", {0, 0, 1, 0})).has_value());
  EXPECT_EQ(abut::triangles_of(cube())->indices.size(), 36u);
  EXPECT_EQ(abut::triangles_of(field())->indices.size(), 6u);
}

TEST(Pairs, OnlyPlanesAndHolesDoNotMeetEachOther) {
  const std::set<std::string_view> endless{"plane", "sphere_hole", "cylinder_hole", "box_hole"};
  for (std::size_t a = 0; a < abut::shape_kind_count; ++a) {
    for (std::size_t b = 0; b < abut::shape_kind_count; ++b) {
      const std::string_view first = abut::kind_name(a), second = abut::kind_name(b);
      const bool expected = !endless.contains(first) || !endless.contains(second);
      EXPECT_EQ(abut::is_supported(a, b), expected) << abut::kind_name(a) << " " << abut::kind_name(b);
      EXPECT_EQ(abut::describe_route(a, b).algorithm == "unsupported", !expected);
      EXPECT_EQ(abut::describe_route(a, b).reason, abut::describe_route(b, a).reason);
      EXPECT_FALSE(abut::describe_route(a, b).reason.empty());
    }
  }
  abut::Distance out{};
  const ShapeHandle plane = made("plane", {0, 0, 1, 0});
  EXPECT_EQ(abut::pair_distance(plane, plane, Pose::identity(), {}, out), Outcome::unsupported);
}

// Balls have a closed form: the distance of their centres less both radii.
TEST(Pairs, DistanceIsInTheWorld) {
  test::Random random(291);
  for (int i = 0; i < 300; ++i) {
    const Pose a{random.rotation(), random.point(5)}, b{random.rotation(), random.point(5)};
    const Vec3 between = b.position - a.position;
    const double length = std::sqrt(dot(between, between));
    abut::Distance out{};
    ASSERT_EQ(abut::pair_distance(ball(0.5), ball(0.75), a, b, {}, out), Outcome::ok);
    EXPECT_NEAR(out.distance, length - 1.25, 1e-13);
    EXPECT_NEAR(norm(out.point_a - (a.position + (0.5 / length) * between)), 0, 1e-13);
    EXPECT_NEAR(norm(out.point_b - (b.position - (0.75 / length) * between)), 0, 1e-13);
    ASSERT_EQ(abut::pair_distance(ball(0.5), ball(0.75), relative(a, b), {}, out), Outcome::ok);
    EXPECT_NEAR(norm(out.point_a - a.undo(a.position + (0.5 / length) * between)), 0, 1e-13);
  }
}

// Swapping a and b swaps the points and negates the normal; nothing else changes.
TEST(Pairs, SwappedPairsAgree) {
  test::Random random(292);
  const std::vector<ShapeHandle> shapes{ball(0.5), cube(), made("capsule", {0.3, 1}), made("plane", {0, 0, 1, 0}),
                                        field()};
  int contacts = 0;
  for (int i = 0; i < 400; ++i) {
    const AnyShape& a = shapes[static_cast<std::size_t>(i) % 5];
    const AnyShape& b = shapes[static_cast<std::size_t>(i) / 5 % 5];
    if (!abut::is_supported(abut::kind_in_pairs(a), abut::kind_in_pairs(b)) ||
        abut::kind_in_pairs(a) == abut::kind_in_pairs(b)) {
      continue;
    }
    const Pose pose_a{random.rotation(), random.point(1)}, pose_b{random.rotation(), random.point(1)};
    abut::Distance there{}, back{};
    ASSERT_EQ(abut::pair_distance(a, b, pose_a, pose_b, {}, there), Outcome::ok);
    ASSERT_EQ(abut::pair_distance(b, a, pose_b, pose_a, {}, back), Outcome::ok);
    EXPECT_EQ(there.distance, back.distance);
    EXPECT_EQ(there.point_a, back.point_b);
    EXPECT_EQ(there.point_b, back.point_a);
    EXPECT_EQ(there.normal, -back.normal);
    abut::Manifold some, others;
    ASSERT_EQ(abut::pair_contacts(a, b, pose_a, pose_b, {}, some), Outcome::ok);
    ASSERT_EQ(abut::pair_contacts(b, a, pose_b, pose_a, {}, others), Outcome::ok);
    ASSERT_EQ(some.size(), others.size());
    for (std::size_t k = 0; k < some.size(); ++k) {
      EXPECT_EQ(some[k].id, others[k].id);
      EXPECT_EQ(some[k].point_a, others[k].point_b);
      EXPECT_EQ(some[k].normal, -others[k].normal);
      EXPECT_EQ(some[k].feature_a, others[k].feature_b);
      ++contacts;
    }
  }
  EXPECT_GT(contacts, 50);
}

}  // namespace
