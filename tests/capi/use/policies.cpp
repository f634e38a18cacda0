// SPDX-License-Identifier: Apache-2.0
// Policies: pairs of tags with algorithms, details and rates of their own over one broad phase. PL-02 of the
// specification.
#include <cmath>
#include <set>
#include <tuple>

#include "support.hpp"

namespace {

using namespace abut_test;

abut_geometry_options tagged(std::uint32_t tag, double tolerance = 0) {
  abut_geometry_options options = default_geometry_options();
  options.tag = tag;
  options.tolerance = tolerance;
  return options;
}

// A box with tag 1 that sinks, slightly turned, into a slab with tag 2.
struct Sinking {
  explicit Sinking(const abut_universe_options* options = nullptr) : universe(options) {
    universe.add_geometry(universe.add_part(at(0, 0, -1), ABUT_MOTION_STATIC), slab, tagged(2));
    part = universe.add_part(pose_at(0.99));
    universe.add_geometry(part, cube, tagged(1));
  }
  static abut_pose pose_at(double z) { return {{0, 0, z}, {std::cos(0.002), 0, std::sin(0.002), 0}}; }
  void set(const abut_policy& policy) { EXPECT_TRUE(succeeded(abut_policy_set(universe, 1, 2, &policy))); }

  Shape slab = make_box(4, 4, 1);
  Shape cube = make_box(1, 1, 1);
  Universe universe;
  abut_part_id part{};
};

TEST(Policies, ReadBackInEitherOrder) {
  const Universe universe;
  abut_policy policy = default_policy();
  policy.algorithm = ABUT_ALGORITHM_GJK_EPA;
  policy.detail = ABUT_DETAIL_POINT;
  policy.period = 9;
  policy.tolerance = 0.5;
  policy.error_bound = 1e-6;
  policy.time_budget = 1e-7;
  ASSERT_TRUE(succeeded(abut_policy_set(universe, 63, 0, &policy)));
  for (const auto& [a, b] : {std::pair{63U, 0U}, std::pair{0U, 63U}}) {
    abut_policy found = default_policy();
    ASSERT_TRUE(succeeded(abut_policy_get(universe, a, b, &found)));
    EXPECT_EQ(found.algorithm, policy.algorithm);
    EXPECT_EQ(found.detail, policy.detail);
    EXPECT_EQ(found.period, policy.period);
    EXPECT_EQ(found.tolerance, policy.tolerance);
    EXPECT_EQ(found.error_bound, policy.error_bound);
    EXPECT_EQ(found.time_budget, policy.time_budget);
  }
  for (const auto& [a, b] : {std::pair{0U, 0U}, std::pair{63U, 63U}, std::pair{62U, 0U}}) {
    abut_policy found = policy;
    ASSERT_TRUE(succeeded(abut_policy_get(universe, a, b, &found)));
    EXPECT_EQ(found.period, 1U) << "no other pair of tags has it";
    EXPECT_EQ(found.tolerance, -1.0);
  }
  ASSERT_TRUE(succeeded(abut_policy_set(universe, 0, 63, nullptr)));
  ASSERT_TRUE(succeeded(abut_policy_get(universe, 63, 0, &policy)));
  EXPECT_EQ(policy.period, 1U);
}

TEST(Policies, APointIsTheDeepestOne) {
  Sinking scene;
  const auto all = scene.universe.step();
  ASSERT_EQ(all.size(), 4U);
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_POINT;
  scene.set(policy);
  const auto point = scene.universe.step();
  ASSERT_EQ(point.size(), 1U);
  EXPECT_EQ(point.at(0).distance, all.at(0).distance) << "contacts are sorted, deepest first";
  EXPECT_LT(all.at(0).distance, all.at(3).distance - 1e-3) << "the scene has to have a deepest one";
}

TEST(Policies, OfBoxesHaveNoContacts) {
  Sinking scene;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_BOX;
  scene.set(policy);
  EXPECT_TRUE(scene.universe.step().empty());
  EXPECT_EQ(scene.universe.events().size(), 1U);
  EXPECT_EQ(scene.universe.stats().examined_pairs, 0U);
  EXPECT_EQ(scene.universe.stats().touching_pairs, 1U);
  ASSERT_TRUE(succeeded(abut_policy_set(scene.universe, 2, 1, nullptr)));
  EXPECT_EQ(scene.universe.step().size(), 4U);
}

TEST(Policies, OfTouchesHaveEventsAndNoContacts) {
  Sinking scene;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_TOUCH;
  scene.set(policy);
  EXPECT_TRUE(scene.universe.step().empty());
  EXPECT_EQ(letters_of(scene.universe.events()), "b");
  EXPECT_EQ(scene.universe.stats().examined_pairs, 1U);
  EXPECT_EQ(scene.universe.stats().touching_pairs, 1U);
  scene.universe.move(scene.part, Sinking::pose_at(1.05));
  EXPECT_TRUE(scene.universe.step().empty());
  EXPECT_EQ(letters_of(scene.universe.events()), "e");
  scene.universe.move(scene.part, Sinking::pose_at(0.99));
  ASSERT_TRUE(succeeded(abut_policy_set(scene.universe, 2, 1, nullptr)));
  EXPECT_EQ(scene.universe.step().size(), 4U);
}

// A pair that is found anew in every third step keeps what it has in between, and a new pair does not wait.
TEST(Policies, APeriodKeepsContactsInBetween) {
  for (int waits = 0; waits < 3; ++waits) {
    Sinking scene;
    abut_policy policy = default_policy();
    policy.period = 3;
    scene.set(policy);
    scene.universe.move(scene.part, at(0, 0, 5));
    for (int i = 0; i < waits; ++i) EXPECT_TRUE(scene.universe.step().empty());
    double last = 0;
    std::vector<int> changed;
    for (int step = 0; step < 10; ++step) {
      scene.universe.move(scene.part, at(0, 0, 0.99 - 0.01 * step));
      const auto contacts = scene.universe.step();
      ASSERT_EQ(contacts.size(), 4U);
      EXPECT_EQ(contacts.at(0).age, static_cast<std::uint32_t>(step)) << "kept contacts grow older";
      if (contacts.at(0).distance != last) {
        EXPECT_NEAR(contacts.at(0).distance, -0.01 * (step + 1), 1e-12) << "what is found is of the present pose";
        changed.push_back(step);
      }
      last = contacts.at(0).distance;
    }
    EXPECT_EQ(changed.at(0), 0) << "a new pair is found at once";
    for (std::size_t i = 2; i < changed.size(); ++i) EXPECT_EQ(changed.at(i) - changed.at(i - 1), 3);
    EXPECT_LE(changed.at(1), 3);
  }
}

TEST(Policies, ToleranceReplacesTheSum) {
  for (const auto mode : {ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN}) {
    abut_universe_options options = default_universe_options();
    options.tolerance_mode = mode;
    Universe universe(&options);
    const Shape ball = make_sphere(1.0);
    universe.add_geometry(universe.add_part(identity), ball, tagged(1, 0.01));
    const abut_part_id part = universe.add_part(identity);
    universe.add_geometry(part, ball, tagged(2, 0.01));
    const auto has_contact = [&](double limit) {
      const double sign = mode == ABUT_TOLERANCE_MARGIN ? 1 : -1;
      for (const double beside : {-1e-6, 1e-6}) {
        universe.move(part, at(2 + sign * limit + beside, 0, 0));
        EXPECT_EQ(universe.step().size(), beside < 0 ? 1U : 0U) << "limit " << limit;
      }
    };
    has_contact(0.02);
    for (const double tolerance : {0.3, 0.001, 0.0}) {
      abut_policy policy = default_policy();
      policy.tolerance = tolerance;
      ASSERT_TRUE(succeeded(abut_policy_set(universe, 1, 2, &policy)));
      has_contact(tolerance);
    }
    ASSERT_TRUE(succeeded(abut_policy_set(universe, 1, 2, nullptr)));
    has_contact(0.02);
  }
}

// A change of a policy is seen at the next step, also where nothing moves.
TEST(Policies, TakeEffectOnPairsAtRest) {
  Sinking scene;
  EXPECT_EQ(scene.universe.step().size(), 4U);
  EXPECT_EQ(scene.universe.step().size(), 4U);
  EXPECT_EQ(scene.universe.stats().kept_pairs, 1U) << "the pair has to be at rest";
  abut_policy policy = default_policy();
  policy.tolerance = 0.5;
  scene.set(policy);
  EXPECT_TRUE(scene.universe.step().empty());
  ASSERT_TRUE(succeeded(abut_policy_set(scene.universe, 1, 2, nullptr)));
  EXPECT_EQ(scene.universe.step().size(), 4U);
}

// What each contact is, but for what it remembers.
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t, double, double, double, double>;

std::set<Key> keys_of(const std::vector<abut_contact>& contacts) {
  std::set<Key> keys;
  for (const abut_contact& c : contacts) {
    keys.insert({c.geometry_a.slot, c.geometry_b.slot, c.id, c.distance, c.point_a.x, c.point_b.y, c.normal.z});
  }
  return keys;
}

std::array<abut_policy, 3> three_policies() {
  std::array<abut_policy, 3> policies{default_policy(), default_policy(), default_policy()};
  policies[1].detail = ABUT_DETAIL_POINT;
  policies[2].algorithm = ABUT_ALGORITHM_GJK_EPA;
  policies[2].tolerance = 0.05;
  return policies;
}

// A heap of boxes and hulls of three tags; the pairs of tag i with tag j have policy (i + j) % 3, if that is in use.
std::vector<abut_contact> heap_under(const std::vector<std::uint32_t>& in_use) {
  Universe universe;
  const auto policies = three_policies();
  for (std::uint32_t a = 0; a < 3; ++a) {
    for (std::uint32_t b = a; b < 3; ++b) {
      const std::uint32_t wanted = (a + b) % 3;
      abut_policy policy = policies.at(wanted);
      const bool is_on = std::find(in_use.begin(), in_use.end(), wanted) != in_use.end();
      if (!is_on) policy.detail = ABUT_DETAIL_BOX;
      EXPECT_TRUE(succeeded(abut_policy_set(universe, a, b, &policy)));
    }
  }
  const Shape cube = make_box(0.5, 0.5, 0.5), hull = make_octahedron(0.7);
  for (std::uint32_t i = 0; i < 60; ++i) {
    const abut_pose pose{{0.7 * (i % 4), 0.7 * (i / 4 % 4), 0.7 * (i / 16)},
                         {std::cos(0.3 * i), std::sin(0.3 * i), 0, 0}};
    universe.add_geometry(universe.add_part(pose), i % 2 == 0 ? cube : hull, tagged(i % 3));
  }
  return universe.step();
}

TEST(Policies, ThreeAtOnceAreTheUnionOfThreeRuns) {
  const auto together = keys_of(heap_under({0, 1, 2}));
  std::set<Key> apart;
  for (std::uint32_t one = 0; one < 3; ++one) {
    const auto keys = keys_of(heap_under({one}));
    EXPECT_GT(keys.size(), 20U) << "each policy has to have something to do";
    apart.insert(keys.begin(), keys.end());
  }
  EXPECT_EQ(together, apart);
}

// Every algorithm that can be asked for leaves a pair of boxes with its contacts.
TEST(Policies, TakeEveryAlgorithm) {
  for (abut_algorithm algorithm = ABUT_ALGORITHM_AUTO; algorithm <= ABUT_ALGORITHM_GJK_EPA; ++algorithm) {
    Sinking scene;
    abut_policy policy = default_policy();
    policy.algorithm = algorithm;
    scene.set(policy);
    const auto contacts = scene.universe.step();
    ASSERT_FALSE(contacts.empty()) << algorithm;
    EXPECT_NEAR(contacts.at(0).distance, -0.014, 1e-3) << algorithm;
  }
}

}  // namespace
