// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>

import abut.capability;

namespace {

// The first contact of each number keeps it; others of that number get numbers that no other has.
TEST(NumberApart, LeavesNoNumberTwice) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    abut::Manifold contacts(random() % 12);
    for (abut::ContactPoint& contact : contacts) {
      const auto face = static_cast<std::uint32_t>(random() % 3), edge = static_cast<std::uint32_t>(random() % 3);
      contact.id = abut::contact_id({abut::FeatureKind::face, face}, {abut::FeatureKind::edge, edge});
    }
    const abut::Manifold before = contacts;
    number_apart(contacts);
    std::set<std::uint64_t> met, numbers;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (met.insert(before[i].id).second) {
        EXPECT_EQ(contacts[i].id, before[i].id);
      }
      EXPECT_TRUE(numbers.insert(contacts[i].id).second);
    }
  }
}

}  // namespace
