// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
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

constexpr Vec3 up{0, 0, 1};

ContactPoint contact(const Vec3& point, double distance, std::uint64_t id, const Vec3& normal = up) {
  ContactPoint made{};
  made.point_a = point - 0.5 * distance * normal;
  made.point_b = point + 0.5 * distance * normal;
  made.normal = normal;
  made.distance = distance;
  made.id = id;
  return made;
}

std::vector<ContactPoint> flat_contacts(std::size_t count, test::Random& random) {
  std::vector<ContactPoint> contacts;
  for (std::uint64_t id = 0; id < count; ++id) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    contacts.push_back(contact({x, y, 0}, random.uniform(-0.1, 0), id));
  }
  return contacts;
}

std::vector<std::uint64_t> ids_of(const std::vector<ContactPoint>& contacts, std::size_t count) {
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back(contacts[i].id);
  }
  return ids;
}

// Area of the convex hull in the plane, by the angles about each point: a gift wrapped around them.
double hull_area(const std::vector<Vec3>& points) {
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    start = points[i].x < points[start].x ? i : start;
  }
  double twice = 0;
  std::size_t at = start;
  for (std::size_t step = 0; step < points.size(); ++step) {
    std::size_t next = at == 0 ? 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 a = points[next] - points[at], b = points[i] - points[at];
      next = i != at && a.x * b.y - a.y * b.x < 0 ? i : next;
    }
    twice += points[at].x * points[next].y - points[at].y * points[next].x;
    at = next;
    if (at == start) {
      break;
    }
  }
  return std::fabs(twice) / 2;
}

TEST(Reduce, NothingStaysNothing) {
  std::vector<ContactPoint> contacts;
  EXPECT_EQ(abut::reduce(contacts, 4), 0u);
}

TEST(Reduce, ZeroKeepsAllDeepestFirst) {
  test::Random random(221);
  std::vector<ContactPoint> contacts = flat_contacts(30, random);
  EXPECT_EQ(abut::reduce(contacts, 0), 30u);
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < 30; ++i) {
    ids.insert(contacts[i].id);
    EXPECT_TRUE(i == 0 || contacts[i - 1].distance <= contacts[i].distance);
  }
  EXPECT_EQ(ids.size(), 30u);
}

TEST(Reduce, FewContactsAreKept) {
  test::Random random(222);
  std::vector<ContactPoint> contacts = flat_contacts(4, random);
  EXPECT_EQ(abut::reduce(contacts, 4), 4u);
  EXPECT_TRUE(std::is_sorted(contacts.begin(), contacts.end(),
                             [](const ContactPoint& a, const ContactPoint& b) { return a.distance < b.distance; }));
}

TEST(Reduce, KeepsTheDeepestAndNoMoreThanAskedFor) {
  test::Random random(223);
  for (std::size_t most = 1; most <= 12; ++most) {
    for (const std::size_t count : {5u, 11u, 12u, 40u}) {
      const std::vector<ContactPoint> given = flat_contacts(count, random);
      std::vector<ContactPoint> contacts = given;
      const std::size_t kept = abut::reduce(contacts, most);
      EXPECT_LE(kept, most);
      const auto deepest =
          std::min_element(given.begin(), given.end(),
                           [](const ContactPoint& a, const ContactPoint& b) { return a.distance < b.distance; });
      ASSERT_GE(kept, 1u);
      EXPECT_EQ(contacts[0].id, deepest->id);
      std::set<std::uint64_t> ids;
      for (std::size_t i = 0; i < kept; ++i) {
        EXPECT_TRUE(ids.insert(contacts[i].id).second);
        EXPECT_EQ(contacts[i].distance, given[contacts[i].id].distance);
        EXPECT_EQ(contacts[i].point_a, given[contacts[i].id].point_a);
        EXPECT_TRUE(i == 0 || contacts[i - 1].distance <= contacts[i].distance);
      }
    }
  }
}

// The corners of a rim are held by features; the point between two of them where it is deepest is not.
TEST(Reduce, KeepsTheDeepestPointOfARimHoweverLittleDeeper) {
  for (const double deeper : {1e-4, 1e-6, 1e-9, 1e-15}) {
    for (const std::size_t count : {3u, 16u}) {
      std::vector<ContactPoint> given;
      for (std::uint64_t id = 0; id < count; ++id) {
        const double angle = static_cast<double>(id) * 2 * std::numbers::pi / static_cast<double>(count);
        given.push_back(flat_contact(std::cos(angle), std::sin(angle), -1e-3, id));
        given.back().feature_b = {abut::FeatureKind::vertex, static_cast<std::uint32_t>(id)};
      }
      given.push_back(flat_contact(std::cos(0.1), std::sin(0.1), -1e-3 - deeper, 99));
      for (std::size_t most = 1; most <= 6; ++most) {
        std::vector<ContactPoint> contacts = given;
        const std::size_t kept = abut::reduce(contacts, most);
        EXPECT_EQ(kept, std::min(most, count + 1)) << "from " << count << ", most " << most;
        EXPECT_EQ(contacts[0].id, 99u) << "from " << count << ", most " << most << ", deeper by " << deeper;
      }
    }
  }
}

