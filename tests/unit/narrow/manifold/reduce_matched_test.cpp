// SPDX-License-Identifier: Apache-2.0
// A reduction that knows what the one before kept: the set stays while it holds a body as well as another one would.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
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
using test::flat_contact;
using test::hull_area;

using Ids = std::vector<std::uint64_t>;

// Ids of what is kept of a patch, in rising order.
Ids kept_of(std::vector<ContactPoint> contacts, const Ids& before) {
  Ids ids;
  for (const ContactPoint& contact : std::span(contacts).first(abut::reduce(contacts, 4, before))) {
    ids.push_back(contact.id);
  }
  std::ranges::sort(ids);
  return ids;
}

// The rim of a disc of radius one that stands on a plane, tilted by small angles about X and Y.
std::vector<ContactPoint> tilted_rim(double about_x, double about_y) {
  std::vector<ContactPoint> contacts;
  for (std::uint64_t id = 0; id < 16; ++id) {
    const double angle = static_cast<double>(id) * std::numbers::pi / 8, x = std::cos(angle), y = std::sin(angle);
    contacts.push_back(flat_contact(x, y, -1e-3 + about_x * y - about_y * x, id));
  }
  return contacts;
}

// How often a point of the first kept set is lost while the rim shakes by 0.2 micrometres. The deepest is always kept.
int losses_while_shaking(bool is_matched) {
  test::Random random(261);
  int losses = 0;
  const Ids first = kept_of(tilted_rim(0, 0), {});
  Ids before = first;
  for (int step = 0; step < 1000; ++step) {
    const std::vector<ContactPoint> rim = tilted_rim(random.uniform(-2e-7, 2e-7), random.uniform(-2e-7, 2e-7));
    const Ids kept = kept_of(rim, is_matched ? before : Ids{});
    EXPECT_LE(kept.size(), 5u);
    const auto deepest = std::ranges::min_element(rim, {}, &ContactPoint::distance);
    EXPECT_TRUE(std::ranges::binary_search(kept, deepest->id)) << "step " << step;
    losses += std::ranges::includes(kept, first) ? 0 : 1;
    before = kept;
  }
  return losses;
}

TEST(ReduceMatched, ARimThatShakesKeepsItsFourPoints) {
  EXPECT_EQ(losses_while_shaking(true), 0);
  EXPECT_GT(losses_while_shaking(false), 100) << "the scene must need the ids";
}

TEST(ReduceMatched, WithoutIdsThatOccurNothingChanges) {
  test::Random random(262);
  for (int round = 0; round < 100; ++round) {
    std::vector<ContactPoint> contacts;
    for (std::uint64_t id = 0; id < 5 + static_cast<std::uint64_t>(round) % 30; ++id) {
      contacts.push_back(flat_contact(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 0), id));
    }
    EXPECT_EQ(kept_of(contacts, {}), kept_of(contacts, {1000, 1001}));
  }
}

TEST(ReduceMatched, ADeeperPointIsOneMoreOrReplacesOne) {
  const Ids before{0, 4, 8, 12};
  std::vector<ContactPoint> contacts = tilted_rim(0, 0);
  contacts[3].distance -= 0.5 * abut::tied_depth * 2;
  EXPECT_EQ(kept_of(contacts, before), (Ids{0, 3, 4, 8, 12})) << "a tie";
  contacts[3].distance -= abut::tied_depth * 2;
  const Ids kept = kept_of(contacts, before);
  EXPECT_TRUE(std::ranges::binary_search(kept, 3u)) << "no tie";
  EXPECT_EQ(kept.size(), 4u);
}

TEST(ReduceMatched, AWiderFourReplacesOneThatIsTooNarrow) {
  const auto kept_beside = [](double width) {
    std::vector<ContactPoint> contacts{flat_contact(-1, -1, -1, 0),  flat_contact(1, -1, 0, 1),
                                       flat_contact(1, width, 0, 2), flat_contact(-1, width, 0, 3),
                                       flat_contact(1, 1, 0, 4),     flat_contact(-1, 1, 0, 5)};
    return kept_of(contacts, {0, 1, 2, 3});
  };
  EXPECT_EQ(kept_beside(0.91), (Ids{0, 1, 2, 3}));
  EXPECT_EQ(kept_beside(0.89), (Ids{0, 1, 4, 5}));
}

// Points that went away are replaced, the rest stays.
TEST(ReduceMatched, WhatIsLeftStays) {
  std::vector<ContactPoint> contacts = tilted_rim(0, 0);
  contacts.erase(contacts.begin() + 8);
  const Ids kept = kept_of(contacts, {1, 4, 8, 13});
  ASSERT_EQ(kept.size(), 4u);
  for (const std::uint64_t id : {1u, 4u, 13u}) {
    EXPECT_TRUE(std::ranges::binary_search(kept, id)) << id;
  }
}

