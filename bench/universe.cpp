// SPDX-License-Identifier: Apache-2.0
// A step of a universe with 5,000 moving bodies: abut on one thread and on two, beside Bullet, FCL and ODE on one; and
// one of 100,000 bodies, for the two threads; and what it costs that one body in a hundred is fast.
#include "universe.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::size_t solid_count = 64;
constexpr std::size_t frame_count = 24;
constexpr double sway = 0.004;   // of a body of about unit size, from its middle position
constexpr double swing = 0.008;  // radians
constexpr double fast_sway = 5;  // a fast body gets about as far as it is large in a step

// A block of bodies over the ground with this distance from one to the next.
World make_block(std::size_t body_count, double spacing, double jitter, std::uint64_t seed) {
  Random random(seed);
  World world;
  constexpr std::array kinds{Kind::sphere, Kind::box, Kind::capsule, Kind::hull32};
  for (std::size_t i = 0; i < solid_count; ++i) {
    world.solids.push_back(random_solid(kinds[i % kinds.size()], random));
    give_surface(world.solids.back());
  }
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(body_count))));
  world.ground.kind = Kind::box;
  world.ground.sizes = {spacing * static_cast<double>(side), spacing * static_cast<double>(side), 1};
  world.ground_at.position = {0, 0, -1};
  std::vector<Placement> placements;
  for (std::size_t i = 0; i < body_count; ++i) {
    const auto cell = [&](std::size_t number) {
      return spacing * (static_cast<double>(number % side) + random.uniform(-jitter, jitter));
    };
    const double middle = spacing * static_cast<double>(side - 1) / 2;
    world.bodies.push_back(random.below(solid_count));
    placements.push_back(
        {{cell(i) - middle, cell(i / side) - middle, cell(i / (side * side)) + 0.6}, random.orientation()});
  }
  world.frames = {placements};
  return world;
}

// Pushes overlapping bodies apart and all of them down, until they lie on each other with shallow contacts.
void settle(World& world, std::size_t rounds) {
  std::vector<Placement>& placements = world.frames.front();
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<Point> moves(placements.size() + 1, Point{});
    std::vector<double> pushes(placements.size() + 1, 0);
    for (const Touch& touch : touches(world, placements)) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double push = touch.distance * touch.normal[axis];
        moves[touch.a][axis] += push;
        moves[touch.b][axis] -= push;
      }
      pushes[touch.a] += 1;
      pushes[touch.b] += 1;
    }
    const double fall = round + 5 < rounds ? 0.01 : 0;
    for (std::size_t i = 0; i < placements.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        placements[i].position[axis] += moves[i][axis] / std::max(1.0, pushes[i]);
      }
      placements[i].position[2] -= fall;
    }
  }
}

// Each body sways around where it is, out of step with the others, and is back after the last frame.
void animate(World& world, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Placement> middle = world.frames.front();
  world.frames.assign(frame_count, middle);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Point way = random.direction(), axis = random.direction();
    const double start = random.uniform(0, 2 * std::numbers::pi);
    const double reach = world.fast_share > 0 && i % world.fast_share == 0 ? fast_sway : sway;
    for (std::size_t frame = 0; frame < frame_count; ++frame) {
      const double phase = start + 2 * std::numbers::pi * static_cast<double>(frame) / static_cast<double>(frame_count);
      Placement& placement = world.frames[frame][i];
      for (std::size_t k = 0; k < 3; ++k) {
        placement.position[k] += reach * std::sin(phase) * way[k];
      }
      const double half = 0.5 * swing * std::cos(phase), s = std::sin(half), c = std::cos(half);
      const auto& [w, x, y, z] = middle[i].orientation;
      placement.orientation = {
          c * w - s * (axis[0] * x + axis[1] * y + axis[2] * z), c * x + s * (axis[0] * w + axis[1] * z - axis[2] * y),
          c * y + s * (axis[1] * w + axis[2] * x - axis[0] * z), c * z + s * (axis[2] * w + axis[0] * y - axis[1] * x)};
    }
  }
}

