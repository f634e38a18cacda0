// SPDX-License-Identifier: Apache-2.0
// The order of depth is that of a plain sort, of few contacts and of many, with ties and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "../../random_boxes.hpp"
#include "reduction.hpp"

import abut.capability;
import abut.narrow.manifold.depth_order;

namespace {

using abut::ContactPoint;
using Numbers = std::vector<std::uint32_t>;

// Depths are one of `depths`, ids one of half as many as there are contacts.
std::vector<ContactPoint> random_contacts(std::size_t count, double depths, test::Random& random) {
  std::vector<ContactPoint> contacts;
  for (std::size_t i = 0; i < count; ++i) {
    const double id = std::floor(random.uniform(0, 0.5 * static_cast<double>(count)));
    contacts.push_back(test::flat_contact(static_cast<double>(i), 0, std::floor(random.uniform(0, depths)),
                                          static_cast<std::uint64_t>(id)));
  }
  return contacts;
}

Numbers sorted_numbers(const std::vector<ContactPoint>& contacts) {
  Numbers numbers(contacts.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::ranges::sort(numbers, {}, [&](std::uint32_t number) {
    return std::tuple(contacts[number].distance, contacts[number].id, number);
  });
  return numbers;
}

TEST(DepthOrder, IsThatOfAPlainSort) {
  test::Random random(281);
  for (const std::size_t count : {0u, 1u, 2u, 5u, 81u, 255u, 256u, 257u, 1000u}) {
    for (const double depths : {1.0, 3.0, 50.0, 1e9}) {
      SCOPED_TRACE(std::to_string(count) + " contacts, " + std::to_string(depths) + " depths");
      const std::vector<ContactPoint> contacts = random_contacts(count, depths, random);
      const abut::Numbers order = abut::depth_order(contacts);
      const Numbers expected = sorted_numbers(contacts);
      EXPECT_TRUE(std::ranges::equal(order.span(), expected));
    }
  }
}

TEST(DepthOrder, LosesNoContactWhoseDistanceIsNoNumber) {
  test::Random random(283);
  std::vector<ContactPoint> contacts = random_contacts(20, 50, random);
  contacts[7].distance = contacts[12].distance = std::nan("");
  const abut::Numbers order = abut::depth_order(contacts);
  Numbers rising(order.span().begin(), order.span().end());
  std::ranges::sort(rising);
  for (std::uint32_t number = 0; number < 20; ++number) {
    EXPECT_EQ(rising[number], number);
  }
}

// The x of a contact tells where it came from.
TEST(BringToFront, MovesSomeAndLosesNone) {
  test::Random random(282);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const auto count = static_cast<std::uint32_t>(random.uniform(1, 60));
    std::vector<ContactPoint> contacts = random_contacts(count, 5, random);
    Numbers all(count);
    std::iota(all.begin(), all.end(), 0u);
    for (std::size_t i = count; i > 1; --i) {
      std::swap(all[i - 1], all[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)))]);
    }
    Numbers some(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(random.uniform(0, count + 1)));
    const Numbers wanted = some;
    abut::bring_to_front(contacts, some);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(contacts[i].point_a.x, wanted[i]);
    }
    std::ranges::sort(contacts, {}, [](const ContactPoint& contact) { return contact.point_a.x; });
    for (std::uint32_t i = 0; i < count; ++i) {
      EXPECT_EQ(contacts[i].point_a.x, i);
    }
  }
}

}  // namespace
