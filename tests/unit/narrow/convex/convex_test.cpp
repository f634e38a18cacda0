// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../../made.hpp"
#include "../../random_boxes.hpp"
#include "../../random_shapes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.sphere;

namespace {

using abut::Box;
using abut::Capsule;
using abut::Sphere;

// Closed forms and searches give the same contacts, up to the bound that searches end at.
template <class A, class B>
void expect_contacts_of_a_search(std::uint64_t seed) {
  test::Random random(seed);
  std::size_t touching = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const A a = test::random_shape<A>(random, 0.1, 0.1);
    const B b = test::random_shape<B>(random, 0.1, 0.1);
    const abut::Pose ab{random.rotation(), random.point(1.5)};
    abut::QuerySettings settings;
    settings.margin = random.uniform(-0.1, 0.2);
    abut::Manifold found, expected;
    ASSERT_EQ(abut::convex_contacts(a, b, ab, settings, found), abut::Outcome::ok);
    settings.algorithm = abut::Algorithm::gjk_epa;
    ASSERT_EQ(abut::convex_contacts_by_search(a, b, ab, settings, expected), abut::Outcome::ok);
    ASSERT_EQ(found.size(), expected.size()) << i;
    const auto by_id = [](const abut::ContactPoint& p, const abut::ContactPoint& q) { return p.id < q.id; };
    std::ranges::sort(found, by_id);
    std::ranges::sort(expected, by_id);
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].feature_a, expected[k].feature_a);
      EXPECT_EQ(found[k].feature_b, expected[k].feature_b);
      EXPECT_EQ(found[k].id, expected[k].id);
      EXPECT_NEAR(found[k].distance, expected[k].distance, 1e-9);
      EXPECT_LE(found[k].distance, settings.margin);
      EXPECT_NEAR(dot(found[k].point_b - found[k].point_a, found[k].normal), found[k].distance, 1e-14);
      EXPECT_LE(abut::norm(found[k].point_a - expected[k].point_a), 1e-4);
      EXPECT_LE(abut::norm(found[k].normal - expected[k].normal), 1e-4);
    }
    (found.empty() ? apart : touching) += 1;
  }
  EXPECT_GT(touching, 300u);
  EXPECT_GT(apart, 100u);
}

TEST(ConvexContacts, SpheresAsASearchFindsThem) { expect_contacts_of_a_search<Sphere, Sphere>(71); }
TEST(ConvexContacts, SphereAndCapsuleAsASearchFindsThem) { expect_contacts_of_a_search<Sphere, Capsule>(72); }
TEST(ConvexContacts, CapsuleAndSphereAsASearchFindsThem) { expect_contacts_of_a_search<Capsule, Sphere>(73); }
TEST(ConvexContacts, CapsulesAsASearchFindsThem) { expect_contacts_of_a_search<Capsule, Capsule>(74); }

// Where closed forms must leave a pair to a search, its answer comes through.
TEST(ConvexContacts, WhatClosedFormsLeaveIsFound) {
  const auto capsule = test::made<Capsule>({0.5, 1});
  const auto box = test::made<Box>({1, 1, 1});
  abut::Manifold contacts;
  // Side by side: both ends of what the capsules share.
  const abut::Pose beside{abut::Rotation::identity(), {0.9, 0, 0.5}};
  ASSERT_EQ(abut::convex_contacts(capsule, capsule, beside, {}, contacts), abut::Outcome::ok);
  EXPECT_EQ(contacts.size(), 2u);
  contacts.clear();
  // One centre: any direction will do.
  const abut::Pose crossed{abut::Rotation::from({1, 1, 0, 0}), {0, 0, 0}};
  ASSERT_EQ(abut::convex_contacts(capsule, capsule, crossed, {}, contacts), abut::Outcome::ok);
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].distance, -1, 1e-12);
  contacts.clear();
  // Corner over face, apart by less than the margin.
  abut::QuerySettings settings;
  settings.margin = 0.1;
  const double reach = std::sqrt(3.0);
  // Turns the corner (-1, -1, -1) down: about (1, -1, 0) by the angle between its diagonal and z.
  const double angle = std::acos(1 / reach), s = std::sin(angle / 2) * std::sqrt(0.5);
  const abut::Rotation on_corner = abut::Rotation::from({std::cos(angle / 2), s, -s, 0});
  ASSERT_EQ(abut::convex_contacts(box, box, {on_corner, {0, 0, 1 + reach + 0.05}}, settings, contacts),
            abut::Outcome::ok);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].distance, 0.05, 1e-12);
}

TEST(ConvexContacts, AnAlgorithmThatIsAskedForIsKept) {
  const auto box = test::made<Box>({1, 1, 1});
  const abut::Pose ab{abut::Rotation::identity(), {0.25, 0.5, 1.9}};
  abut::QuerySettings settings;
  abut::Manifold contacts;
  settings.algorithm = abut::Algorithm::analytic;
  EXPECT_EQ(abut::convex_contacts(box, box, ab, settings, contacts), abut::Outcome::unsupported);
  EXPECT_TRUE(contacts.empty());
  for (const abut::Algorithm algorithm : {abut::Algorithm::automatic, abut::Algorithm::sat, abut::Algorithm::gjk_epa}) {
    settings.algorithm = algorithm;
    contacts.clear();
    EXPECT_EQ(abut::convex_contacts(box, box, ab, settings, contacts), abut::Outcome::ok);
    EXPECT_EQ(contacts.size(), 4u);
  }
}

}  // namespace
