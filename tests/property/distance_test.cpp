// SPDX-License-Identifier: Apache-2.0
// Signed distances of all pairs of shapes against the oracle, over seeded placements.
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>
#include <string>

#include "catalogue.hpp"
#include "distance_checks.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Case;
using property::Subject;

// Each pair of subjects draws from its own seed, so that one failing pair can be repeated alone.
std::uint64_t seed_of(std::size_t i, std::size_t j) { return 1000 * i + j + 1; }

void check_pair(const Subject& a, const Subject& b, std::uint64_t seed) {
  property::Random random(seed);
  for (const auto& placement : property::placements(a, b, random)) check_distance(make_case(a, b, placement));
}

struct KindPair {
  const char* a;
  const char* b;
};

void PrintTo(const KindPair& pair, std::ostream* out) { *out << pair.a << "/" << pair.b; }

std::string name_of(const testing::TestParamInfo<KindPair>& pair) {
  return std::string(pair.param.a) + "_" + pair.param.b;
}

class ConvexPairs : public testing::TestWithParam<KindPair> {};

TEST_P(ConvexPairs, HaveTheDistanceOfTheOracle) {
  const auto subjects = property::convex_subjects();
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    for (std::size_t j = 0; j < subjects.size(); ++j) {
      const bool is_ours = subjects[i].kind == GetParam().a && subjects[j].kind == GetParam().b;
      const bool is_repeat = subjects[i].kind == subjects[j].kind && j < i;
      if (!is_ours || is_repeat) continue;
      check_pair(subjects[i], subjects[j], seed_of(i, j));
      ++pairs;
    }
  }
  std::printf("%zu pairs, seeds 1000 * i + j + 1\n", pairs);
  EXPECT_GT(pairs, 0u);
}

INSTANTIATE_TEST_SUITE_P(Property, ConvexPairs,
                         testing::Values(KindPair{"sphere", "sphere"}, KindPair{"sphere", "box"},
                                         KindPair{"sphere", "capsule"}, KindPair{"sphere", "hull"},
                                         KindPair{"box", "box"}, KindPair{"box", "capsule"}, KindPair{"box", "hull"},
                                         KindPair{"capsule", "capsule"}, KindPair{"capsule", "hull"},
                                         KindPair{"hull", "hull"}),
                         name_of);

TEST(PlanePairs, HaveTheDistanceOfTheOracle) {
  const auto planes = property::plane_subjects();
  const auto subjects = property::convex_subjects();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < subjects.size(); ++j) check_pair(planes[i], subjects[j], seed_of(i + 500, j));
  }
}

TEST(PlanePairs, MeasureSurfacesByTheirLowestVertex) {
  const auto planes = property::plane_subjects();
  const auto surfaces = property::surface_subjects();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < surfaces.size(); ++j) {
      check_pair(planes[i], surfaces[j], seed_of(i + 600, j));
    }
  }
}

TEST(PlanePairs, AreUnsupportedAmongPlanes) {
  const auto planes = property::plane_subjects();
  const abut_pose identity{{0, 0, 0}, {1, 0, 0, 0}};
  abut_distance out{};
  for (const Subject* a : {&planes.front(), &planes.back()}) {
    for (const Subject* b : {&planes.front(), &planes.back()}) {
      EXPECT_EQ(abut_pair_distance(a->shape.get(), &identity, b->shape.get(), &identity, nullptr, &out),
                ABUT_UNSUPPORTED)
          << a->kind << "/" << b->kind;
      std::size_t count = 0;
      EXPECT_EQ(abut_pair_contacts(a->shape.get(), &identity, b->shape.get(), &identity, nullptr, nullptr, 0, &count),
                ABUT_UNSUPPORTED)
          << a->kind << "/" << b->kind;
    }
  }
}

}  // namespace
