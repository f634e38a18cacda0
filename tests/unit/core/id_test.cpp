// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

import abut.core;

namespace {

struct Cat;
using CatId = abut::Id<Cat>;

TEST(Id, DefaultIsNull) {
  EXPECT_TRUE(CatId{}.is_null());
  EXPECT_FALSE((CatId{1, 0}.is_null()));
}

// Slots count from one, so that a generation alone never makes an id.
TEST(Id, SlotZeroIsNullInAnyGeneration) { EXPECT_TRUE((CatId{0, 7}.is_null())); }

TEST(Id, EqualityNeedsSlotAndGeneration) {
  EXPECT_EQ((CatId{3, 5}), (CatId{3, 5}));
  EXPECT_NE((CatId{3, 5}), (CatId{3, 6}));
  EXPECT_NE((CatId{3, 5}), (CatId{4, 5}));
}

TEST(Id, OrderIsBySlotThenGeneration) {
  EXPECT_LT((CatId{1, 9}), (CatId{2, 0}));
  EXPECT_LT((CatId{2, 0}), (CatId{2, 1}));
}

}  // namespace
