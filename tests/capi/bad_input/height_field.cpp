// SPDX-License-Identifier: Apache-2.0
// Height fields under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 6> six_heights{0, 1, 2, 3, 4, 5};

abut_height_field_desc good_desc() {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = 3;
  desc.rows = 2;
  desc.spacing_x = 1.0;
  desc.spacing_y = 2.0;
  desc.heights = six_heights.data();
  return desc;
}

TEST(HeightFieldDescInit, IgnoresNull) { abut_height_field_desc_init(nullptr, 0); }

TEST(HeightFieldDescInit, FillsInSizeAndZeroes) {
  Out<abut_height_field_desc> desc;
  abut_height_field_desc_init(desc.address(), sizeof(abut_height_field_desc));
  EXPECT_EQ(desc.value().struct_size, sizeof(abut_height_field_desc));
  EXPECT_EQ(desc.value().diagonal, ABUT_DIAGONAL_RISING);
  EXPECT_EQ(desc.value().heights, nullptr);
}

TEST(HeightFieldCreate, AcceptsTheDescriptionThatTheOthersSpoil) {
  const abut_height_field_desc desc = good_desc();
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(abut_height_field_create(&desc, &shape)));
  abut_shape_release(shape);
}

TEST(HeightFieldCreate, RefusesFieldsWithoutSamples) {
  Out<abut_shape*> out;
  abut_height_field_desc desc = good_desc();
  desc.columns = 0;
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_EMPTY, {"columns", "0"}));
  desc = good_desc();
  desc.rows = 0;
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_EMPTY, {"rows", "0"}));
  EXPECT_TRUE(out.is_untouched());
}

// One row of samples spans no cell.
TEST(HeightFieldCreate, RefusesFieldsWithoutCells) {
  Out<abut_shape*> out;
  abut_height_field_desc desc = good_desc();
  desc.columns = 1;
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"columns", "1"}));
  desc = good_desc();
  desc.rows = 1;
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"rows", "1"}));
  EXPECT_TRUE(out.is_untouched());
}

// A height that is NaN makes a hole. Here a triangle lacks a corner on either side of the diagonal.
TEST(HeightFieldCreate, RefusesFieldsWithoutTriangles) {
  Out<abut_shape*> out;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<double, 6> heights{0, nan, 0, 0, nan, 0};
  abut_height_field_desc desc = good_desc();
  desc.heights = heights.data();
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_EMPTY, {"heights"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(HeightFieldCreate, RefusesSpacingThatIsNotPositive) {
  Out<abut_shape*> out;
  for (const double spacing : {0.0, -2.5}) {
    const std::string_view word = spacing < 0.0 ? "-2.5" : "0";
    abut_height_field_desc desc = good_desc();
    desc.spacing_x = spacing;
    EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"spacing_x", word}));
    desc = good_desc();
    desc.spacing_y = spacing;
    EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"spacing_y", word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

// The far corner of the field would lie at infinity.
TEST(HeightFieldCreate, RefusesFieldsThatAreTooLarge) {
  Out<abut_shape*> out;
  abut_height_field_desc desc = good_desc();
  desc.spacing_x = std::numeric_limits<double>::max();
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"spacing_x"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(HeightFieldCreate, RefusesMoreSamplesThanNumbersOfTriangles) {
  expect_kind_refused("height_field", {65535, 65535, 1, 1}, {0, 0, 0, 0}, {}, ABUT_SIZE_OVERFLOW,
                      {"columns * rows", "4294836225", "1073741824"});
}

TEST(HeightFieldCreate, RefusesUnknownDiagonals) {
  Out<abut_shape*> out;
  abut_height_field_desc desc = good_desc();
  desc.diagonal = 31;
  EXPECT_TRUE(refused(abut_height_field_create(&desc, out.address()), ABUT_UNKNOWN_VALUE, {"diagonal", "31"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(HeightFieldCreate, AcceptsLaterDescriptionWithZeroTail) {
  abut_shape* shape = nullptr;
  expect_zero_tail_accepted(
      good_desc(), [&](const abut_height_field_desc* later) { return abut_height_field_create(later, &shape); });
  abut_shape_release(shape);
}

}  // namespace