// Of points in convex position no three others span more area with the deepest than the ones kept.
TEST(Reduce, FourOfAFewSpanTheLargestArea) {
  test::Random random(224);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const std::size_t count = 5 + static_cast<std::size_t>(round) % 7;
    std::vector<ContactPoint> contacts;
    for (std::uint64_t id = 0; id < count; ++id) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      contacts.push_back(contact({2 * std::cos(angle), std::sin(angle), 0}, random.uniform(-0.1, 0), id));
    }
    const std::vector<ContactPoint> given = contacts;
    ASSERT_EQ(abut::reduce(contacts, 4), 4u);
    const auto spot = [](const ContactPoint& c) { return 0.5 * (c.point_a + c.point_b); };
    const Vec3 deepest = spot(contacts[0]);
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          const bool has_deepest =
              given[i].id == contacts[0].id || given[j].id == contacts[0].id || given[k].id == contacts[0].id;
          if (!has_deepest) {
            largest = std::fmax(largest, hull_area({deepest, spot(given[i]), spot(given[j]), spot(given[k])}));
          }
        }
      }
    }
    EXPECT_NEAR(hull_area({deepest, spot(contacts[1]), spot(contacts[2]), spot(contacts[3])}), largest, 1e-12);
  }
}

// The corners of a crowded square hold it.
TEST(Reduce, CornersOfACrowdAreKept) {
  test::Random random(225);
  std::vector<ContactPoint> contacts{contact({-2, -2, 0}, -0.2, 1000), contact({2, -2, 0}, -0.01, 1001),
                                     contact({2, 2, 0}, -0.01, 1002), contact({-2, 2, 0}, -0.01, 1003)};
  for (const ContactPoint& inner : flat_contacts(50, random)) {
    contacts.push_back(inner);
  }
  ASSERT_EQ(abut::reduce(contacts, 4), 4u);
  const std::vector<std::uint64_t> ids = ids_of(contacts, 4);
  EXPECT_EQ((std::set<std::uint64_t>(ids.begin(), ids.end())), (std::set<std::uint64_t>{1000, 1001, 1002, 1003}));
}

TEST(Reduce, EachPatchIsReducedByItself) {
  test::Random random(226);
  std::vector<ContactPoint> contacts = flat_contacts(20, random);
  for (std::uint64_t id = 100; id < 115; ++id) {
    contacts.push_back(
        contact({3, random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(-0.1, 0), id, {1, 0, 0}));
  }
  contacts.push_back(contact({0, 9, 0}, -0.001, 200, {0, 1, 0}));
  ASSERT_EQ(abut::reduce(contacts, 4), 9u);
  int upward = 0, sideward = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    upward += contacts[i].id < 20 ? 1 : 0;
    sideward += contacts[i].id >= 100 && contacts[i].id < 115 ? 1 : 0;
  }
  EXPECT_EQ(upward, 4);
  EXPECT_EQ(sideward, 4);
}

TEST(Reduce, PatchesEndAtACosineOfNinetyEightHundredths) {
  const auto kept = [](double cosine) {
    std::vector<ContactPoint> contacts{contact({0, 0, 0}, -1, 0),
                                       contact({1, 0, 0}, -0.5, 1, {std::sqrt(1 - cosine * cosine), 0, cosine})};
    return abut::reduce(contacts, 1);
  };
  EXPECT_EQ(kept(0.981), 1u);
  EXPECT_EQ(kept(0.979), 2u);
  EXPECT_EQ(kept(-1), 2u);
}

TEST(Reduce, OrderOfTheInputDoesNotMatter) {
  test::Random random(227);
  std::vector<ContactPoint> contacts = flat_contacts(25, random);
  std::vector<ContactPoint> reversed(contacts.rbegin(), contacts.rend());
  const std::size_t kept = abut::reduce(contacts, 4);
  ASSERT_EQ(abut::reduce(reversed, 4), kept);
  EXPECT_EQ(ids_of(contacts, kept), ids_of(reversed, kept));
}

TEST(Reduce, EqualDepthsAreOrderedById) {
  std::vector<ContactPoint> contacts{contact({0, 0, 0}, -1, 7), contact({1, 0, 0}, -1, 3), contact({0, 1, 0}, -1, 5)};
  EXPECT_EQ(abut::reduce(contacts, 0), 3u);
  EXPECT_EQ(ids_of(contacts, 3), (std::vector<std::uint64_t>{3, 5, 7}));
}

TEST(Reduce, PointsAtOnePlaceAreNoTrouble) {
  std::vector<ContactPoint> contacts;
  for (std::uint64_t id = 0; id < 20; ++id) {
    contacts.push_back(contact({1, 2, 3}, -1, id));
  }
  const std::size_t kept = abut::reduce(contacts, 4);
  EXPECT_GE(kept, 1u);
  EXPECT_LE(kept, 4u);
  EXPECT_EQ(contacts[0].id, 0u);
}

}  // namespace
