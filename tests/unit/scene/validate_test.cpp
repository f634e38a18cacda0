// SPDX-License-Identifier: Apache-2.0
// What is odd about a scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

namespace {

using namespace abut;

ShapeHandle make(std::string_view kind, const std::vector<Real>& parameters) {
  return ShapeHandle(make_shape(find_kind(kind).value(), parameters, {}, {}).value());
}

GeometryOptions layered(std::uint64_t layers, std::uint64_t mask) {
  GeometryOptions options;
  options.layers = layers;
  options.mask = mask;
  return options;
}
GeometryOptions tolerant(Real tolerance) {
  GeometryOptions options;
  options.tolerance = tolerance;
  return options;
}
constexpr std::uint64_t everything = ~std::uint64_t{0};

class Validate : public testing::Test {
 protected:
  GeometryId add(std::string_view kind, const std::vector<Real>& parameters, const Vec3& position,
                 MotionKind motion = MotionKind::dynamic, const GeometryOptions& options = {}) {
    const PartOptions part{.motion = motion, .placement = {position, {1, 0, 0, 0}}};
    const PartId id = universe.create_parts(std::span(&part, 1)).value()[0];
    const ShapeHandle shape = make(kind, parameters);
    return universe.create_geometries(std::span(&id, 1), std::span(&shape, 1), std::span(&options, 1)).value()[0];
  }
  [[nodiscard]] std::vector<FindingCode> codes() const {
    std::vector<FindingCode> found;
    for (const Finding& finding : universe.validate()) {
      EXPECT_FALSE(finding.message.empty());
      found.push_back(finding.code);
    }
    return found;
  }

