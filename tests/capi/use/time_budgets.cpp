// SPDX-License-Identifier: Apache-2.0
// Time budgets of queries and policies: the bits are those of the route that is taken. No test looks at a clock.
#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "archive_support.hpp"
#include "bad_values.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double coarse = 1e-2, coarse_seconds = 2e-7, fine_seconds = 1e-6;

// A coarse route and the default for two kinds, in a table of its own.
class TimeBudgets : public testing::Test {
 protected:
  TimeBudgets() {
    std::string text = "# abut routes 1\n";
    for (const char* question : {"distance", "contacts"}) {
      text += std::string(question) + " cylinder ellipsoid auto 0 1e-06 1e-09\n";
      text += std::string(question) + " ellipsoid cylinder auto 0.01 2e-07 0.01\n";
    }
    EXPECT_TRUE(succeeded(abut_routes_load(text.c_str())));
  }
  ~TimeBudgets() override { static_cast<void>(abut_routes_load(nullptr)); }

  Shape cylinder = make_of_kind("cylinder", {1, 0.75}), ellipsoid = make_of_kind("ellipsoid", {1.5, 0.6, 0.9});
};

abut_query_options options_of(double time_budget, double error_bound) {
  abut_query_options options = filled_by(abut_query_options_init);
  options.time_budget = time_budget;
  options.error_bound = error_bound;
  return options;
}

const abut_pose turned{{0.25, 0.5, 2.5}, {0.8, 0.36, 0.48, 0}}, deep{{0.25, 0.5, 1.25}, {0.8, 0.36, 0.48, 0}};

abut_distance distance_of(const Shape& a, const Shape& b, const abut_query_options& options) {
  abut_distance found{};
  EXPECT_TRUE(succeeded(abut_pair_distance(a, &identity, b, &turned, &options, &found)));
  return found;
}

std::vector<abut_contact> contacts_of(const Shape& a, const Shape& b, const abut_query_options& options) {
  std::vector<abut_contact> found(8);
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_pair_contacts(a, &identity, b, &deep, &options, found.data(), found.size(), &count)));
  found.resize(count);
  return found;
}

// Bit by bit; ids of geometries are of their universe.
bool are_same(const std::vector<abut_contact>& some, const std::vector<abut_contact>& others) {
  const auto is_same = [](const abut_contact& one, const abut_contact& other) {
    return one.id == other.id && one.distance == other.distance &&
           std::memcmp(&one.point_a, &other.point_a, sizeof one.point_a) == 0 &&
           std::memcmp(&one.normal, &other.normal, sizeof one.normal) == 0;
  };
  return !some.empty() && std::equal(some.begin(), some.end(), others.begin(), others.end(), is_same);
}

std::vector<abut_route> routes_of(abut_query query, const abut_query_options* options, const char* a, const char* b) {
  std::vector<abut_route> routes(4);
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_pair_routes(abut_shape_kind_by_name(a), abut_shape_kind_by_name(b), query, options,
                                         routes.data(), routes.size(), &count)));
  routes.resize(count);
  return routes;
}

struct Expected {
  double time_budget, error_bound;  // of the options
  double taken;                     // the error bound of options that give the same bits
};
constexpr std::array<Expected, 6> expectations{
    {{1, 0, 0}, {fine_seconds, 0, 0}, {5e-7, 0, coarse}, {1e-9, 0, coarse}, {1, 1e-1, 1e-1}, {1e-9, 1e-4, 1e-4}}};

TEST_F(TimeBudgets, ChooseTheErrorBoundOfDistances) {
  const double width = distance_of(cylinder, ellipsoid, options_of(0, coarse)).upper -
                       distance_of(cylinder, ellipsoid, options_of(0, coarse)).lower;
  ASSERT_GT(width, 1e-6) << "a pair whose coarse answer is another one";
  for (const Expected& its : expectations) {
    for (const auto& [a, b] : {std::pair{&cylinder, &ellipsoid}, std::pair{&ellipsoid, &cylinder}}) {
      const abut_distance found = distance_of(*a, *b, options_of(its.time_budget, its.error_bound));
      const abut_distance same = distance_of(*a, *b, options_of(0, its.taken));
      EXPECT_EQ(found.lower, same.lower) << its.time_budget << ", " << its.error_bound;
      EXPECT_EQ(found.upper, same.upper) << its.time_budget << ", " << its.error_bound;
    }
  }
}

