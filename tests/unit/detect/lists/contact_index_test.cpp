// SPDX-License-Identifier: Apache-2.0
// Lists that are looked through and lists with a table give the same places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

import abut.capability;
import abut.detect.pairs.contact_index;
import abut.scene.state.options;

namespace {

using abut::ContactHistory;
using abut::ContactIndex;

void expect_places(const std::vector<std::uint64_t>& ids, const std::vector<std::uint64_t>& others) {
  std::vector<ContactHistory> contacts;
  for (const std::uint64_t id : ids) {
    contacts.push_back({id, 0, 0});
  }
  ContactIndex index;
  index.look_at(contacts);
  for (const auto* asked : {&ids, &others}) {
    for (const std::uint64_t id : *asked) {
      const auto first = std::ranges::find(ids, id);
      index.expect(id);
      EXPECT_EQ(index.place_of(id, contacts),
                first == ids.end() ? abut::no_index : static_cast<std::uint32_t>(first - ids.begin()));
    }
  }
}

TEST(ContactIndex, FindsTheFirstOfEachNumber) {
  for (const std::size_t count : {0u, 1u, 24u, 25u, 26u, 1000u, 5000u}) {
    std::vector<std::uint64_t> ids, others;
    for (std::uint64_t i = 0; i < count; ++i) {
      ids.push_back(i % 7 == 3 ? ids.back() : i << 40 | (i * i) % 11);
      others.push_back(i << 40 | 12);
    }
    SCOPED_TRACE(count);
    expect_places(ids, others);
  }
}

// Numbers whose hashes begin alike share slots, up to the end of the table and from its start.
TEST(ContactIndex, FindsNumbersThatShareSlots) {
  constexpr std::uint64_t inverse = 0xf1de83e19937733du;  // of the factor of the hash, modulo 2^64
  for (const std::uint64_t start : {std::uint64_t{0}, ~std::uint64_t{0} << 20}) {
    std::vector<std::uint64_t> ids, others;
    for (std::uint64_t i = 0; i < 40; ++i) {
      ids.push_back((start + i) * inverse);
      others.push_back((start + 40 + i) * inverse);
    }
    expect_places(ids, others);
  }
}

// What was looked at before is forgotten.
TEST(ContactIndex, LooksAtOneListAtATime) {
  std::vector<ContactHistory> many, few{{500, 0, 0}};
  for (std::uint64_t id = 0; id < 100; ++id) {
    many.push_back({id, 0, 0});
  }
  ContactIndex index;
  index.look_at(many);
  index.look_at(few);
  EXPECT_EQ(index.place_of(7, few), abut::no_index);
  EXPECT_EQ(index.place_of(500, few), 0u);
}

}  // namespace
