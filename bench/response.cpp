// SPDX-License-Identifier: Apache-2.0
// Error against run time of bodies in contact: abut at several bounds beside Bullet and ODE at several iterations, in
// one run. Rolling, bouncing and 666 are those of Kang and Hwangbo, SimBenchmark (2018),
// https://leggedrobotics.github.io/SimBenchmark/, by their formulas of error.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "flags.hpp"
#include "response.hpp"
#include "response_file.hpp"

namespace bench {
namespace {

constexpr const char* usage = R"(usage: abut_bench_response [--out FOLDER] [--json FILE] [--only TEXT] [--seconds N]

Prints tables of time and error, and writes response.csv.
  --out FOLDER   where response.csv goes (out/response)
  --json FILE    also writes all rows there, each with its error over time
  --only TEXT    only trials that have this in their name, such as rolling
  --seconds N    a run that takes longer is told up to there (60)
)";

double square(const Vector3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }
Vector3 less(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

struct Trial {
  std::string name, error;  // what the error is, and its unit
  MovingWorld world;
  double step, time;
  Vector3 force{};                                            // on body 0
  std::function<double(const Mover&, double now)> error_now;  // its mean over time is told
};

// A box of 10 kg under 25 balls of 1 kg, pushed by 150 N.
Trial rolling(const std::string& name, double x, double y) {
  Trial out{.name = name,
            .error = "squared error of velocities, m^2/s^2",
            .world = {},
            .step = 1e-2,
            .time = 4,
            .force = {150 * x, 150 * y, 0},
            .error_now = {}};
  out.world.friction = 0.8;
  out.world.ground_friction = 0.4;
  out.world.bodies.push_back({.is_box = true, .half = 0.5, .side = 10, .mass = 10, .position = {0, 0, 0.5}});
  for (int i = 0; i < 25; ++i)
    out.world.bodies.push_back({.half = 0.5, .mass = 1, .position = {2.0 * (i % 5 - 2), 2.0 * (i / 5 - 2), 1.5}});
  const double gain = (150 - 0.4 * 35 * out.world.gravity) / 60;
  out.error_now = [=](const Mover& its, double now) {
    const Vector3 of_ball{now * gain * x, now * gain * y, 0};
    const Vector3 of_box{3.5 * of_ball[0], 3.5 * of_ball[1], 0};
    return square(less(its.velocity(0), of_box)) + square(less(its.velocity(1), of_ball));
  };
  return out;
}

// 49 balls of 10 kg that fall from 4.9 m and lose nothing.
Trial bouncing() {
  Trial out{.name = "bouncing",
            .error = "squared error of energy, J^2",
            .world = {},
            .step = 1e-2,
            .time = 20,
            .force = {},
            .error_now = {}};
  out.world.restitution = 1;
  for (int i = 0; i < 49; ++i)
    out.world.bodies.push_back({.half = 0.1, .mass = 10, .position = {2.0 * (i % 7), 2.0 * (i / 7), 5}});
  const double whole = 49 * 10 * out.world.gravity * 5;
  out.error_now = [=, gravity = out.world.gravity](const Mover& its, double) {
    double energy = -whole;
    for (std::size_t i = 0; i < 49; ++i) energy += 10 * (0.5 * square(its.velocity(i)) + gravity * its.position(i)[2]);
    return energy * energy;
  };
  return out;
}

double squared_depths(const Mover& its, std::size_t count, double radius) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 at = its.position(i);
    sum += std::pow(std::max(0.0, radius - at[2]), 2);
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = square(less(at, its.position(j)));
      if (apart < 4 * radius * radius) sum += std::pow(2 * radius - std::sqrt(apart), 2);
    }
  }
  return sum;
}

// 216 balls that fall and fly apart.
Trial six_six_six(const std::string& name, double friction) {
  Trial out{.name = name,
            .error = "sum of squared depths, m^2",
            .world = {},
            .step = 1e-2,
            .time = 3,
            .force = {},
            .error_now = {}};
  out.world.friction = friction;
  // Balls arrive at 5 m/s, and one that is stopped within a step is met by the next in the same step.
  out.world.reach = 0.03;
  std::mt19937 random(666);
  std::uniform_real_distribution<double> noise(-1e-3, 1e-3);
  for (int i = 0; i < 216; ++i) {
    const Vector3 at{0.21 * (i % 6) + noise(random), 0.21 * (i / 6 % 6) + noise(random), 1.101 + 0.21 * (i / 36)};
    out.world.bodies.push_back({.half = 0.1, .mass = 10, .position = at});
  }
  out.error_now = [](const Mover& its, double) { return squared_depths(its, 216, 0.1); };
  return out;
}