TEST_F(TimeBudgets, ChooseTheErrorBoundOfContactsAndOfBatches) {
  ASSERT_FALSE(are_same(contacts_of(cylinder, ellipsoid, options_of(0, coarse)),
                        contacts_of(cylinder, ellipsoid, options_of(0, 0))))
      << "a pair whose coarse answer is another one";
  for (const Expected& its : expectations) {
    const abut_query_options asked = options_of(its.time_budget, its.error_bound), same = options_of(0, its.taken);
    EXPECT_TRUE(are_same(contacts_of(cylinder, ellipsoid, asked), contacts_of(cylinder, ellipsoid, same)))
        << its.time_budget;
    abut_distance in_batch{};
    EXPECT_TRUE(succeeded(abut_pairs_distance(cylinder, &identity, ellipsoid, &turned, 1, &asked, &in_batch)));
    EXPECT_EQ(in_batch.upper, distance_of(cylinder, ellipsoid, same).upper);
    std::vector<abut_contact> contacts(8);
    std::array<std::uint64_t, 2> offsets{};
    std::size_t count = 0;
    EXPECT_TRUE(succeeded(abut_pairs_contacts(cylinder, &identity, ellipsoid, &deep, 1, &asked, offsets.data(),
                                              contacts.data(), contacts.size(), &count)));
    contacts.resize(count);
    EXPECT_TRUE(are_same(contacts, contacts_of(cylinder, ellipsoid, same)));
  }
}

TEST_F(TimeBudgets, LeaveNamedAlgorithmsAndUnmeasuredPairsAlone) {
  abut_query_options named = options_of(1e-9, 0);
  named.algorithm = ABUT_ALGORITHM_GJK_EPA;
  abut_query_options without = named;
  without.time_budget = 0;
  EXPECT_EQ(distance_of(cylinder, ellipsoid, named).upper, distance_of(cylinder, ellipsoid, without).upper);
  EXPECT_EQ(distance_of(cylinder, cylinder, options_of(1e-9, 0)).upper,
            distance_of(cylinder, cylinder, options_of(0, 0)).upper);
}

TEST_F(TimeBudgets, AreExplainedByFlags) {
  const abut_query_options both = options_of(5e-7, 1e-4), budget = options_of(5e-7, 0);
  const auto flags = [](const std::vector<abut_route>& routes) {
    return std::pair{routes.at(0).flags, routes.at(1).flags};
  };
  for (const abut_query query : {ABUT_QUERY_DISTANCE, ABUT_QUERY_CONTACTS}) {
    const std::vector<abut_route> routes = routes_of(query, &budget, "ellipsoid", "cylinder");
    ASSERT_EQ(routes.size(), 2U);
    EXPECT_EQ(routes[0].seconds, fine_seconds);
    EXPECT_EQ(routes[1].seconds, coarse_seconds);
    EXPECT_EQ(routes[1].error_bound, coarse);
    EXPECT_EQ(routes[1].worst_error, coarse);
    EXPECT_EQ(flags(routes),
              (std::pair{ABUT_ROUTE_IN_BOUND | 0U, ABUT_ROUTE_CHOSEN | ABUT_ROUTE_IN_TIME | ABUT_ROUTE_IN_BOUND | 0U}));
    EXPECT_EQ(flags(routes_of(query, &both, "cylinder", "ellipsoid")),
              (std::pair{ABUT_ROUTE_CHOSEN | ABUT_ROUTE_IN_BOUND | 0U, ABUT_ROUTE_IN_TIME | 0U}));
    EXPECT_EQ(
        flags(routes_of(query, nullptr, "cylinder", "ellipsoid")),
        (std::pair{ABUT_ROUTE_IN_TIME | ABUT_ROUTE_IN_BOUND | 0U, ABUT_ROUTE_IN_TIME | ABUT_ROUTE_IN_BOUND | 0U}));
    EXPECT_TRUE(routes_of(query, &budget, "box", "cylinder").empty());
  }
}

