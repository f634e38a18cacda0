// SPDX-License-Identifier: Apache-2.0
// Whether two shapes overlap: single pairs near each other, and an arm of six links among obstacles. FCL stops at the
// first contact as well.
#include <abut/abut.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "abut_c_shapes.hpp"
#include "mesh_files.hpp"
#include "overlaps.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

class AbutOverlaps final : public OverlapFinder {
 public:
  explicit AbutOverlaps(const Overlaps& overlaps) : group_(overlaps.group) {
    for (const Solid& solid : overlaps.solids) {
      shapes_.push_back(abut_c_shape(solid));
    }
    for (const Overlap& pair : overlaps.all) {
      jobs_.push_back(
          {shapes_[pair.a].get(), shapes_[pair.b].get(), abut_c_pose(pair.pose_a), abut_c_pose(pair.pose_b)});
    }
  }

  void answer(std::vector<char>& out) override {
    out.assign(jobs_.size() / group_, 0);
    for (std::size_t group = 0; group < out.size(); ++group) {
      std::uint32_t is_hit = 0;
      for (std::size_t i = group * group_; i < (group + 1) * group_ && is_hit == 0; ++i) {
        const Job& job = jobs_[i];
        expect_ok(abut_pair_overlaps(job.a, &job.pose_a, job.b, &job.pose_b, nullptr, &is_hit));
      }
      out[group] = is_hit != 0 ? 1 : 0;
    }
  }

 private:
  struct Job {
    const abut_shape *a, *b;
    abut_pose pose_a, pose_b;
  };

  std::size_t group_;
  std::vector<AbutCShape> shapes_;
  std::vector<Job> jobs_;
};

// One unit high, around the origin.
[[nodiscard]] Solid bunny() {
  const TriangleMesh mesh = read_obj(ABUT_DATA_DIR "/bunny.obj");
  Point low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < mesh.xyz.size(); ++i) {
    low.at(i % 3) = std::min(low.at(i % 3), mesh.xyz[i]);
    high.at(i % 3) = std::max(high.at(i % 3), mesh.xyz[i]);
  }
  Solid solid{Kind::mesh, {}, {}, {}};
  const double scale = 1 / (high[1] - low[1]);
  for (std::size_t i = 0; i < mesh.xyz.size(); i += 3) {
    Point point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.at(axis) = scale * (mesh.xyz[i + axis] - 0.5 * (low.at(axis) + high.at(axis)));
    }
    solid.points.push_back(point);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    solid.triangles.push_back({static_cast<int>(mesh.triangles[i]), static_cast<int>(mesh.triangles[i + 1]),
                               static_cast<int>(mesh.triangles[i + 2])});
  }
  return solid;
}

[[nodiscard]] Placement random_placement(Random& random, double reach) {
  return {{random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)},
          random.orientation()};
}

// Those of random pairs that overlap, or those that do not.
constexpr std::size_t pair_count = 1000;
[[nodiscard]] Overlaps pairs_of(const Solid& a, const Solid& b, double reach, bool are_overlapping) {
  Random random(20261128);
  Overlaps tried{{a, b}, {}}, kept{{a, b}, {}};
  for (int i = 0; i < 20000; ++i) {
    tried.all.push_back({0, 1, random_placement(random, 0), random_placement(random, reach)});
  }
  std::vector<char> answers;
  AbutOverlaps(tried).answer(answers);
  for (std::size_t i = 0; i < answers.size() && kept.all.size() < pair_count; ++i) {
    if ((answers[i] != 0) == are_overlapping) {
      kept.all.push_back(tried.all[i]);
    }
  }
  return kept;
}

[[nodiscard]] Point rotated(const Quaternion& q, const Point& v) {
  const Quaternion image = product(product(q, {0, v[0], v[1], v[2]}), {q[0], -q[1], -q[2], -q[3]});
  return {image[1], image[2], image[3]};
}