  Universe universe{UniverseOptions{}, 1};
};

using Codes = std::vector<FindingCode>;

TEST_F(Validate, FindsNothingInAGoodScene) {
  EXPECT_EQ(codes(), Codes{});
  add("sphere", {1}, {0, 0, 0});
  add("box", {1, 1, 1}, {3, 0, 0});
  add("plane", {0, 0, 1, 0}, {0, 0, 0}, MotionKind::fixed);
  EXPECT_EQ(codes(), Codes{});
}

TEST_F(Validate, FindsThatNothingMoves) {
  add("sphere", {1}, {0, 0, 0}, MotionKind::fixed);
  EXPECT_EQ(codes(), Codes{}) << "one geometry alone is no scene";
  add("sphere", {1}, {1, 0, 0}, MotionKind::animated);
  EXPECT_EQ(codes(), Codes{FindingCode::nothing_moves});
}

TEST_F(Validate, FindsEmptyLayersAndMasks) {
  add("sphere", {1}, {0, 0, 0});
  const GeometryId odd = add("sphere", {1}, {9, 0, 0}, MotionKind::dynamic, layered(0, everything));
  add("sphere", {1}, {18, 0, 0}, MotionKind::dynamic, layered(1, 0));
  ASSERT_EQ(codes(), (Codes{FindingCode::meets_nothing, FindingCode::meets_nothing}));
  EXPECT_EQ(universe.validate()[0].geometry, odd);
  EXPECT_NE(universe.validate()[0].message.find("layers"), std::string::npos);
  EXPECT_NE(universe.validate()[1].message.find("mask"), std::string::npos);
}

TEST_F(Validate, FindsLayersThatNobodyMeets) {
  add("sphere", {1}, {0, 0, 0}, MotionKind::dynamic, layered(1, 1));
  add("sphere", {1}, {9, 0, 0}, MotionKind::dynamic, layered(2, 1));
  EXPECT_EQ(codes(), Codes{FindingCode::excluded_from_all});
}

TEST_F(Validate, FindsKindsWithoutAnAlgorithm) {
  add("plane", {0, 0, 1, 0}, {0, 0, 0}, MotionKind::fixed);
  add("sphere", {1}, {0, 0, 9});
  EXPECT_EQ(codes(), Codes{});
  add("plane", {0, 0, 1, 0}, {0, 0, 0}, MotionKind::fixed);
  EXPECT_EQ(codes(), Codes{}) << "two that stand still never meet";
  add("plane", {0, 0, 1, 0}, {0, 0, 0});
  ASSERT_EQ(codes(), Codes{FindingCode::kinds_unsupported});
  EXPECT_NE(universe.validate()[0].message.find("plane"), std::string::npos);
}

TEST_F(Validate, FindsLargeTolerances) {
  add("sphere", {1}, {0, 0, 0});
  add("box", {4, 4, 0.1}, {9, 0, 0}, MotionKind::dynamic, tolerant(0.19));
  EXPECT_EQ(codes(), Codes{});
  add("box", {4, 4, 0.1}, {18, 0, 0}, MotionKind::dynamic, tolerant(0.21));
  ASSERT_EQ(codes(), Codes{FindingCode::tolerance_too_large});
  EXPECT_NE(universe.validate()[0].message.find("0.21"), std::string::npos);
}

TEST_F(Validate, FindsWhatIsFarFromTheOrigin) {
  add("sphere", {1}, {1e5, 0, 0});
  EXPECT_EQ(codes(), Codes{});
  add("sphere", {1}, {1e7, 0, 0});
  EXPECT_EQ(codes(), Codes{FindingCode::far_from_origin});
}

constexpr Collidable anything{};

TEST_F(Validate, FindsARuleThatDisablesAll) {
  add("sphere", {1}, {0, 0, 0});
  const GeometryId other = add("sphere", {1}, {1, 0, 0});
  ASSERT_TRUE(universe.set_rule(anything, anything, Rule::disable));
  ASSERT_EQ(codes(), Codes{FindingCode::rule_disables_all});
  EXPECT_NE(universe.validate()[0].message.find("disables any with any"), std::string::npos);
  ASSERT_TRUE(universe.set_rule({CollidableKind::geometry, other.slot, other.generation}, anything, Rule::enable));
  EXPECT_EQ(codes(), Codes{}) << "a list of what may meet";
}

TEST_F(Validate, FindsAnExclusionBitInCommon) {
  GeometryOptions options;
  options.exclusion = 0b1100;
  add("sphere", {1}, {0, 0, 0}, MotionKind::dynamic, options);
  options.exclusion = 0b0110;
  add("sphere", {1}, {1, 0, 0}, MotionKind::dynamic, options);
  ASSERT_EQ(codes(), Codes{FindingCode::exclusion_in_common});
  EXPECT_NE(universe.validate()[0].message.find("bit 2"), std::string::npos);
  add("sphere", {1}, {2, 0, 0});
  EXPECT_EQ(codes(), Codes{});
}

TEST_F(Validate, FindsAFilterThatKeepsNone) {
  add("sphere", {1}, {0, 0, 0});
  add("sphere", {1}, {1, 0, 0});
  universe.set_filter([](GeometryId, GeometryId) { return false; });
  EXPECT_EQ(codes(), Codes{}) << "nobody has asked it yet";
  ASSERT_TRUE(universe.step(0));
  ASSERT_TRUE(universe.step(0));
  ASSERT_EQ(codes(), Codes{FindingCode::filter_keeps_none});
  EXPECT_NE(universe.validate()[0].message.find("asked about pairs 1 times"), std::string::npos);
  universe.set_filter([](GeometryId, GeometryId) { return true; });
  ASSERT_TRUE(universe.step(0));
  EXPECT_EQ(codes(), Codes{});
  universe.set_filter([](GeometryId, GeometryId) { return false; });
  ASSERT_TRUE(universe.step(0));
  universe.set_filter({});
  EXPECT_EQ(codes(), Codes{}) << "it is gone";
}

TEST_F(Validate, FindsThatAllAreParked) {
  const GeometryId one = add("sphere", {1}, {0, 0, 0}), other = add("sphere", {1}, {1, 0, 0});
  ASSERT_TRUE(universe.park(std::array{one}, Parking::short_term));
  EXPECT_EQ(codes(), Codes{});
  ASSERT_TRUE(universe.park(std::array{other}, Parking::long_term));
  EXPECT_EQ(codes(), Codes{FindingCode::all_parked});
}

TEST_F(Validate, FindsThatAllAreOnOnePart) {
  const PartOptions part;
  const PartId id = universe.create_parts(std::span(&part, 1)).value()[0];
  const ShapeHandle shape = make("sphere", {1});
  ASSERT_TRUE(universe.create_geometries(std::array{id}, std::array{shape}, {}));
  EXPECT_EQ(codes(), Codes{});
  ASSERT_TRUE(universe.create_geometries(std::array{id}, std::array{shape}, {}));
  ASSERT_EQ(codes(), Codes{FindingCode::all_on_one_part});
  EXPECT_NE(universe.validate()[0].message.find("part 1"), std::string::npos);
}

}  // namespace