void print_counts(const std::string& cell, std::string_view name, Detector& detector) {
  Counts sum;
  for (std::size_t frame = 0; frame < frame_count; ++frame) {
    detector.place(frame);
    detector.detect();
    const Counts counts = detector.counts();
    sum.pairs += counts.pairs;
    sum.touching += counts.touching;
    sum.points += counts.points;
    sum.overlapping += counts.overlapping;
  }
  std::printf("%-10s %-10s %10zu %10zu %10zu %10zu\n", cell.c_str(), std::string(name).c_str(), sum.pairs / frame_count,
              sum.touching / frame_count, sum.points / frame_count, sum.overlapping / frame_count);
}

// The detector must outlive the run.
void add(const std::string& cell, std::string_view name, Detector& detector) {
  print_counts(cell, name, detector);
  const auto measure = [&](const char* part, bool place, bool detect) {
    const std::string full = cell + "/" + part + "/" + std::string(name);
    benchmark::RegisterBenchmark(full.c_str(), [=, &detector](benchmark::State& state) {
      std::size_t frame = 0;
      for ([[maybe_unused]] auto _ : state) {
        if (place) {
          detector.place(frame);
          frame = (frame + 1) % frame_count;
        }
        if (detect) {
          detector.detect();
        }
      }
    })->Unit(benchmark::kMillisecond);
  };
  measure("step", true, true);
  measure("poses", true, false);
}

// Whether any library is asked for it.
bool is_wanted(const std::string& scene) {
  constexpr std::array<std::string_view, 7> names{"abut", "abut-2", "bullet", "bullet-0", "fcl", "ode", "unfollowed"};
  return std::ranges::any_of(names, [&scene](std::string_view name) {
    return is_selected(scene + "/step/" + std::string(name)) || is_selected(scene + "/poses/" + std::string(name));
  });
}

int run() {
  World pile = make_block(5000, 1.15, 0.1, 1);
  settle(pile, 60);
  animate(pile, 2);
  World sparse = make_block(5000, 2, 0.4, 3);
  animate(sparse, 4);
  World fast, crowd;  // detectors keep their frames
  std::printf("per step   library         pairs   touching     points    overlap\n");
  std::vector<std::unique_ptr<Detector>> detectors;
  const auto compare = [&](const std::string& name, const World& world) {
    add(name, "abut", *detectors.emplace_back(make_abut_world(world, 1)));
    add(name, "abut-2", *detectors.emplace_back(make_abut_world(world, 2)));
    add(name, "bullet", *detectors.emplace_back(make_bullet_world(world, -1)));
    add(name, "bullet-0", *detectors.emplace_back(make_bullet_world(world, 0)));
    add(name, "fcl", *detectors.emplace_back(make_fcl_world(world)));
    if (std::unique_ptr<Detector> ode = make_ode_world(world)) {
      add(name, "ode", *detectors.emplace_back(std::move(ode)));
    }
  };
  compare("pile", pile);
  compare("sparse", sparse);
  if (is_wanted("fast")) {
    // What the paths of one body in a hundred cost: the same motion with and without them.
    fast = make_block(5000, 1.15, 0.1, 1);
    settle(fast, 60);
    fast.fast_share = 100;
    animate(fast, 2);
    add("fast", "abut", *detectors.emplace_back(make_abut_world_of_fast(fast, true)));
    add("fast", "unfollowed", *detectors.emplace_back(make_abut_world_of_fast(fast, false)));
  }
  if (is_wanted("crowd")) {
    crowd = make_block(100000, 1.15, 0.1, 5);
    settle(crowd, 20);
    animate(crowd, 6);
    add("crowd", "abut", *detectors.emplace_back(make_abut_world(crowd, 1)));
    add("crowd", "abut-2", *detectors.emplace_back(make_abut_world(crowd, 2)));
  }
  return run_and_compare({"abut", {"bullet", "bullet-0", "fcl", "ode"}, {"abut-2", "unfollowed"}, 1, "us", 1e-6});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
