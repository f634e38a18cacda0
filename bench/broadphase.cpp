// SPDX-License-Identifier: Apache-2.0
// Boxes that wander, all of them or a tenth: the broad phases of abut beside those of Bullet and FCL on
// one thread, and that of abut on two.
#include "broadphase.hpp"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "broadphase_motion.hpp"
#include "ratios.hpp"

import abut.broadphase;
import abut.core.workers;
import abut.math;

namespace bench {
namespace {

constexpr std::uint64_t seed = 1;
// Before pairs are compared or steps are timed.
constexpr std::size_t steps_at_start = 25;
// Boxes that were put in together leave their larger boxes together for a while. So one step takes ten times as long
// as another: many boxes are timed for several such waves, however long that takes. Few are timed for hundreds of
// steps anyway.
constexpr std::size_t many = 100'000, steps_of_many = 75;

class AbutPairs final : public BoxPairs {
 public:
  AbutPairs(const Boxes& boxes, abut::BroadphaseKind kind, std::uint32_t threads)
      : workers_(threads), boxes_(boxes.all.size()) {
    if (kind == abut::BroadphaseKind::automatic) {
      kind = abut::choose_broadphase({boxes.all.size(), boxes.moving}, kind).kind;
    }
    switch (kind) {
      case abut::BroadphaseKind::brute: broad_phase_.emplace<abut::Brute>(); break;
      case abut::BroadphaseKind::sweep_and_prune: broad_phase_.emplace<abut::SweepAndPrune>(); break;
      case abut::BroadphaseKind::hash_grid: broad_phase_.emplace<abut::Grid>(); break;
      case abut::BroadphaseKind::automatic:
      case abut::BroadphaseKind::tree: broad_phase_.emplace<abut::Tree>(); break;
    }
    moving_.resize(boxes.moving);
    std::iota(moving_.begin(), moving_.end(), 0u);
    std::visit(
        [&](auto& broad_phase) {
          for (std::uint32_t i = 0; i < boxes.all.size(); ++i) {
            const auto mobility = i < boxes.moving ? abut::Mobility::moving : abut::Mobility::still;
            broad_phase.insert(i, {boxes.all[i].low, boxes.all[i].high}, mobility, i);
          }
          broad_phase.find_pairs(workers_, pairs_);
        },
        broad_phase_);
  }

  void step(std::span<const Box> moving) override {
    for (std::size_t i = 0; i < moving.size(); ++i) {
      boxes_[i] = {moving[i].low, moving[i].high};
    }
    std::visit(
        [&](auto& broad_phase) {
          broad_phase.update_all(workers_, moving_, boxes_);
          broad_phase.find_pairs(workers_, pairs_);
        },
        broad_phase_);
  }
  [[nodiscard]] std::size_t pairs(std::span<const Box>) const override { return pairs_.size(); }

 private:
  abut::Workers workers_;
  abut::AnyBroadPhase broad_phase_;
  std::vector<std::uint32_t> moving_;
  std::vector<abut::CompactAabb> boxes_;
  std::vector<abut::ProxyPair> pairs_;
};

using Make = std::function<std::unique_ptr<BoxPairs>(const Wandering&)>;

Make abut_kind(abut::BroadphaseKind kind, std::uint32_t threads) {
  return [=](const Wandering& wandering) { return std::make_unique<AbutPairs>(wandering.boxes(), kind, threads); };
}

// The peers of each cell, the slowest ones only where they take less than minutes.
std::vector<std::pair<std::string, Make>> contenders(std::size_t count) {
  using enum abut::BroadphaseKind;
  std::vector<std::pair<std::string, Make>> all{{"abut", abut_kind(automatic, 1)},
                                                {"tree", abut_kind(tree, 1)},
                                                {"grid", abut_kind(hash_grid, 1)},
                                                {"abut-2", abut_kind(automatic, 2)}};
  constexpr std::size_t most_for_peers = 100'000, most_for_axes = 10'000, most_for_brute = 1000;
  if (count <= most_for_peers) {
    all.emplace_back("dbvt", [](const Wandering& wandering) {
      return make_bullet_broadphase(wandering.boxes(), BulletBroadphase::dbvt, 0);
    });
    all.emplace_back("fcl", [](const Wandering& wandering) { return make_fcl_broadphase(wandering.boxes()); });
  }
  if (count <= most_for_axes) {
    all.emplace_back("sap", abut_kind(sweep_and_prune, 1));
    all.emplace_back("axes", [](const Wandering& wandering) {
      return make_bullet_broadphase(wandering.boxes(), BulletBroadphase::axis_sweep, wandering.half_extent() + 2);
    });
  }
  if (count <= most_for_brute) {
    all.emplace_back("brute", abut_kind(brute, 1));
  }
  return all;
}

// Boxes in a broad phase, well away from where they were put in.
struct Started {
  Started(const Make& make, std::size_t count, double moving_share)
      : wandering(count, moving_share, seed), broad_phase(make(wandering)) {
    for (std::size_t step = 0; step < steps_at_start; ++step) {
      wandering.advance();
      broad_phase->step(wandering.moving());
    }
  }

  Wandering wandering;
  std::unique_ptr<BoxPairs> broad_phase;
};

// False when one contender finds other pairs than the first.
bool agree(const std::string& cell, std::size_t count, double moving_share) {
  std::size_t expected = 0;
  bool is_first = true, is_agreed = true;
  for (const auto& [name, make] : contenders(count)) {
    const Started started(make, count, moving_share);
    const std::size_t pairs = started.broad_phase->pairs(started.wandering.boxes().all);
    expected = is_first ? pairs : expected;
    is_first = false;
    if (pairs != expected) {
      std::fprintf(stderr, "%s: %s finds %zu pairs instead of %zu\n", cell.c_str(), name.c_str(), pairs, expected);
      is_agreed = false;
    }
  }
  std::printf("%-16s %10zu pairs\n", cell.c_str(), expected);
  return is_agreed;
}

void add(const std::string& cell, std::size_t count, double moving_share) {
  for (const auto& [name, make] : contenders(count)) {
    const std::string full = cell + "/" + name;
    auto* const registered = benchmark::RegisterBenchmark(full.c_str(), [=](benchmark::State& state) {
      Started started(make, count, moving_share);
      for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        started.wandering.advance();
        state.ResumeTiming();
        started.broad_phase->step(started.wandering.moving());
      }
    });
    registered->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
    if (count >= many) {
      registered->Iterations(steps_of_many);
    }
  }
}

int run() {
  bool is_agreed = true;
  const auto compare = [&](const std::string& cell, std::size_t count, double moving_share) {
    if (is_selected(cell)) {
      is_agreed = agree(cell, count, moving_share) && is_agreed;
    }
    add(cell, count, moving_share);
  };
  for (const std::size_t count : {1000u, 10'000u, 100'000u}) {
    compare("moving-" + std::to_string(count), count, 1);
    compare("still90-" + std::to_string(count), count, 0.1);
  }
  compare("moving-1000000", 1'000'000, 1);
  if (!is_agreed) {
    return 1;
  }
  return run_and_compare({"abut", {"dbvt"}, {"tree", "grid", "sap", "brute", "abut-2", "fcl", "axes"}, 1, "us", 1e-6});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
