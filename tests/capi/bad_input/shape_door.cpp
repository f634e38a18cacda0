// SPDX-License-Identifier: Apache-2.0
// The generic door for shapes, and the references to them, under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 12> square{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
constexpr std::array<std::uint32_t, 6> two_triangles{0, 1, 2, 0, 2, 3};
constexpr double one = 1.0;

abut_shape_desc sphere_desc() {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name("sphere");
  desc.parameters = &one;
  desc.parameter_count = 1;
  return desc;
}

abut_shape_desc hull_desc() {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name("hull");
  desc.reals = square.data();
  desc.real_count = square.size();
  return desc;
}

// A mesh takes whatever parameters its kind has; zero is the default of each.
constexpr std::array<double, 8> zeros{};

abut_shape_desc mesh_desc() {
  abut_shape_desc desc = hull_desc();
  desc.kind = abut_shape_kind_by_name("mesh");
  desc.parameter_count = abut_shape_kind_parameter_count(desc.kind);
  desc.parameters = desc.parameter_count == 0 ? nullptr : zeros.data();
  desc.indices = two_triangles.data();
  desc.index_count = two_triangles.size();
  return desc;
}

TEST(ShapeDescInit, IgnoresNull) { abut_shape_desc_init(nullptr, 0); }

TEST(ShapeDescInit, FillsInSizeAndZeroes) {
  Out<abut_shape_desc> desc;
  abut_shape_desc_init(desc.address(), sizeof(abut_shape_desc));
  EXPECT_EQ(desc.value().struct_size, sizeof(abut_shape_desc));
  EXPECT_EQ(desc.value().kind, 0U);
  EXPECT_EQ(desc.value().parameters, nullptr);
  EXPECT_EQ(desc.value().index_count, 0U);
}

TEST(ShapeCreate, AcceptsTheDescriptionsThatTheOthersSpoil) {
  for (const abut_shape_desc& desc : {sphere_desc(), hull_desc(), mesh_desc()}) {
    abut_shape* shape = nullptr;
    EXPECT_TRUE(succeeded(abut_shape_create(&desc, &shape)));
    EXPECT_EQ(abut_shape_kind_of(shape), desc.kind);
    abut_shape_release(shape);
  }
}

TEST(ShapeCreate, RefusesUnknownKinds) {
  Out<abut_shape*> out;
  for (const abut_shape_kind kind : {0U, 9999U, 0xFFFFFFFFU}) {
    abut_shape_desc desc = sphere_desc();
    desc.kind = kind;
    EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_UNKNOWN_VALUE, {"kind", std::to_string(kind)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, RefusesWrongNumbersOfParameters) {
  Out<abut_shape*> out;
  constexpr std::array<double, 2> two{1.0, 1.0};
  abut_shape_desc desc = sphere_desc();
  desc.parameters = two.data();
  for (const std::uint64_t count : {0ULL, 2ULL}) {
    desc.parameter_count = count;
    EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT,
                        {"parameter_count", std::to_string(count)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, RefusesIncompletePointsAndTriangles) {
  Out<abut_shape*> out;
  abut_shape_desc desc = hull_desc();
  desc.real_count = 11;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT, {"real_count", "11"}));
  desc = mesh_desc();
  desc.real_count = 10;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT, {"real_count", "10"}));
  desc = mesh_desc();
  desc.index_count = 5;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT, {"index_count", "5"}));
  EXPECT_TRUE(out.is_untouched());
}

// A buffer that a kind has no use for is a mistake of the caller, not something to ignore.
TEST(ShapeCreate, RefusesBuffersThatTheKindHasNot) {
  Out<abut_shape*> out;
  abut_shape_desc desc = sphere_desc();
  desc.reals = square.data();
  desc.real_count = 12;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT, {"real_count", "12"}));
  desc = sphere_desc();
  desc.indices = two_triangles.data();
  desc.index_count = 6;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INVALID_ARGUMENT, {"index_count", "6"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, RefusesEmptyShapes) {
  Out<abut_shape*> out;
  abut_shape_desc desc = hull_desc();
  desc.real_count = 0;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_EMPTY, {"0"}));
  desc = mesh_desc();
  desc.index_count = 0;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_EMPTY, {"0"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, RefusesParametersOutOfRange) {
  Out<abut_shape*> out;
  constexpr double negative = -2.5;
  abut_shape_desc desc = sphere_desc();
  desc.parameters = &negative;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"radius", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, RefusesIndicesPastTheVertices) {
  Out<abut_shape*> out;
  auto triangles = two_triangles;
  triangles[5] = 4;
  abut_shape_desc desc = mesh_desc();
  desc.indices = triangles.data();
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), ABUT_INDEX_OUT_OF_RANGE, {"indices", "4"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ShapeCreate, AcceptsLaterDescriptionWithZeroTail) {
  abut_shape* shape = nullptr;
  expect_zero_tail_accepted(sphere_desc(),
                            [&](const abut_shape_desc* later) { return abut_shape_create(later, &shape); });
  abut_shape_release(shape);
}

TEST(ShapeRetain, IgnoresNull) { abut_shape_retain(nullptr); }
TEST(ShapeRelease, IgnoresNull) { abut_shape_release(nullptr); }
TEST(ShapeKindOf, IsZeroForNull) { EXPECT_EQ(abut_shape_kind_of(nullptr), 0U); }

}  // namespace
