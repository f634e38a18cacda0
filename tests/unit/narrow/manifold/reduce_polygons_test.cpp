// SPDX-License-Identifier: Apache-2.0
// What a reduction to four keeps of random patches: the deepest point, and the area.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
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
using test::flat_contact;
using test::hull_area;

// Patches of less area are lines within the tie.
constexpr double line = 4 * 4 * abut::tied_depth;

using Maker = std::function<ContactPoint(test::Random&, std::uint64_t id)>;

// Points of a disc, of an ellipse, of a strip as narrow as given, and crowds of a few places.
ContactPoint in_a_square(test::Random& random, std::uint64_t id) {
  return flat_contact(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.1, 0), id);
}
ContactPoint on_an_ellipse(test::Random& random, std::uint64_t id) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return flat_contact(2 * std::cos(angle), std::sin(angle), random.uniform(-0.1, 0), id);
}
Maker in_a_strip(double width) {
  return [width](test::Random& random, std::uint64_t id) {
    return flat_contact(random.uniform(-1, 1), width * random.uniform(-1, 1), random.uniform(-1e-3, 0), id);
  };
}
ContactPoint in_a_crowd(test::Random& random, std::uint64_t id) {
  const double x = std::round(random.uniform(-1.5, 1.5)), y = std::round(random.uniform(-1.5, 1.5));
  return flat_contact(x + random.uniform(-1e-9, 1e-9), y + random.uniform(-1e-9, 1e-9), random.uniform(-1e-6, 0), id);
}

std::vector<ContactPoint> patch_of(std::size_t count, const Maker& make, test::Random& random) {
  std::vector<ContactPoint> contacts;
  for (std::uint64_t id = 0; id < count; ++id) {
    contacts.push_back(make(random, id));
  }
  return contacts;
}

// The largest area that the deepest point spans with three others.
double largest_area(const std::vector<ContactPoint>& sorted) {
  double largest = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size(); ++j) {
      for (std::size_t k = j + 1; k < sorted.size(); ++k) {
        largest = std::fmax(largest, hull_area(std::vector<ContactPoint>{sorted[0], sorted[i], sorted[j], sorted[k]}));
      }
    }
  }
  return largest;
}

struct Tally {
  int patches = 0, falling_short = 0;
};

// Reduces patches of 5 to 64 points. A patch falls short where both hold: it keeps less than nine tenths of the area of
// all its points; it keeps less than 95 % of the most that four can span.
Tally reduce_patches(int rounds, const Maker& make, std::uint64_t seed) {
  test::Random random(seed);
  Tally tally;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const auto count = static_cast<std::size_t>(round % 8 == 7 ? random.uniform(12, 65) : random.uniform(5, 20));
    std::vector<ContactPoint> contacts = patch_of(count, make, random);
    const double whole = hull_area(contacts);
    const std::size_t kept = abut::reduce(contacts, 4);
    EXPECT_LE(kept, 4u);
    const auto deepest = std::ranges::min_element(contacts, {}, &ContactPoint::distance);
    EXPECT_EQ(contacts[0].id, deepest->id);
    ++tally.patches;
    const double area = hull_area(std::span(contacts).first(kept));
    if (area < 0.9 * whole) {
      std::ranges::sort(contacts, {}, &ContactPoint::distance);
      tally.falling_short += area < 0.95 * largest_area(contacts) ? 1 : 0;
    }
  }
  return tally;
}

TEST(ReducePolygons, OfFewPointsKeepTheMostThatFourCanSpan) {
  for (const Maker& make : {Maker(in_a_square), Maker(on_an_ellipse), in_a_strip(1e-3), Maker(in_a_crowd)}) {
    test::Random random(241);
    for (int round = 0; round < 300; ++round) {
      std::vector<ContactPoint> contacts = patch_of(5 + static_cast<std::size_t>(round) % 7, make, random);
      const std::size_t kept = abut::reduce(contacts, 4);
      const double area = hull_area(std::span(contacts).first(kept));
      std::ranges::sort(contacts, {}, &ContactPoint::distance);
      const double largest = largest_area(contacts);
      EXPECT_TRUE(area >= 0.95 * largest || largest < line) << area << " of " << largest;
    }
  }
}

TEST(ReducePolygons, OfManyPointsKeepTheMostOfNinetyNineInAHundred) {
  std::uint64_t seed = 242;
  for (const Maker& make :
       {Maker(in_a_square), Maker(on_an_ellipse), in_a_strip(0.1), in_a_strip(1e-3), Maker(in_a_crowd)}) {
    const Tally tally = reduce_patches(400, make, ++seed);
    EXPECT_LE(tally.falling_short, tally.patches / 100) << "seed " << seed;
    RecordProperty("falling_short_" + std::to_string(seed), tally.falling_short);
  }
}

// Of points on a line, also one that is not quite straight, the ends stay.
TEST(ReducePolygons, OfALineKeepItsEnds) {
  test::Random random(248);
  for (const double width : {0.0, 1e-16, 1e-12, 1e-8, 1e-6}) {
    for (const std::size_t count : {5u, 12u, 40u}) {
      std::vector<ContactPoint> contacts;
      double low = 1, high = -1;
      for (std::uint64_t id = 0; id < count; ++id) {
        const double x = random.uniform(-1, 1);
        low = std::fmin(low, x);
        high = std::fmax(high, x);
        contacts.push_back(flat_contact(x, 0.5 * x + width * random.uniform(-1, 1), random.uniform(-0.1, 0), id));
      }
      const std::size_t kept = abut::reduce(contacts, 4);
      const auto has = [&](double x) {
        return std::ranges::any_of(std::span(contacts).first(kept),
                                   [&](const ContactPoint& c) { return c.point_a.x == x; });
      };
      EXPECT_TRUE(has(low) && has(high)) << count << " points, width " << width;
    }
  }
}

TEST(ReducePolygons, OfOneOrTwoPlacesKeepEach) {
  for (const double apart : {0.0, 1e-3, 1e3}) {
    std::vector<ContactPoint> contacts;
    for (std::uint64_t id = 0; id < 20; ++id) {
      contacts.push_back(flat_contact(id % 2 == 0 ? 0 : apart, 0, -1, id));
    }
    EXPECT_EQ(abut::reduce(contacts, 4), apart > 0 ? 2u : 1u);
  }
}

// What is not kept still is in the list, behind what is.
TEST(ReducePolygons, NoContactIsLost) {
  test::Random random(249);
  std::vector<ContactPoint> contacts = patch_of(40, in_a_square, random);
  for (ContactPoint& contact : std::span(contacts).first(20)) {
    const abut::Vec3 p = contact.point_a;
    contact.point_a = contact.point_b = {0, p.x, p.y};
    contact.normal = {1, 0, 0};
  }
  EXPECT_EQ(abut::reduce(contacts, 4), 8u);
  std::vector<std::uint64_t> ids;
  for (const ContactPoint& contact : contacts) {
    ids.push_back(contact.id);
  }
  std::ranges::sort(ids);
  EXPECT_TRUE(std::ranges::adjacent_find(ids) == ids.end());
}

}  // namespace
