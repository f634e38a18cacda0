// SPDX-License-Identifier: Apache-2.0
// Worst errors of the committed table of routes, over pairs that no route was measured with. The oracle brackets the
// true distance: no pair of points is closer than the separation along a normal, no overlap ends before the way along
// some direction. No test looks at a clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/support.hpp"
#include "oracle/sweep.hpp"
#include "record.hpp"
#include "solid_scenes.hpp"
#include "tolerance.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Placement;
using property::Random;
using property::SolidSubject;

constexpr std::array<const char*, 7> kinds{"sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "hull"};
constexpr int placements_of_pair = 32;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

SolidSubject random_solid(const std::string& kind, Random& random) {
  std::vector<double> numbers;
  std::size_t count = kind == "sphere" ? 1 : kind == "box" || kind == "ellipsoid" ? 3 : 2;
  if (kind == "hull") {
    for (int i = 0; i < 32; ++i) {
      const abut_vec3 p = property::random_direction(random);
      numbers.insert(numbers.end(), {p.x, 0.75 * p.y, 1.25 * p.z});
    }
    count = 0;
  }
  while (count-- > 0) numbers.push_back(uniform(random, 0.4, 1.2));
  return property::make_solid(kind, kind, numbers);
}

// The largest distance of two points is at most twice that from the origin, and at least the size of every bound.
double size_of(const SolidSubject& a, const SolidSubject& b) { return 2 * (a.subject.size + b.subject.size); }

struct Judged {
  const SolidSubject& a;
  const SolidSubject& b;
  Placement placement;
  double size;
  double truth;  // to within `slack`
  double slack;
};

double overlap_along(const Judged& its, const abut_vec3& normal) {
  return static_cast<double>(oracle::overlap_along(its.a.solid, property::pose_of(its.placement.a), its.b.solid,
                                                   property::pose_of(its.placement.b),
                                                   oracle::unit(property::vec_of(normal))));
}

abut_distance distance_of(const Judged& its, const abut_query_options& options) {
  abut_distance found{};
  EXPECT_EQ(abut_pair_distance(its.a.subject.shape.get(), &its.placement.a, its.b.subject.shape.get(), &its.placement.b,
                               &options, &found),
            ABUT_OK);
  return found;
}

abut_query_options options_of(abut_algorithm algorithm, double error_bound) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = algorithm;
  options.error_bound = error_bound;
  return options;
}

// Facing each other along a random direction, which meets corners, rims and caps.
Placement facing(const SolidSubject& a, const SolidSubject& b, bool is_apart, double size, Random& random) {
  const double gap = size * (is_apart ? std::pow(10, uniform(random, -3, -0.3)) : -uniform(random, 0.01, 0.1));
  const abut_pose pose_a{{0.5, -0.25, 1}, property::random_orientation(random)};
  const oracle::Vec n = oracle::unit(property::vec_of(property::random_direction(random)));
  return property::facing("", a, pose_a, b, property::random_orientation(random), n, gap, 0);
}

// With the centre anywhere, so that faces and sides are met too: the first of such placements that is wanted.
Placement anywhere(const SolidSubject& a, const SolidSubject& b, bool is_apart, double size, Random& random) {
  for (;;) {
    const abut_pose pose_a{{0.5, -0.25, 1}, property::random_orientation(random)};
    const abut_vec3 way = property::random_direction(random);
    const double far = uniform(random, 0, size);
    const abut_pose pose_b{{0.5 + far * way.x, -0.25 + far * way.y, 1 + far * way.z},
                           property::random_orientation(random)};
    const double gap =
        distance_of({a, b, {"", pose_a, pose_b}, size, 0, 0}, options_of(ABUT_ALGORITHM_AUTO, 0)).distance;
    if (is_apart ? gap > 1e-3 * size : gap < -0.01 * size && gap > -0.1 * size) {
      return {"", pose_a, pose_b};
    }
  }
}