// Ten boxes of 1 m on each other, heavier upwards.
Trial stack(const std::string& name, double ratio) {
  Trial out{.name = name,
            .error = "squared drift of heights, m^2",
            .world = {},
            .step = 1e-2,
            .time = 2,
            .force = {},
            .error_now = {}};
  out.world.friction = out.world.ground_friction = 0.5;
  for (int i = 0; i < 10; ++i)
    out.world.bodies.push_back(
        {.is_box = true, .half = 0.5, .side = 0.5, .mass = std::pow(ratio, i / 9.0), .position = {0, 0, 0.5 + i}});
  out.error_now = [](const Mover& its, double) {
    double sum = 0;
    for (std::size_t i = 0; i < 10; ++i)
      sum += square(less(its.position(i), {0, 0, 0.5 + static_cast<double>(i)})) / 10;
    return sum;
  };
  return out;
}

struct Engine {
  std::string name;
  std::unique_ptr<Mover> (*make)(const MovingWorld&, const Effort&);
  std::vector<Effort> efforts;
};

std::vector<Engine> engines() {
  std::vector<Engine> out{
      {"abut Newton",
       make_abut_mover,
       {{"1e-3", 200, 1e-3}, {"1e-6", 200, 1e-6}, {"1e-9", 200, 1e-9}, {"1e-13", 200, 1e-13}}},
      {"abut sweeps", make_abut_mover, {{"10", 10, 0}, {"50", 50, 0}, {"200", 200, 0}, {"1000", 1000, 0}}},
      {"Bullet", make_bullet_mover, {{"10", 10, 0}, {"50", 50, 0}, {"200", 200, 0}, {"1000", 1000, 0}}}};
  if (has_ode()) {
    out.push_back({"ODE sweeps", make_ode_mover, {{"20", 20, 0}, {"50", 50, 0}, {"200", 200, 0}, {"1000", 1000, 0}}});
    out.push_back({"ODE factors", make_ode_mover, {{"-", 0, 0}}});
  }
  return out;
}

Measured measure(const Trial& trial, const Engine& engine, const Effort& effort, double most_seconds) {
  constexpr int points_of_course = 50;
  Measured out{
      .trial = trial.name, .error_name = trial.error, .engine = engine.name, .effort = effort.name, .course = {}};
  const std::unique_ptr<Mover> mover = engine.make(trial.world, effort);
  const int steps = static_cast<int>(std::lround(trial.time / trial.step));
  std::chrono::duration<double> spent{};
  for (int i = 1; i <= steps; ++i) {
    const auto start = std::chrono::steady_clock::now();
    mover->push(0, trial.force);
    mover->step(trial.step);
    spent += std::chrono::steady_clock::now() - start;
    const double error = trial.error_now(*mover, i * trial.step);
    out.error += error / steps;
    if (i % std::max(1, steps / points_of_course) == 0) out.course.push_back({i * trial.step, error});
    if (spent.count() > most_seconds) {
      out.error *= static_cast<double>(steps) / i;
      out.milliseconds = 1e3 * spent.count() / i;
      out.effort += " (" + std::to_string(i) + " steps)";
      return out;
    }
  }
  out.milliseconds = 1e3 * spent.count() / steps;
  return out;
}

void run(const std::vector<std::string>& words) {
  std::filesystem::path folder = "out/response", json;
  std::string only;
  std::size_t seconds = 60;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--out" && !value.empty()) {
      folder = value;
    } else if (name == "--json" && !value.empty()) {
      json = value;
    } else if (name == "--only") {
      only = value;
    } else if (name == "--seconds") {
      seconds = count_of(name, value);
    } else {
      refuse(name, usage);
    }
  }
  const std::array trials{rolling("rolling along y", 0, 1),
                          rolling("rolling askew", 0.5, std::sqrt(0.75)),
                          bouncing(),
                          six_six_six("666", 0),
                          six_six_six("666 rough", 0.5),
                          stack("stack 1 : 1", 1),
                          stack("stack 1 : 1e6", 1e6)};
  std::vector<Measured> all;
  for (const Trial& trial : trials) {
    if (trial.name.find(only) == std::string::npos) continue;
    std::printf("\n%s, steps of %g s for %g s: %s\n", trial.name.c_str(), trial.step, trial.time, trial.error.c_str());
    for (const Engine& engine : engines()) {
      for (const Effort& effort : engine.efforts) {
        const Measured& its = all.emplace_back(measure(trial, engine, effort, static_cast<double>(seconds)));
        std::printf("  %-12s %-18s %10.4f ms a step %12.3g\n", its.engine.c_str(), its.effort.c_str(), its.milliseconds,
                    its.error);
        std::fflush(stdout);
      }
    }
  }
  std::filesystem::create_directories(folder);
  write_table(folder / "response.csv", all);
  if (!json.empty()) write_json(json, all);
}

}  // namespace
}  // namespace bench

int main(int count, char** words) { return bench::main_of(count, words, bench::usage, bench::run); }