// Capsules one behind the other, each turned by random angles from the one before, and what they may hit.
[[nodiscard]] Overlaps arm_among(std::size_t poses) {
  constexpr std::size_t links = 6, obstacles = 12;
  constexpr double half = 0.15;
  Random random(7);
  Overlaps arm{{{Kind::capsule, {0.05, half}, {}, {}}, bunny()}, {}};
  std::vector<Placement> places{{{1.0, 0.2, 0.3}, {1, 0, 0, 0}}};
  for (std::size_t i = 0; i < obstacles; ++i) {
    const double size = random.uniform(0.25, 0.45), far = random.uniform(0.8, 1.2), up = random.uniform(0.1, 1);
    const Point direction = random.direction();
    arm.solids.push_back({std::array{Kind::box, Kind::sphere, Kind::cylinder}.at(i % 3), {size, size, size}, {}, {}});
    places.push_back({{far * direction[0], far * direction[1], far * up * direction[2]}, random.orientation()});
  }
  arm.group = links * places.size();
  for (std::size_t pose = 0; pose < poses; ++pose) {
    Point joint{0, 0, 0.2};
    Quaternion turn{1, 0, 0, 0};
    for (std::size_t link = 0; link < links; ++link) {
      const double bend = random.uniform(-0.6, 0.6), swing = random.uniform(-1.57, 1.57);
      turn = product(turn, product({std::cos(swing), 0, 0, std::sin(swing)}, {std::cos(bend), std::sin(bend), 0, 0}));
      const Point along = rotated(turn, {0, 0, half});
      const Placement middle{{joint[0] + along[0], joint[1] + along[1], joint[2] + along[2]}, turn};
      joint = {joint[0] + 2 * along[0], joint[1] + 2 * along[1], joint[2] + 2 * along[2]};
      for (std::size_t i = 0; i < places.size(); ++i) {
        arm.all.push_back({0, i + 1, middle, places[i]});
      }
    }
  }
  return arm;
}

using MakeFinder = std::function<std::unique_ptr<OverlapFinder>(const Overlaps&)>;

void add(const std::string& name, const Overlaps& overlaps, const MakeFinder& make) {
  benchmark::RegisterBenchmark(name.c_str(), [overlaps, make](benchmark::State& state) {
    const std::unique_ptr<OverlapFinder> finder = make(overlaps);
    std::vector<char> answers;
    finder->answer(answers);
    for ([[maybe_unused]] auto _ : state) {
      finder->answer(answers);
    }
    state.counters["overlapping"] = static_cast<double>(std::ranges::count(answers, 1));
  });
}

// Prints where both do not agree: on touches.
void add_both(const std::string& cell, const Overlaps& overlaps) {
  if (!is_selected(cell)) {
    return;
  }
  const MakeFinder ours = [](const Overlaps& all) { return std::make_unique<AbutOverlaps>(all); };
  std::vector<char> found, other;
  ours(overlaps)->answer(found);
  make_fcl_overlaps(overlaps)->answer(other);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    differ += found[i] != other[i] ? 1 : 0;
  }
  std::printf("%s: %zu of %zu overlap, %zu differ from FCL\n", cell.c_str(),
              static_cast<std::size_t>(std::ranges::count(found, 1)), found.size(), differ);
  add(cell + "/abut", overlaps, ours);
  add(cell + "/fcl", overlaps, make_fcl_overlaps);
}

int run() {
  const Solid mesh = bunny(), capsule{Kind::capsule, {0.05, 0.2}, {}, {}}, box{Kind::box, {0.3, 0.2, 0.1}, {}, {}},
              cylinder{Kind::cylinder, {0.2, 0.3}, {}, {}};
  struct Two {
    const char* name;
    const Solid &a, &b;
    double reach;
  };
  for (const Two& two : {Two{"bunny and capsule", mesh, capsule, 0.7}, Two{"two bunnies", mesh, mesh, 1},
                         Two{"two boxes", box, box, 0.5}, Two{"box and capsule", box, capsule, 0.5},
                         Two{"two cylinders", cylinder, cylinder, 0.5}}) {
    add_both(std::string(two.name) + ", overlapping", pairs_of(two.a, two.b, two.reach, true));
    add_both(std::string(two.name) + ", apart", pairs_of(two.a, two.b, two.reach, false));
  }
  // Times of these are those of so many poses.
  add_both("1000 poses of an arm", arm_among(pair_count));
  return run_and_compare({"abut", {"fcl"}, {}, pair_count, "ns", 1e-9});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
