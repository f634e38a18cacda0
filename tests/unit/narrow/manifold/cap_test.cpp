// SPDX-License-Identifier: Apache-2.0
// The cap of a pair: few contacts of many, the deepest one among them, spread over normals and places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "../../random_boxes.hpp"
#include "reduction.hpp"

import abut.capability;
import abut.math;
import abut.narrow.manifold;

namespace {

using abut::ContactPoint;
using abut::Vec3;
using test::flat_contact;
using Contacts = std::vector<ContactPoint>;

// A ball of radius one that is touched from all sides.
Contacts of_ball(std::size_t count, test::Random& random) {
  Contacts contacts;
  while (contacts.size() < count) {
    const Vec3 p = random.point(1);
    if (const double length = abut::norm(p); length > 0.1 && length < 1) {
      ContactPoint contact{};
      contact.normal = (1 / length) * p;
      contact.point_a = contact.point_b = contact.normal;
      contact.distance = random.uniform(-1, 0);
      contact.id = contacts.size();
      contacts.push_back(contact);
    }
  }
  return contacts;
}

std::set<std::uint64_t> kept_of(Contacts contacts, std::size_t most) {
  std::set<std::uint64_t> ids;
  for (const ContactPoint& contact : std::span(contacts).first(abut::cap(contacts, most))) {
    ids.insert(contact.id);
  }
  return ids;
}

TEST(Cap, NothingStaysNothing) {
  Contacts none;
  EXPECT_EQ(abut::cap(none, 4), 0u);
}

TEST(Cap, ZeroKeepsAllDeepestFirst) {
  test::Random random(901);
  Contacts contacts = of_ball(200, random);
  EXPECT_EQ(abut::cap(contacts, 0), 200u);
  EXPECT_TRUE(std::ranges::is_sorted(contacts, {}, &ContactPoint::distance));
}

TEST(Cap, KeepsTheDeepestAndAsManyAsAskedFor) {
  test::Random random(902);
  for (const std::size_t count : {1u, 3u, 20u, 840u}) {
    for (std::size_t most = 1; most <= 40; ++most) {
      Contacts contacts = of_ball(count, random);
      const double deepest = std::ranges::min(contacts, {}, &ContactPoint::distance).distance;
      const std::size_t kept = abut::cap(contacts, most);
      EXPECT_EQ(kept, std::min(count, most));
      EXPECT_EQ(contacts[0].distance, deepest);
      EXPECT_TRUE(std::ranges::is_sorted(std::span(contacts).first(kept), {}, &ContactPoint::distance));
    }
  }
}

TEST(Cap, OrderOfTheInputDoesNotMatter) {
  test::Random random(903);
  for (int round = 0; round < 50; ++round) {
    Contacts contacts = of_ball(100, random), other = contacts;
    std::ranges::reverse(other);
    std::ranges::rotate(other, other.begin() + round);
    for (const std::size_t most : {1u, 4u, 12u, 64u}) {
      EXPECT_EQ(kept_of(contacts, most), kept_of(other, most));
    }
  }
}

// No fifteen normals are further apart than 53.7 degrees (Tammes' problem). So none is further than that from the
// fourteen kept, but for the 11.5 degrees of a cluster: the cosine of both is 0.42.
TEST(Cap, NormalsAllAroundAreAllCovered) {
  test::Random random(904);
  for (int round = 0; round < 50; ++round) {
    Contacts contacts = of_ball(840, random);
    const std::size_t kept = abut::cap(contacts, 14);
    for (const ContactPoint& contact : contacts) {
      const auto is_near = [&](const ContactPoint& other) { return abut::dot(other.normal, contact.normal) > 0.42; };
      EXPECT_TRUE(std::ranges::any_of(std::span(contacts).first(kept), is_near)) << "round " << round;
    }
  }
}

TEST(Cap, EveryClusterKeepsItsDeepest) {
  test::Random random(905);
  Contacts contacts;
  for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (int i = 0; i < 20; ++i) {
      ContactPoint contact{};
      contact.normal = normal;
      contact.point_a = contact.point_b = random.point(1);
      contact.distance = random.uniform(-1, 0);
      contact.id = contacts.size();
      contacts.push_back(contact);
    }
  }
  for (const std::size_t most : {3u, 4u, 10u}) {
    const std::set<std::uint64_t> kept = kept_of(contacts, most);
    for (std::size_t cluster = 0; cluster < 3; ++cluster) {
      EXPECT_TRUE(kept.contains(
          std::ranges::min(std::span(contacts).subspan(20 * cluster, 20), {}, &ContactPoint::distance).id));
    }
  }
}

TEST(Cap, CornersOfAFloorAreKept) {
  Contacts contacts;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      contacts.push_back(flat_contact(x, y, -1, static_cast<std::uint64_t>(10 * x + y)));
    }
  }
  EXPECT_EQ(kept_of(contacts, 4), (std::set<std::uint64_t>{0, 9, 90, 99}));
}

}  // namespace