// A patch whose points wander by a share of its size.
class Wanderer {
 public:
  Wanderer(std::size_t count, std::uint64_t seed) : random_(seed) {
    for (std::uint64_t id = 0; id < count; ++id) {
      contacts_.push_back(flat_contact(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1e-3, 0), id));
    }
  }
  void move(double step) {
    for (ContactPoint& contact : contacts_) {
      contact = flat_contact(contact.point_a.x + random_.uniform(-step, step),
                             contact.point_a.y + random_.uniform(-step, step),
                             contact.distance + 1e-3 * random_.uniform(-step, step), contact.id);
    }
  }
  [[nodiscard]] const std::vector<ContactPoint>& contacts() const { return contacts_; }
  [[nodiscard]] std::vector<ContactPoint> of(const Ids& ids) const {
    std::vector<ContactPoint> found;
    for (const std::uint64_t id : ids) {
      found.push_back(contacts_[id]);
    }
    return found;
  }
  [[nodiscard]] double depth_of(const Ids& ids) const {
    double least = 0;
    for (const std::uint64_t id : ids) {
      least = std::fmin(least, contacts_[id].distance);
    }
    return least;
  }
  // The least of the areas that fresh choices span. Each choice takes as its deepest one of the points that are no
  // less deep than a limit.
  [[nodiscard]] double least_area_about(const Ids& ids, double limit) const {
    double least = 1e300;
    for (const std::uint64_t id : ids) {
      if (contacts_[id].distance <= limit) {
        std::vector<ContactPoint> deepened = contacts_;
        deepened[id].distance = -1;
        least = std::fmin(least, hull_area(of(kept_of(deepened, {}))));
      }
    }
    return least;
  }

 private:
  test::Random random_;
  std::vector<ContactPoint> contacts_;
};

// The deepest stays; what stays spans 95 % of what a fresh choice does for one of its points that tie, and changes only
// when it must.
TEST(ReduceMatched, WanderingPointsStayAsLongAsTheyHold) {
  constexpr double tie = 6 * abut::tied_depth;  // no patch here is wider than six units
  int changes = 0;
  for (std::size_t count = 5; count <= 40; count += 5) {
    SCOPED_TRACE(std::to_string(count) + " points");
    Wanderer patch(count, 263 + count);
    Ids before = kept_of(patch.contacts(), {}), all;
    for (std::uint64_t id = 0; id < count; ++id) {
      all.push_back(id);
    }
    for (int step = 0; step < 1000; ++step) {
      patch.move(1e-2);
      const Ids kept = kept_of(patch.contacts(), before);
      const double deepest = patch.depth_of(all), enough = 0.95 * patch.least_area_about(kept, deepest + tie) - 1e-12;
      EXPECT_LE(kept.size(), 5u);
      EXPECT_EQ(patch.depth_of(kept), deepest);
      EXPECT_GE(hull_area(patch.of(kept)), enough);
      if (patch.depth_of(before) == deepest && before.size() == 4 &&
          hull_area(patch.of(before)) >= 0.95 * patch.least_area_about(before, deepest) + 1e-12) {
        EXPECT_EQ(kept, before) << "step " << step;
      }
      changes += kept != before ? 1 : 0;
      before = kept;
    }
  }
  EXPECT_GT(changes, 0) << "points that wander far enough are exchanged";
}

// Two patches at a right angle whose deepest points take turns by less than the tie.
TEST(ReduceMatched, PatchesStayWhenTheirDeepestTakeTurns) {
  Ids before, first;
  for (int step = 0; step < 20; ++step) {
    std::vector<ContactPoint> contacts = tilted_rim(step % 2 == 0 ? 1e-7 : -1e-7, 1e-7);
    for (std::uint64_t id = 0; id < 8; ++id) {
      ContactPoint wall = flat_contact(2, 0, -1e-3 + (step % 2 == 0 ? 1e-7 : -1e-7), 100 + id);
      wall.normal = {1, 0, 0};
      wall.point_a = wall.point_b = {2, std::cos(static_cast<double>(id)), std::sin(static_cast<double>(id))};
      contacts.push_back(wall);
    }
    const Ids kept = kept_of(contacts, before);
    first = step == 0 ? kept : first;
    EXPECT_LE(kept.size(), 10u) << "four of each patch and the deepest";
    EXPECT_TRUE(std::ranges::includes(kept, first)) << "step " << step;
    before = kept;
  }
}

}  // namespace
