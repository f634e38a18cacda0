// SPDX-License-Identifier: Apache-2.0
// The signed distance of pairs on which other libraries failed, each by itself: the same pair again and again.
#include "known_cases.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "agreement.hpp"
#include "pairs.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::array makers{Maker{"abut", make_abut}, Maker{"abut-c", make_abut_c}, Maker{"bullet", make_bullet},
                            Maker{"fcl", make_fcl}};

std::string full_name(const KnownCase& known, const Maker& maker) {
  return "known/" + known.id + "/" + std::string(maker.name);
}

// Of pairs that are apart too: many nearly touch, where FCL's plain distance is -1.
constexpr Query signed_distance = Query::depth;

// Null where the library has no such shape or refuses it.
std::unique_ptr<Contender> make(const Maker& maker, const Cell& cell) {
  try {
    return maker.make(signed_distance, cell);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", std::string(maker.name).c_str(), error.what());
    return nullptr;
  }
}

class Suite {
 public:
  void add(KnownCase& known) {
    if (std::ranges::none_of(makers, [&known](const Maker& maker) { return is_selected(full_name(known, maker)); })) {
      return;
    }
    for (Solid* solid : {&known.a, &known.b}) {
      if (is_hull(solid->kind)) {
        find_surface(*solid);
      }
    }
    const Cell cell{std::span(&known.a, 1), std::span(&known.b, 1), std::span(&known.placed, 1)};
    const std::array expected{Answer{known.reference, 1}};
    for (const Maker& maker : makers) {
      if (!is_selected(full_name(known, maker))) {
        continue;
      }
      std::unique_ptr<Contender> made = make(maker, cell);
      if (!made) {
        continue;
      }
      Contender& contender = *contenders_.emplace_back(std::move(made));
      std::array<Answer, 1> answers;
      contender.answer(answers);
      const double size = std::max(bounding_radius(known.a), bounding_radius(known.b));
      if (agreements_.compare(signed_distance, maker.name, known.id, size, expected, answers) > 0) {
        unlike_.insert(full_name(known, maker));
      }
      benchmark::RegisterBenchmark(full_name(known, maker).c_str(), [&contender](benchmark::State& state) {
        std::array<Answer, 1> timed;
        for ([[maybe_unused]] auto _ : state) {
          contender.answer(timed);
          benchmark::DoNotOptimize(timed.data());
          benchmark::ClobberMemory();
        }
      });
    }
  }

  void print() const {
    std::printf("Answers beside the reference, differences by the size of the larger solid\n");
    agreements_.print();
  }
  [[nodiscard]] const std::set<std::string>& unlike() const { return unlike_; }

 private:
  std::vector<std::unique_ptr<Contender>> contenders_;
  Agreements agreements_;
  std::set<std::string> unlike_;
};

int run() {
  std::vector<KnownCase> cases = read_known_cases(ABUT_TEST_DATA "/known_failures.jsonl");
  Suite suite;
  for (KnownCase& known : cases) {
    suite.add(known);
  }
  suite.print();
  Comparison comparison{"abut", {"bullet", "fcl"}, {"abut-c"}, 1, "ns", 1e-9, suite.unlike()};
  comparison.has_summary = true;
  return run_and_compare(comparison);
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
