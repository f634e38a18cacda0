// SPDX-License-Identifier: Apache-2.0
// When solids first touch that move and turn: rods, boxes and hulls that fly at each other, mostly to touch, and two
// meshes of 40,000 triangles.
#include <abut/abut.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "abut_c_shapes.hpp"
#include "impacts.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::size_t flight_count = 2000;

class AbutImpacts final : public ImpactFinder {
 public:
  explicit AbutImpacts(const Flights& flights)
      : AbutImpacts(flights, abut_c_shape(flights.a), abut_c_shape(flights.b)) {}
  AbutImpacts(const Flights& flights, AbutCShape a, AbutCShape b)
      : a_(std::move(a)), b_(std::move(b)), found_(flights.all.size()) {
    abut_impact_options_init(&options_, sizeof options_);
    options_.threads = 1;
    for (const Flight& flight : flights.all) {
      add(flight.from_a, flight.to_a, poses_a_, movements_a_);
      add(flight.from_b, flight.to_b, poses_b_, movements_b_);
    }
  }

  [[nodiscard]] std::size_t answer() override {
    expect_ok(abut_pairs_time_of_impact(a_.get(), poses_a_.data(), movements_a_.data(), b_.get(), poses_b_.data(),
                                        movements_b_.data(), found_.size(), 1, &options_, found_.data()));
    std::size_t touching = 0;
    for (const abut_impact& impact : found_) {
      touching += impact.state == ABUT_IMPACT_TOUCHES ? 1 : 0;
    }
    return touching;
  }

 private:
  static void add(const Placement& from, const Placement& to, std::vector<abut_pose>& poses,
                  std::vector<abut_movement>& movements) {
    const abut_pose start = abut_c_pose(from), end = abut_c_pose(to);
    const abut_vec3 centre{0, 0, 0};
    abut_movement movement;
    expect_ok(abut_movement_between(&start, &end, &centre, 1, &movement));
    poses.push_back(start);
    movements.push_back(movement);
  }

  AbutCShape a_, b_;
  abut_impact_options options_{};
  std::vector<abut_pose> poses_a_, poses_b_;
  std::vector<abut_movement> movements_a_, movements_b_;
  std::vector<abut_impact> found_;
};

[[nodiscard]] Quaternion turn(Random& random, double most) {
  const Point axis = random.direction();
  const double half = 0.5 * random.uniform(0, most), sine = std::sin(half);
  return {std::cos(half), sine * axis[0], sine * axis[1], sine * axis[2]};
}

// b starts `away` from a and passes it within 1.2; both turn by up to `spin`.
[[nodiscard]] Flights flights_of(const Solid& a, const Solid& b, double away, double spin) {
  Random random(5);
  Flights flights{a, b, {}};
  for (std::size_t i = 0; i < flight_count; ++i) {
    const Point toward = random.direction();
    Flight flight;
    flight.from_a.orientation = turn(random, 3);
    flight.from_b.orientation = turn(random, 3);
    flight.to_a.orientation = product(turn(random, spin), flight.from_a.orientation);
    flight.to_b.orientation = product(turn(random, spin), flight.from_b.orientation);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      flight.from_b.position[axis] = away * toward[axis];
      flight.to_b.position[axis] = -0.3 * away * toward[axis] + random.uniform(-1.2, 1.2);
    }
    flights.all.push_back(flight);
  }
  return flights;
}

[[nodiscard]] Solid ball_hull() {
  Random random(9);
  Solid hull{Kind::hull32, {}, {}, {}};
  for (int i = 0; i < 32; ++i) {
    hull.points.push_back(random.direction());
  }
  return hull;
}

// A torus whose tube swells and thins around it. Meshes of 40,000 triangles of it do not touch at once everywhere.
[[nodiscard]] AbutCShape wavy_torus() {
  constexpr std::uint32_t around = 200, across = 100;
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (std::uint32_t j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across, radius = 0.4 + 0.03 * std::sin(7 * u) * std::cos(5 * v);
      const double reach = 1 + radius * std::cos(v);
      xyz.insert(xyz.end(), {reach * std::cos(u), reach * std::sin(u), radius * std::sin(v)});
      const std::uint32_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = next_i * across + j, c = next_i * across + next_j,
                          d = i * across + next_j;
      triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
  }
  abut_shape* shape = nullptr;
  expect_ok(abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &shape));
  expect_ok(abut_shape_prepare(shape, 1));
  return AbutCShape(shape);
}

using MakeFinder = std::function<std::unique_ptr<ImpactFinder>(const Flights&)>;

void add(const std::string& name, const Flights& flights, const MakeFinder& make) {
  benchmark::RegisterBenchmark(name.c_str(), [flights, make](benchmark::State& state) {
    const std::unique_ptr<ImpactFinder> finder = make(flights);
    std::size_t touching = 0;
    for ([[maybe_unused]] auto _ : state) {
      touching = finder->answer();
    }
    state.counters["touching"] = static_cast<double>(touching);
  });
}

int run() {
  const Solid rod{Kind::box, {0.05, 0.05, 1}, {}, {}}, box{Kind::box, {0.8, 0.5, 0.6}, {}, {}}, hull = ball_hull();
  for (const double spin : {0.0, 0.75, 2.5}) {
    const std::string turned = spin > 0 ? " turned by up to " + std::to_string(spin).substr(0, 4) : " straight";
    for (const auto& [name, solid] : {std::pair{"rods", rod}, std::pair{"boxes", box}, std::pair{"hulls", hull}}) {
      const Flights flights = flights_of(solid, solid, solid.sizes[0] < 0.1 && solid.points.empty() ? 2.2 : 3.2, spin);
      add(name + turned + "/abut", flights, [](const Flights& all) { return std::make_unique<AbutImpacts>(all); });
      add(name + turned + "/bullet", flights, make_bullet_impacts);
    }
  }
  // Bullet has no times of impact of two meshes.
  add("meshes turned by up to 2.50/abut", flights_of({}, {}, 3.2, 2.5),
      [](const Flights& all) { return std::make_unique<AbutImpacts>(all, wavy_torus(), wavy_torus()); });
  return run_and_compare({"abut", {"bullet"}, {}, flight_count, "us", 1e-6});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
