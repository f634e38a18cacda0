// SPDX-License-Identifier: Apache-2.0
// What parked geometries cost: a step of 100 moving boxes, alone and beside 9,900 that are parked, and parking itself.
#include <abut/abut.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "abut_c_universe.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::size_t active_count = 100, pool_count = 9900;

// Boxes in a row, each overlapping its neighbours, and a pool of others that are parked at once.
class Pool {
 public:
  explicit Pool(std::size_t parked, abut_parking parking) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.broadphase = ABUT_BROADPHASE_TREE;
    universe_ = abut_c_universe(options);
    const AbutCShape box = abut_c_shape({Kind::box, {0.5, 0.5, 0.5}, {}, {}});
    for (std::size_t i = 0; i < active_count + parked; ++i) {
      const auto [part, geometry] = add_abut_c_body(universe_, box, pose_of(i, 0), ABUT_MOTION_DYNAMIC);
      if (i < active_count) {
        parts_.push_back(part);
      } else {
        pool_.push_back(geometry);
      }
    }
    step();
    expect_ok(abut_geometries_park(universe_.get(), pool_.data(), pool_.size(), parking));
    step();
  }

  void step() {
    ++frame_;
    std::vector<abut_pose>& poses = poses_;
    poses.clear();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      poses.push_back(pose_of(i, frame_));
    }
    expect_ok(abut_parts_set_poses(universe_.get(), parts_.data(), poses.data(), parts_.size()));
    expect_ok(abut_universe_step(universe_.get(), 0));
  }

  // Brings one of the pool back, puts it into the world, and parks it again.
  void borrow(abut_parking parking) {
    const abut_geometry_id geometry = pool_[next_++ % pool_.size()];
    expect_ok(abut_geometry_park(universe_.get(), geometry, ABUT_PARKING_NONE));
    expect_ok(abut_universe_refresh(universe_.get()));
    expect_ok(abut_geometry_park(universe_.get(), geometry, parking));
  }

 private:
  static abut_pose pose_of(std::size_t i, std::size_t frame) {
    const double sway = 0.002 * static_cast<double>((frame + i) % 7);
    return {{0.9 * static_cast<double>(i % 100) + sway, 3 * static_cast<double>(i / 100), 0}, {1, 0, 0, 0}};
  }

  AbutCUniverse universe_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> pool_;
  std::vector<abut_pose> poses_;
  std::size_t frame_ = 0, next_ = 0;
};

// The pool must outlive the run.
template <class Step>
void add(const std::string& name, Step&& step) {
  benchmark::RegisterBenchmark(name.c_str(), [step](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      step();
    }
  });
}

int run() {
  Pool alone(0, ABUT_PARKING_NONE), beside_long(pool_count, ABUT_PARKING_LONG_TERM),
      beside_short(pool_count, ABUT_PARKING_SHORT_TERM);
  Pool long_pool(pool_count, ABUT_PARKING_LONG_TERM), short_pool(pool_count, ABUT_PARKING_SHORT_TERM);
  add("step/alone", [&] { alone.step(); });
  add("step/long-term", [&] { beside_long.step(); });
  add("step/short-term", [&] { beside_short.step(); });
  add("borrow/short-term", [&] { short_pool.borrow(ABUT_PARKING_SHORT_TERM); });
  add("borrow/long-term", [&] { long_pool.borrow(ABUT_PARKING_LONG_TERM); });
  return run_and_compare({"short-term", {"long-term"}, {"alone"}, 1, "ns", 1e-9});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
