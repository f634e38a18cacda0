// SPDX-License-Identifier: Apache-2.0
// Where stiff problems go wrong: bodies in contact over stiffness and step, mass ratio, and friction. abut beside
// Bullet and ODE, against closed forms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "flags.hpp"
#include "response.hpp"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* usage = R"(usage: abut_bench_response_maps --json FILE [--every N] [--only TEXT] [--seconds N]

Writes the error of each place of each map.
  --every N     every Nth place of each axis (1)
  --only TEXT   only maps with this in their name, such as spring
  --seconds N   a run that takes longer is told up to there (10)
)";

struct Engine {
  std::string name;
  std::unique_ptr<Mover> (*make)(const MovingWorld&, const Effort&);
  Effort effort;
};

std::vector<Engine> engines() {
  std::vector<Engine> out{{"abut", make_abut_mover, {"1e-9", 200, 1e-9}},
                          {"Bullet", make_bullet_mover, {"200", 200, 0}}};
  if (has_ode()) {
    out.push_back({"ODE sweeps", make_ode_mover, {"200", 200, 0}});
    out.push_back({"ODE factors", make_ode_mover, {"-", 0, 0}});
  }
  return out;
}

std::vector<Engine> engines_of_springs() {
  std::vector<Engine> out = engines();
  out.front() = {"abut implicit", make_abut_mover, {"1e-13", 200, 1e-13}};
  out.insert(out.begin() + 1, Engine{"abut midpoint", make_abut_mover, {"1e-13", 200, 1e-13, true}});
  return out;
}

struct Run {
  std::unique_ptr<Mover> mover;
  double most_seconds = 0;
  std::chrono::duration<double> spent{};
  int steps = 0;

  void step(double dt) {
    const auto start = std::chrono::steady_clock::now();
    mover->step(dt);
    spent += std::chrono::steady_clock::now() - start;
    ++steps;
  }
  [[nodiscard]] bool is_late() const { return spent.count() > most_seconds; }
  [[nodiscard]] Json with(Json its) const {
    its["microseconds"] = 1e6 * spent.count() / std::max(steps, 1);
    its["is_late"] = is_late();
    return its;
  }
};

// A ball of 1 kg meets a spring at 1 m/s. `left` is the speed after the bounce, 1 by the law. `gain` is the most that
// energy has been above that of the approach, as a part of it.
Json spring(const Engine& engine, double stiffness, double dt, double seconds) {
  MovingWorld world;
  world.gravity = 0;
  world.stiffness = stiffness;
  world.reach = 1e-9;
  world.bodies.push_back({.half = 0.5, .mass = 1, .position = {0, 0, 0.5}, .velocity = {0, 0, -1}});
  Run run{engine.make(world, engine.effort), seconds};
  const double period = 2 * std::numbers::pi / std::sqrt(stiffness);
  const int most = static_cast<int>(1.2 * period / dt) + 40;
  double gain = 0;
  for (int i = 0; i < most; ++i) {
    run.step(dt);
    const double depth = std::max(0.0, 0.5 - run.mover->position(0)[2]), speed = run.mover->velocity(0)[2];
    gain = std::max(gain, speed * speed + stiffness * depth * depth - 1);
    if ((speed > 0 && depth == 0) || run.is_late()) break;
  }
  const double left = run.mover->velocity(0)[2];
  return run.with({{"error", std::fabs(1 - left)}, {"left", left}, {"gain", gain}});
}

// Ten boxes of 1 m on each other, the top heavier by the ratio: the root of the mean squared drift of heights after 1
// s, m.
Json stack(const Engine& engine, double ratio, double dt, double seconds) {
  constexpr int count = 10;
  MovingWorld world;
  world.friction = world.ground_friction = 0.5;
  for (int i = 0; i < count; ++i)
    world.bodies.push_back({.is_box = true,
                            .half = 0.5,
                            .side = 0.5,
                            .mass = std::pow(ratio, i / (count - 1.0)),
                            .position = {0, 0, 0.5 + i}});
  Run run{engine.make(world, engine.effort), seconds};
  while (run.steps * dt < 1 && !run.is_late()) run.step(dt);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += std::pow(run.mover->position(i)[2] - 0.5 - static_cast<double>(i), 2) / count;
  return run.with({{"error", std::sqrt(sum)}});
}

