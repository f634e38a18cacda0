// SPDX-License-Identifier: Apache-2.0
// A step of balls that all move and meet each other: as particles of one geometry, and as a body each.
#include <abut/abut.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "abut_c_universe.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

constexpr double radius = 0.5;
constexpr std::size_t most_bodies = 100'000;

// A fifth of a cube is filled. Every ball moves by up to a tenth of its radius a step.
class Places {
 public:
  explicit Places(std::size_t count) : random_(count) {
    const double side = 1.4 * std::cbrt(static_cast<double>(count));
    for (std::size_t i = 0; i < 3 * count; ++i) {
      xyz_.push_back(side * share());
    }
  }
  void move() {
    for (double& coordinate : xyz_) {
      coordinate += 0.1 * radius * (2 * share() - 1);
    }
  }
  [[nodiscard]] const std::vector<double>& xyz() const { return xyz_; }
  [[nodiscard]] std::size_t count() const { return xyz_.size() / 3; }

 private:
  [[nodiscard]] double share() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  std::mt19937_64 random_;
  std::vector<double> xyz_;
};

[[nodiscard]] AbutCUniverse quiet_universe() {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.events = 0;
  return abut_c_universe(options);
}

class AsParticles {
 public:
  explicit AsParticles(std::size_t count) : places_(count), universe_(quiet_universe()) {
    abut_shape* made = nullptr;
    expect_ok(abut_particles_create(places_.xyz().data(), count, radius, &made));
    const AbutCShape shape(made);
    abut_part_id part{};
    expect_ok(abut_part_create(universe_.get(), nullptr, &part));
    abut_geometry_options options;
    abut_geometry_options_init(&options, sizeof options);
    options.flags = ABUT_GEOMETRY_SELF_PAIRS;
    expect_ok(abut_geometry_create(universe_.get(), part, shape.get(), &options, &geometry_));
  }
  void move() { places_.move(); }
  void step() {
    expect_ok(
        abut_geometry_set_particles(universe_.get(), geometry_, 0, places_.xyz().data(), nullptr, places_.count()));
    expect_ok(abut_universe_step(universe_.get(), 0));
  }

 private:
  Places places_;
  AbutCUniverse universe_;
  abut_geometry_id geometry_{};
};

class AsBodies {
 public:
  explicit AsBodies(std::size_t count) : places_(count), universe_(quiet_universe()), poses_(count) {
    const AbutCShape ball = abut_c_shape({Kind::sphere, {radius}, {}, {}});
    fill_poses();
    for (const abut_pose& pose : poses_) {
      parts_.push_back(add_abut_c_body(universe_, ball, pose, ABUT_MOTION_DYNAMIC).part);
    }
  }
  void move() {
    places_.move();
    fill_poses();
  }
  void step() {
    expect_ok(abut_parts_set_poses(universe_.get(), parts_.data(), poses_.data(), parts_.size()));
    expect_ok(abut_universe_step(universe_.get(), 0));
  }

 private:
  void fill_poses() {
    const std::vector<double>& xyz = places_.xyz();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      poses_[i] = {{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}, {1, 0, 0, 0}};
    }
  }

  Places places_;
  AbutCUniverse universe_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_pose> poses_;
};

// The first step has no contacts from before, so it comes before the timing, as moving does.
template <class Balls>
void add(const std::string& name, std::size_t count) {
  benchmark::RegisterBenchmark(name.c_str(), [count](benchmark::State& state) {
    Balls balls(count);
    balls.step();
    for ([[maybe_unused]] auto _ : state) {
      state.PauseTiming();
      balls.move();
      state.ResumeTiming();
      balls.step();
    }
  });
}

int run() {
  for (const std::size_t count : {std::size_t{10'000}, most_bodies, std::size_t{1'000'000}}) {
    const std::string cell = std::to_string(count);
    add<AsParticles>(cell + "/particles", count);
    if (count <= most_bodies) {
      add<AsBodies>(cell + "/bodies", count);
    }
  }
  return run_and_compare({"particles", {"bodies"}, {}, 1, "ms", 1e-3});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