TEST_F(TimeBudgets, OfABadTableChangeNothing) {
  EXPECT_TRUE(refused(abut_routes_load("# abut routes 1\ndistance box box auto 0 1e-07 fast\n"), ABUT_INVALID_ARGUMENT,
                      {"text", "line 2", "fast"}));
  EXPECT_EQ(routes_of(ABUT_QUERY_DISTANCE, nullptr, "ellipsoid", "cylinder").size(), 2U);
  ASSERT_TRUE(succeeded(abut_routes_load(nullptr)));
  EXPECT_FALSE(routes_of(ABUT_QUERY_DISTANCE, nullptr, "box", "box").empty()) << "the table that abut comes with";
}

// An ellipsoid that lies deep in a cylinder; the contacts of the first step.
std::vector<abut_contact> contacts_in_universe(const Shape& cylinder, const Shape& ellipsoid, const abut_policy& policy,
                                               abut_geometry_flags flags) {
  Universe universe;
  EXPECT_TRUE(succeeded(abut_policy_set(universe, 0, 0, &policy)));
  abut_geometry_options options = default_geometry_options();
  universe.add_geometry(universe.add_part(identity, ABUT_MOTION_STATIC), cylinder, options);
  options.flags = flags;
  universe.add_geometry(universe.add_part(deep), ellipsoid, options);
  return universe.step();
}

TEST_F(TimeBudgets, OfPoliciesChooseForContacts) {
  abut_policy policy = default_policy();
  const auto contacts = [&](double time_budget, double error_bound, abut_geometry_flags flags) {
    policy.time_budget = time_budget;
    policy.error_bound = error_bound;
    return contacts_in_universe(cylinder, ellipsoid, policy, flags);
  };
  ASSERT_FALSE(are_same(contacts(0, coarse, 0), contacts(0, 0, 0)));
  for (const abut_geometry_flags flags : {abut_geometry_flags{0}, abut_geometry_flags{ABUT_GEOMETRY_FAST}}) {
    for (const Expected& its : expectations) {
      EXPECT_TRUE(are_same(contacts(its.time_budget, its.error_bound, flags), contacts(0, its.taken, flags)))
          << its.time_budget << ", " << its.error_bound;
    }
  }
}

TEST_F(TimeBudgets, OfPoliciesAreSaved) {
  const Universe universe;
  abut_policy policy = default_policy();
  policy.time_budget = 2.5e-7;
  ASSERT_TRUE(succeeded(abut_policy_set(universe, 3, 5, &policy)));
  const std::vector<std::uint8_t> bytes = saved(universe);
  abut_universe* loaded = nullptr;
  ASSERT_TRUE(succeeded(abut_universe_load(bytes.data(), bytes.size(), &loaded)));
  for (const abut_universe* its :
       {static_cast<const abut_universe*>(universe), static_cast<const abut_universe*>(loaded)}) {
    abut_policy found = default_policy();
    EXPECT_TRUE(succeeded(abut_policy_get(its, 5, 3, &found)));
    EXPECT_EQ(found.time_budget, policy.time_budget);
  }
  abut_universe_destroy(loaded);
}

TEST_F(TimeBudgets, AreNotNegative) {
  abut_distance found{};
  const abut_query_options options = options_of(-1, 0);
  EXPECT_TRUE(refused(abut_pair_distance(cylinder, &identity, ellipsoid, &turned, &options, &found), ABUT_OUT_OF_RANGE,
                      {"options.time_budget", "-1"}));
  const Universe universe;
  abut_policy policy = default_policy();
  policy.time_budget = -2;
  EXPECT_TRUE(refused(abut_policy_set(universe, 0, 0, &policy), ABUT_OUT_OF_RANGE, {"policy.time_budget", "-2"}));
}

}  // namespace
