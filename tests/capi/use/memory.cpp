// SPDX-License-Identifier: Apache-2.0
// An allocator of the host: it gives all memory of abut, gets all of it back, and may refuse.
#include "ledger.hpp"
#include "life.hpp"

namespace {

using namespace abut_test;

TEST(Allocator, GetsBackAllThatItGave) {
  Ledger ledger;
  EXPECT_EQ(live_once(true, 2), ABUT_OK);
  EXPECT_GT(ledger.asked(), 100U);
  EXPECT_EQ(ledger.given_back(), ledger.asked());
}

TEST(Allocator, GivesWhatAbutSaysThatItHas) {
  Ledger ledger;
  const std::vector<Shape> shapes = make_one_of_each_kind();
  Universe universe;
  for (const Shape& shape : shapes) universe.add(shape, identity);
  require(abut_universe_step(universe, 0.01));
  std::uint64_t bytes = 0, blocks = 0;
  require(abut_memory_in_use(&bytes, &blocks));
  EXPECT_GT(blocks, shapes.size());
  EXPECT_EQ(blocks, ledger.blocks());
  EXPECT_EQ(bytes, ledger.bytes());
}

// Each request of a whole program is refused in turn.
TEST(Allocator, MayRefuseAnyRequest) {
  Ledger ledger;
  std::size_t refused = 0;
  for (int status = ABUT_OUT_OF_MEMORY; status != ABUT_OK; ++refused) {
    ledger.refuse_after(refused);
    status = live_once(true, 2);
    ASSERT_TRUE(status == ABUT_OK || status == ABUT_OUT_OF_MEMORY)
        << abut_status_name(status) << " when request " << refused << " is refused: " << abut_last_error_message();
    ASSERT_EQ(ledger.blocks(), 0U) << "when request " << refused << " is refused";
  }
  EXPECT_GT(refused, 100U);
}

TEST(Allocator, IsRefusedWhatIsNotAligned) {
  Ledger ledger;
  ledger.shift_addresses(true);
  Out<abut_shape*> shape;
  EXPECT_TRUE(refused(abut_sphere_create(1, shape.address()), ABUT_OUT_OF_MEMORY, {"not enough memory"}));
  EXPECT_TRUE(shape.is_untouched());
  EXPECT_GT(ledger.asked(), 0U);
  EXPECT_EQ(ledger.given_back(), ledger.asked());
}

}  // namespace
