// SPDX-License-Identifier: Apache-2.0
// Signed distances of all pairs of bounded convex shapes, curved ones included, by their certificates.
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "certificate_checks.hpp"
#include "certificate_shortfalls.hpp"
#include "solid_scenes.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return certificate_shortfalls; }

namespace {

using property::SolidSubject;

constexpr std::array<const char*, 10> kinds{"point",   "segment",  "triangle", "sphere",    "box",
                                            "capsule", "cylinder", "cone",     "ellipsoid", "hull"};

struct KindPair {
  std::size_t a = 0;
  std::size_t b = 0;
};

void PrintTo(const KindPair& pair, std::ostream* out) { *out << kinds.at(pair.a) << "/" << kinds.at(pair.b); }

std::string name_of(const testing::TestParamInfo<KindPair>& pair) {
  return std::string(kinds.at(pair.param.a)) + "_" + kinds.at(pair.param.b);
}

std::vector<KindPair> kind_pairs() {
  std::vector<KindPair> list;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) list.push_back({a, b});
  }
  return list;
}

class SolidPairs : public testing::TestWithParam<KindPair> {};

// Each pair of subjects draws from its own seed, so that one failing pair can be repeated alone.
TEST_P(SolidPairs, ProveTheirDistance) {
  const auto [kind_a, kind_b] = GetParam();
  const std::vector<SolidSubject> list_a = property::solid_subjects(kinds.at(kind_a));
  const std::vector<SolidSubject> list_b = property::solid_subjects(kinds.at(kind_b));
  if (list_a.empty() || list_b.empty()) GTEST_SKIP() << "a kind that this build does not know";
  for (std::size_t i = 0; i < list_a.size(); ++i) {
    for (std::size_t j = kind_a == kind_b ? i : 0; j < list_b.size(); ++j) {
      const SolidSubject& a = list_a[i];
      const SolidSubject& b = kind_a == kind_b ? list_a[j] : list_b[j];
      property::Random random(1000 * (10 * kind_a + i) + 10 * kind_b + j + 1);
      for (const auto& placement : property::solid_placements(a, b, random)) check_certificate(a, b, placement);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Property, SolidPairs, testing::ValuesIn(kind_pairs()), name_of);

}  // namespace
