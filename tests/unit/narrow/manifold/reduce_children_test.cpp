// SPDX-License-Identifier: Apache-2.0
// Many pairs of children: each is reduced as it would be alone, and all come deepest first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.manifold;

namespace {

using abut::ContactPoint;
using Contacts = std::vector<ContactPoint>;
using Children = std::pair<std::uint32_t, std::uint32_t>;
using Name = std::tuple<double, std::uint32_t, std::uint32_t, std::uint64_t>;

Name name_of(const ContactPoint& contact) { return {contact.distance, contact.child_a, contact.child_b, contact.id}; }

// Of some pairs of children, in any order; some are as deep as others.
Contacts random_contacts(std::size_t count, std::uint32_t children, test::Random& random) {
  Contacts contacts;
  for (std::size_t i = 0; i < count; ++i) {
    ContactPoint contact{};
    contact.normal = {0, 0, 1};
    contact.point_a = contact.point_b = random.point(1);
    contact.distance = std::floor(random.uniform(-50, 10)) / 64;
    contact.id = i;
    contact.child_a = static_cast<std::uint32_t>(random.uniform(0, children));
    contact.child_b = static_cast<std::uint32_t>(random.uniform(0, children));
    contacts.push_back(contact);
  }
  return contacts;
}

abut::SurfaceSides no_surfaces(const ContactPoint&) { return {}; }

std::vector<Name> pair_by_pair(const Contacts& contacts, std::size_t most) {
  std::map<Children, Contacts> pairs;
  for (const ContactPoint& contact : contacts) {
    pairs[{contact.child_a, contact.child_b}].push_back(contact);
  }
  std::vector<Name> names;
  for (auto& [children, its] : pairs) {
    for (const ContactPoint& contact : std::span(its).first(abut::reduce(its, most))) {
      names.push_back(name_of(contact));
    }
  }
  std::ranges::sort(names);
  return names;
}

// Few contacts are sorted by comparing, many by counting.
TEST(ReduceChildren, ReducesEachPairByItself) {
  constexpr std::uint64_t seed = 77;
  SCOPED_TRACE(seed);
  test::Random random(seed);
  for (const auto& [count, children] :
       std::vector<std::pair<std::size_t, std::uint32_t>>{{5, 2}, {60, 3}, {900, 9}, {3000, 12}, {3000, 4000}}) {
    for (const std::size_t most : {0u, 1u, 4u}) {
      Contacts contacts = random_contacts(count, children, random);
      const std::vector<Name> expected = pair_by_pair(contacts, most);
      std::vector<Name> names;
      for (const ContactPoint& contact :
           std::span(contacts).first(abut::reduce_children(contacts, most, no_surfaces))) {
        names.push_back(name_of(contact));
      }
      EXPECT_EQ(names, expected) << count << ' ' << most;
    }
  }
}

}  // namespace