// A box that slides at 1 m/s: how far it is from where friction stops it, as a part of the way.
Json slide(const Engine& engine, double friction, double dt, double seconds) {
  MovingWorld world;
  world.friction = world.ground_friction = friction;
  world.bodies.push_back(
      {.is_box = true, .half = 0.05, .side = 0.5, .mass = 1, .position = {0, 0, 0.05}, .velocity = {1, 0, 0}});
  Run run{engine.make(world, engine.effort), seconds};
  const double until = 1 / (friction * world.gravity), way = until / 2;
  // Slow stops are cut off, and compared there.
  const double time = std::min(until, 400 * dt);
  while (run.steps * dt < time && !run.is_late()) run.step(dt);
  const double now = std::min(run.steps * dt, until);
  const double expected = now - friction * world.gravity * now * now / 2;
  const double error = std::fabs(run.mover->position(0)[0] - expected) / std::min(way, expected);
  return run.with({{"error", error}});
}

// A box that is pushed by 1 % less than friction holds: its speed as a part of that without friction.
Json hold(const Engine& engine, double friction, double dt, double seconds) {
  MovingWorld world;
  world.friction = world.ground_friction = friction;
  world.bodies.push_back({.is_box = true, .half = 0.05, .side = 0.5, .mass = 1, .position = {0, 0, 0.05}});
  Run run{engine.make(world, engine.effort), seconds};
  const double force = 0.99 * friction * world.gravity;
  while (run.steps * dt < 1 && !run.is_late()) {
    run.mover->push(0, {force, 0, 0});
    run.step(dt);
  }
  const auto [x, y, z] = run.mover->velocity(0);
  return run.with({{"error", std::hypot(x, y) / force / (run.steps * dt)}});
}

struct Map {
  std::string name, error, x, y;  // what the error is, and both axes
  std::vector<double> xs, ys;
  std::function<Json(const Engine&, double x, double y, double seconds)> measure;
  std::vector<Engine> engines;
};

std::vector<double> powers(double from, double to, double step, std::size_t every) {
  std::vector<double> list;
  for (double power = from; power <= to + 1e-9; power += step * static_cast<double>(every))
    list.push_back(std::pow(10, power));
  return list;
}

void run(const std::vector<std::string>& words) {
  std::filesystem::path path;
  std::string only;
  std::size_t every = 1, seconds = 10;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--json") {
      path = value;
    } else if (name == "--every") {
      every = count_of(name, value);
    } else if (name == "--seconds") {
      seconds = count_of(name, value);
    } else if (name == "--only") {
      only = value;
    } else {
      refuse(name, usage);
    }
  }
  if (path.empty()) throw std::runtime_error(std::string("--json is missing\n") + usage);
  const std::vector<double> steps = powers(-3, -1, 0.5, every);
  const std::vector<Map> maps{
      {"spring", "part of the speed that a bounce on a spring is off by", "stiffness, N/m", "step, s",
       powers(2, 12, 1, every), powers(-5, -1, 0.5, every), spring, engines_of_springs()},
      {"stack", "drift of the heights of ten boxes in 1 s, m", "mass of the top by that of the bottom", "step, s",
       powers(0, 9, 1, every), steps, stack, engines()},
      {"slide", "part of the way that a sliding box is off by", "friction", "step, s", powers(-3, 0, 0.5, every), steps,
       slide, engines()},
      {"hold", "part of the speed that a box gets which friction should hold", "friction", "step, s",
       powers(-3, 0, 0.5, every), steps, hold, engines()}};
  Json document{{"every", every}, {"maps", Json::array()}};
  for (const Map& map : maps) {
    if (map.name.find(only) == std::string::npos) continue;
    Json rows = Json::array();
    for (const Engine& engine : map.engines) {
      std::fprintf(stderr, "%s, %s\n", map.name.c_str(), engine.name.c_str());
      for (const double y : map.ys) {
        for (const double x : map.xs) {
          Json row{{"x", x}, {"y", y}, {"contender", engine.name}};
          row.update(map.measure(engine, x, y, static_cast<double>(seconds)));
          rows.push_back(std::move(row));
        }
      }
    }
    document["maps"].push_back(
        {{"name", map.name}, {"error", map.error}, {"x", map.x}, {"y", map.y}, {"rows", std::move(rows)}});
  }
  std::ofstream file(path);
  file << document.dump() << '\n';
  if (!file.flush()) throw std::runtime_error(path.string() + " cannot be written");
}

}  // namespace
}  // namespace bench

int main(int count, char** words) { return bench::main_of(count, words, bench::usage, bench::run); }
