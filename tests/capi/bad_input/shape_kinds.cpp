// SPDX-License-Identifier: Apache-2.0
// The list of shape kinds: questions about kinds that do not exist have an answer, never a crash.
#include <limits>
#include <set>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<const char*, 20> every_kind{
    "sphere",    "box",         "capsule",       "plane",    "hull",           "mesh",      "height_field",
    "point",     "segment",     "triangle",      "cylinder", "cone",           "ellipsoid", "particles",
    "composite", "sphere_hole", "cylinder_hole", "box_hole", "distance_field", "uv_grid"};
constexpr std::array<abut_shape_kind, 3> no_kinds{0, 9999, 0xFFFFFFFFU};

TEST(ShapeKindCount, CountsTheKinds) { EXPECT_EQ(abut_shape_kind_count(), every_kind.size()); }

TEST(ShapeKindAt, IsZeroPastTheEnd) {
  EXPECT_EQ(abut_shape_kind_at(abut_shape_kind_count()), 0U);
  EXPECT_EQ(abut_shape_kind_at(std::numeric_limits<std::size_t>::max()), 0U);
}

TEST(ShapeKindAt, ListsDifferentKinds) {
  std::set<abut_shape_kind> kinds;
  for (std::size_t index = 0; index < abut_shape_kind_count(); ++index) kinds.insert(abut_shape_kind_at(index));
  EXPECT_EQ(kinds.size(), abut_shape_kind_count());
  EXPECT_FALSE(kinds.contains(0));
}

TEST(ShapeKindByName, FindsEveryNameOfTheList) {
  for (const char* name : every_kind) {
    const abut_shape_kind kind = abut_shape_kind_by_name(name);
    EXPECT_NE(kind, 0U) << name;
    EXPECT_STREQ(abut_shape_kind_name(kind), name);
  }
}

TEST(ShapeKindByName, IsZeroForNullAndUnknownNames) {
  EXPECT_EQ(abut_shape_kind_by_name(nullptr), 0U);
  EXPECT_EQ(abut_shape_kind_by_name(""), 0U);
  EXPECT_EQ(abut_shape_kind_by_name("Sphere"), 0U);
  EXPECT_EQ(abut_shape_kind_by_name("sphere "), 0U);
  EXPECT_EQ(abut_shape_kind_by_name("teapot"), 0U);
}

TEST(ShapeKindName, IsNullForNoKind) {
  for (const abut_shape_kind none : no_kinds) EXPECT_EQ(abut_shape_kind_name(none), nullptr) << none;
}

TEST(ShapeKindParameterCount, IsZeroForNoKind) {
  for (const abut_shape_kind none : no_kinds) EXPECT_EQ(abut_shape_kind_parameter_count(none), 0U) << none;
}

TEST(ShapeKindParameterName, IsNullForNoKindAndPastTheEnd) {
  for (const abut_shape_kind none : no_kinds) EXPECT_EQ(abut_shape_kind_parameter_name(none, 0), nullptr) << none;
  for (std::size_t index = 0; index < abut_shape_kind_count(); ++index) {
    const abut_shape_kind kind = abut_shape_kind_at(index);
    const std::size_t count = abut_shape_kind_parameter_count(kind);
    for (std::size_t parameter = 0; parameter < count; ++parameter) {
      EXPECT_NE(abut_shape_kind_parameter_name(kind, parameter), nullptr);
    }
    EXPECT_EQ(abut_shape_kind_parameter_name(kind, count), nullptr);
    EXPECT_EQ(abut_shape_kind_parameter_name(kind, size_max), nullptr);
  }
}

TEST(ShapeKindParameterName, NamesTheRadiusOfASphere) {
  EXPECT_STREQ(abut_shape_kind_parameter_name(abut_shape_kind_by_name("sphere"), 0), "radius");
}

TEST(PairSupport, IsOneButForPlanesAndHoles) {
  const auto answers = [](const char* a, const char* b, abut_query query) {
    std::uint32_t out = 7;
    EXPECT_TRUE(succeeded(abut_pair_support(abut_shape_kind_by_name(a), abut_shape_kind_by_name(b), query, &out)));
    return out;
  };
  for (const abut_query query : {ABUT_QUERY_DISTANCE, ABUT_QUERY_CONTACTS}) {
    EXPECT_EQ(answers("sphere", "cylinder", query), 1U);
    EXPECT_EQ(answers("height_field", "ellipsoid", query), 1U);
    EXPECT_EQ(answers("plane", "height_field", query), 1U);
    EXPECT_EQ(answers("height_field", "height_field", query), 1U);
    EXPECT_EQ(answers("height_field", "box_hole", query), 1U);
    EXPECT_EQ(answers("plane", "box_hole", query), 0U);
    EXPECT_EQ(answers("plane", "plane", query), 0U);
  }
}

TEST(PairSupport, RefusesWhatIsNoKindAndNoQuery) {
  Out<std::uint32_t> out;
  const abut_shape_kind sphere = abut_shape_kind_by_name("sphere");
  for (const abut_shape_kind none : no_kinds) {
    EXPECT_TRUE(
        refused(abut_pair_support(none, sphere, ABUT_QUERY_DISTANCE, out.address()), ABUT_UNKNOWN_VALUE, {"kind_a"}));
    EXPECT_TRUE(
        refused(abut_pair_support(sphere, none, ABUT_QUERY_DISTANCE, out.address()), ABUT_UNKNOWN_VALUE, {"kind_b"}));
  }
  EXPECT_TRUE(refused(abut_pair_support(sphere, sphere, 2, out.address()), ABUT_UNKNOWN_VALUE, {"query", "2"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