Judged judged(const SolidSubject& a, const SolidSubject& b, bool is_apart, bool is_facing, Random& random) {
  const double size = size_of(a, b);
  Judged its{a, b, (is_facing ? facing : anywhere)(a, b, is_apart, size, random), size, 0, 0};
  const abut_distance best = distance_of(its, options_of(ABUT_ALGORITHM_AUTO, 1e-13));
  const double along = -overlap_along(its, best.normal);
  if (best.distance > 0) {
    const double between =
        static_cast<double>(oracle::length(property::vec_of(best.point_b) - property::vec_of(best.point_a)));
    its.truth = (along + between) / 2;
    its.slack = std::abs(between - along);
  } else {
    const oracle::LeastOverlap least =
        oracle::least_overlap(a.solid, property::pose_of(its.placement.a), b.solid, property::pose_of(its.placement.b),
                              oracle::unit(property::vec_of(best.normal)));
    its.truth = -static_cast<double>(least.overlap);
  }
  its.slack += 64 * std::numeric_limits<double>::epsilon() * (size + 4);
  EXPECT_LT(its.slack, 1e-9 * size) << "the oracle tells too little";
  return its;
}

std::vector<abut_route> routes_of(abut_query query, const char* a, const char* b) {
  std::vector<abut_route> routes(64);
  std::size_t count = 0;
  EXPECT_EQ(abut_pair_routes(abut_shape_kind_by_name(a), abut_shape_kind_by_name(b), query, nullptr, routes.data(),
                             routes.size(), &count),
            ABUT_OK);
  routes.resize(count);
  return routes;
}

void check_distance(const Judged& its, const abut_route& route) {
  const abut_distance found = distance_of(its, options_of(route.algorithm, route.error_bound));
  const double promise = route.worst_error * its.size + its.slack;
  EXPECT_LE(std::abs(found.distance - its.truth), promise);
  EXPECT_LE(found.upper - found.lower, promise);
}

void check_contacts(const Judged& its, const abut_route& route) {
  const abut_query_options options = options_of(route.algorithm, route.error_bound);
  std::array<abut_contact, 8> found{};
  std::size_t count = 0;
  ASSERT_EQ(abut_pair_contacts(its.a.subject.shape.get(), &its.placement.a, its.b.subject.shape.get(), &its.placement.b,
                               &options, found.data(), found.size(), &count),
            ABUT_OK);
  ASSERT_GT(count, 0U);
  EXPECT_LE(std::abs(found[0].distance - its.truth), route.worst_error * its.size + its.slack);
}

class Promises : public testing::TestWithParam<std::pair<std::size_t, std::size_t>> {};

TEST_P(Promises, AreKeptByOtherPairs) {
  const auto [kind_a, kind_b] = GetParam();
  const char *const name_a = kinds.at(kind_a), *const name_b = kinds.at(kind_b);
  const std::vector<abut_route> of_distance = routes_of(ABUT_QUERY_DISTANCE, name_a, name_b);
  const std::vector<abut_route> of_contacts = routes_of(ABUT_QUERY_CONTACTS, name_a, name_b);
  ASSERT_FALSE(of_distance.empty());
  ASSERT_FALSE(of_contacts.empty());
  Random random(7000 + 10 * kind_a + kind_b);
  for (int i = 0; i < placements_of_pair; ++i) {
    const SolidSubject a = random_solid(name_a, random), b = random_solid(name_b, random);
    const Judged its = judged(a, b, i % 2 == 0, i % 4 < 2, random);
    for (const abut_route& route : of_distance) {
      SCOPED_TRACE(std::string("distance, error bound ") + std::to_string(std::log10(route.error_bound)));
      check_distance(its, route);
    }
    for (const abut_route& route : of_contacts) {
      SCOPED_TRACE(std::string("contacts, error bound ") + std::to_string(std::log10(route.error_bound)));
      if (its.truth < 0) check_contacts(its, route);
    }
  }
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_of_kinds() {
  std::vector<std::pair<std::size_t, std::size_t>> list;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) list.emplace_back(a, b);
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Property, Promises, testing::ValuesIn(pairs_of_kinds()), [](const auto& pair) {
  return std::string(kinds.at(pair.param.first)) + "_" + kinds.at(pair.param.second);
});

}  // namespace
