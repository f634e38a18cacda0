// SPDX-License-Identifier: Apache-2.0
// Signed distances of extreme pairs against the oracle, and the table of the worst errors and iterations.
//
// Where both shapes have few features the oracle knows the distance from these; elsewhere, where the cores are apart,
// from support points; and where curved shapes overlap, the certificate of the answer is all there is.
#include "extremes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <span>
#include <sstream>

#include "certificate_checks.hpp"
#include "extreme_shortfalls.hpp"
#include "oracle/nearest.hpp"
#include "record.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return extreme_shortfalls; }

namespace {

using oracle::quad;
using oracle::Quad;
using property::Certified;
using property::Placement;
using property::Random;
using property::SolidSubject;
using property::Visit;

// What an error may be at most is a part of the size of both shapes and the way between them. It is what was
// measured, up to a power of ten, and never more than a query promises: 1e-12, and 1e-9 where a cylinder, a cone or
// an ellipsoid takes part. It is a few units of rounding where nothing else is left: coordinates of few digits,
// depths that faces and edges give, relative poses that are differences of nearby numbers.
struct Extreme {
  const char* name;
  void (*visit)(Random&, const Visit&);
  double straight;  // error of polytopes and rounded shapes
  double curved;    // error where a cylinder, a cone or an ellipsoid takes part
  int rounds = 3;   // how often all is drawn anew
};

constexpr std::uint32_t straight_iterations = 128;  // axes that were tried count as steps
constexpr std::uint32_t curved_iterations = 256;    // two searches of 120 vertices, and what led to them

template <int exponent>
void visit_parallel(Random& random, const Visit& visit) {
  property::visit_parallel_faces(std::pow(10.0, exponent), random, visit);
}

void visit_ratio(Random& random, const Visit& visit) { property::visit_size_ratio(1e9, random, visit); }
void visit_far(Random& random, const Visit& visit) { property::visit_far(1e9, random, visit); }

const std::array extremes{
    Extreme{"size ratio 1e9", visit_ratio, 1e-12, 1e-9, 1},
    Extreme{"needles of aspect 1e6", property::visit_needles, 1e-12, 1e-9},
    Extreme{"plates of aspect 1e6", property::visit_plates, 1e-12, 1e-9},
    Extreme{"1e9 m from the origin", visit_far, 1e-14, 1e-9},
    Extreme{"faces parallel to 1e-3 rad", visit_parallel<-3>, 1e-12, 1e-9},
    Extreme{"faces parallel to 1e-6 rad", visit_parallel<-6>, 1e-12, 1e-9},
    Extreme{"faces parallel to 1e-9 rad", visit_parallel<-9>, 1e-12, 1e-9},
    Extreme{"faces parallel to 1e-12 rad", visit_parallel<-12>, 1e-12, 1e-12},
    Extreme{"faces parallel to 1e-15 rad", visit_parallel<-15>, 1e-12, 1e-12},
    Extreme{"touching at a vertex", property::visit_touching_vertices, 1e-15, 1e-9, 1},
    Extreme{"touching at an edge", property::visit_touching_edges, 1e-15, 1e-9, 1},
    Extreme{"touching at a face", property::visit_touching_faces, 1e-15, 1e-15, 1},
    Extreme{"coincident", property::visit_coincident, 1e-15, 1e-9},
    Extreme{"concentric", property::visit_concentric, 1e-15, 1e-9},
    Extreme{"one inside the other", property::visit_contained, 1e-15, 1e-9},
    Extreme{"zero size", property::visit_zero_size, 1e-15, 1e-9},
    Extreme{"hulls that are flat", property::visit_flat_hulls, 1e-15, 1e-9},
    Extreme{"hulls that are slivers", property::visit_sliver_hulls, 1e-12, 1e-9},
    Extreme{"hulls with repeated vertices", property::visit_repeating_hulls, 1e-12, 1e-9},
    Extreme{"hulls of 10000 points", property::visit_large_hulls, 1e-15, 1e-9, 1},
};

// Three rows of each extreme. The last is of polytopes and rounded shapes too, where the default is another algorithm.
constexpr std::array suffixes{"", " (curved)", " (by support points)"};

// Where the signed distance lies for certain.
struct Truth {
  double low;
  double high;
};

std::optional<Truth> truth_of(const SolidSubject& a, const SolidSubject& b, const Placement& at) {
  const oracle::Pose pose_a = property::pose_of(at.a);
  const oracle::Pose pose_b = property::pose_of(at.b);
  const auto& pieces_a = a.subject.measured.pieces;
  const auto& pieces_b = b.subject.measured.pieces;
  if (!pieces_a.empty() && !pieces_b.empty()) {
    const double exact =
        static_cast<double>(oracle::signed_distance(a.subject.measured, pose_a, b.subject.measured, pose_b).distance);
    return Truth{exact, exact};
  }
  const oracle::Nearest nearest = oracle::nearest(a.solid, pose_a, b.solid, pose_b);
  if (!nearest.is_known) return std::nullopt;
  return Truth{static_cast<double>(nearest.lower), static_cast<double>(nearest.upper)};
}

void check_limits(const Certified& answer, double error, std::uint32_t iterations) {
  const property::Magnitude& m = answer.base.magnitude;
  const double most = error * (m.size_a + m.size_b + m.apart);
  property::expect_at_most(answer.base, "error within the limit of the row", answer.error, most, 0);
  property::expect_at_most(answer.base, "iterations within the limit", answer.result.iterations, iterations, 0);
  property::keep(answer);
}

// What the oracle knows takes the place of what the certificate says of the error: a normal that proves less than the
// distance is reported there.
void check_against(const Truth& truth, Certified& answer) {
  const double rounded = property::rounding(answer.base.magnitude);
  const abut_distance& result = answer.result;
  answer.error = std::max({0.0, result.distance - truth.high, truth.low - result.distance});
  property::expect_at_most(answer.base, "lower <= the oracle's distance", result.lower, truth.high, rounded);
  property::expect_at_most(answer.base, "the oracle's distance <= upper", truth.low, result.upper, rounded);
}

// By support points alone: the same value within its own interval.
void check_support_points(const Extreme& extreme, const Certified& first, const Truth& truth) {
  const property::Case& at = first.base;
  Certified answer{{}, 0, {at.a, at.b, at.placement, {}, at.magnitude, std::string(extreme.name) + suffixes[2]}};
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = ABUT_ALGORITHM_GJK_EPA;
  const std::uint64_t before = property::record().failures();
  const abut_status status = abut_pair_distance(at.a.shape.get(), &at.placement.a, at.b.shape.get(), &at.placement.b,
                                                &options, &answer.result);
  if (status != ABUT_OK) {
    property::broken(answer.base, "status", status, ABUT_OK, 0);
  } else {
    check_against(truth, answer);
    check_limits(answer, extreme.straight, straight_iterations);
  }
  if (property::record().failures() > before) property::record().mark_failed(answer.base.row);
}

void check(const Extreme& extreme, const SolidSubject& a, const SolidSubject& b, const Placement& placement,
           std::optional<double> made) {
  const bool is_curved = a.is_curved || b.is_curved;
  const std::string row = std::string(extreme.name) + suffixes.at(is_curved ? 1 : 0);
  const std::uint64_t before = property::record().failures();
  const auto truth = made ? std::optional(Truth{*made, *made}) : truth_of(a, b, placement);
  auto answer = property::certified(a, b, placement, row);
  if (answer) {
    if (truth) check_against(*truth, *answer);
    check_limits(*answer, is_curved ? extreme.curved : extreme.straight,
                 is_curved ? curved_iterations : straight_iterations);
  }
  if (property::record().failures() > before) property::record().mark_failed(row);
  const bool is_other = answer && !is_curved && answer->result.algorithm != ABUT_ALGORITHM_GJK_EPA;
  if (is_other && truth) check_support_points(extreme, *answer, *truth);
}

std::string table() {
  std::ostringstream text;
  text << "| extreme | cases | worst relative error | worst iterations | widest interval | failures | worst case |\n"
       << "|---|---|---|---|---|---|---|\n";
  text.precision(2);
  for (const Extreme& extreme : extremes) {
    for (const char* suffix : suffixes) {
      const std::string row = std::string(extreme.name) + suffix;
      const property::Worst worst = property::record().worst_of(row);
      if (worst.cases == 0) continue;
      text << "| " << row << " | " << worst.cases << " | " << std::scientific << worst.error << " | "
           << worst.iterations << " | " << worst.gap << " | " << worst.failures << " | " << worst.where << " |\n";
    }
  }
  return text.str();
}

class Extremes : public testing::TestWithParam<std::size_t> {
 public:
  // Prints the table, and writes it where ABUT_EXTREMES_TABLE says.
  static void TearDownTestSuite() {
    if (const char* path = std::getenv("ABUT_EXTREMES_TABLE")) {
      std::ofstream(path) << table();
    }
    std::printf("%s", table().c_str());
  }
};

TEST_P(Extremes, HaveTheDistanceOfTheOracle) {
  const Extreme& extreme = extremes.at(GetParam());
  const std::uint64_t seed = GetParam() + 1;
  std::printf("%s, seed %llu\n", extreme.name, static_cast<unsigned long long>(seed));
  Random random(seed);
  const Visit visit = [&extreme](const SolidSubject& a, const SolidSubject& b, const Placement& placement,
                                 std::optional<double> made) { check(extreme, a, b, placement, made); };
  for (int round = 0; round < extreme.rounds; ++round) extreme.visit(random, visit);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = extremes.at(info.param).name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Property, Extremes, testing::Range(std::size_t{0}, extremes.size()), name_of);

}  // namespace
