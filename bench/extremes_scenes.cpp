// SPDX-License-Identifier: Apache-2.0
#include "extremes_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "accuracy_judge.hpp"
#include "accuracy_placing.hpp"
#include "accuracy_solids.hpp"
#include "oracle/support.hpp"
#include "random_pairs.hpp"

namespace bench {
namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

// Tries for each case that is wanted: rounding may leave a pair on the other side.
constexpr std::size_t most_tries = 20;
// A gap or depth below this part of the size has no certain sign.
constexpr double least_part = 1e-19;

Judge judge_of(Solid& solid) {
  if (is_hull(solid.kind)) {
    find_surface(solid);
  }
  return Judge(solid);
}

Solid any_solid(Kind kind, Random& random) { return random_solid(kind, random); }

Placement anywhere(Random& random) {
  return {{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, random.orientation()};
}

Vec outside_of(const Solid& solid, const Placement& pose, Random& random) {
  return oracle_pose(pose).rotate(side_normal(solid, random));
}

struct Pair {
  Solid a, b;
  Placement pose_a, pose_b;
};

// Every case has solids of its own.
std::optional<JudgedCell> judged(Query query, std::size_t count, const std::function<Pair(std::size_t)>& draw) {
  JudgedCell cell;
  for (std::size_t i = 0; i < most_tries * count && cell.cases.size() < count; ++i) {
    Pair pair = draw(i);
    Judge a = judge_of(pair.a), b = judge_of(pair.b);
    const std::optional<Quad> truth =
        true_distance(a, oracle_pose(pair.pose_a), b, oracle_pose(pair.pose_b), query == Query::depth);
    const Quad least = quad(least_part * (bounding_radius(pair.a) + bounding_radius(pair.b)));
    const bool is_wanted = truth && (query == Query::depth ? *truth < -least : *truth > least);
    if (is_wanted) {
      cell.solids_a.push_back(std::move(pair.a));
      cell.solids_b.push_back(std::move(pair.b));
      cell.add({cell.cases.size(), cell.cases.size(), pair.pose_a, pair.pose_b, {}}, *truth);
    }
  }
  return cell.cases.empty() ? std::nullopt : std::optional(std::move(cell));
}

double signed_gap(Query query, double size) { return query == Query::depth ? -size : size; }

Placement facing_side(const Pair& pair, const Judge& a, const Judge& b, const Quaternion& turn, const Vec& n,
                      double gap, double slack) {
  return facing(a.solid(), pair.pose_a, b.solid(), turn, n, gap, slack);
}

// A seed for each map and kinds of solids, not for each place: neighbours differ by their hardness alone.
std::uint64_t seed_of(std::uint64_t map, Query query, TwoKinds kinds) {
  return 1 + map +
         16 * (static_cast<std::uint64_t>(query) +
               16 * (static_cast<std::uint64_t>(kinds.a) + 16 * static_cast<std::uint64_t>(kinds.b)));
}

}  // namespace

std::string TwoKinds::name() const { return std::string(kind_name(a)) + "-" + std::string(kind_name(b)); }

std::optional<JudgedCell> out_of_proportion(Query query, TwoKinds kinds, double ratio, double aspect,
                                            std::size_t count) {
  Random random(seed_of(0, query, kinds));
  return judged(query, count, [&](std::size_t i) {
    const bool is_needle = i % 2 == 0;
    Pair pair{made_thin(any_solid(kinds.a, random), is_needle, aspect),
              scaled(made_thin(any_solid(kinds.b, random), is_needle, aspect), 1 / ratio),
              anywhere(random),
              {}};
    const Judge a = judge_of(pair.a), b = judge_of(pair.b);
    const double small = bounding_radius(pair.b) / (query == Query::depth ? aspect : 1);
    const double gap = signed_gap(query, random.uniform(0.1, 0.5) * small);
    const Vec n = outside_of(pair.a, pair.pose_a, random);
    pair.pose_b = facing_side(pair, a, b, random.orientation(), n, gap, 1e-12);
    return pair;
  });
}

std::optional<JudgedCell> far_away(Query query, TwoKinds kinds, double distance, std::size_t count) {
  Random random(seed_of(1, query, kinds));
  return judged(query, count, [&](std::size_t) {
    Pair pair{any_solid(kinds.a, random), any_solid(kinds.b, random), {}, {}};
    const Case one = random_case(std::vector{pair.a}, std::vector{pair.b}, random);
    pair.pose_a = one.pose_a;
    pair.pose_b = one.pose_b;
    const Point direction = random.direction();
    for (std::size_t i = 0; i < 3; ++i) {
      pair.pose_a.position.at(i) += distance * direction.at(i);
      pair.pose_b.position.at(i) += distance * direction.at(i);
    }
    return pair;
  });
}

std::optional<JudgedCell> nearly_parallel(Query query, TwoKinds kinds, double angle, std::size_t count) {
  Random random(seed_of(2, query, kinds));
  return judged(query, count, [&](std::size_t) {
    Pair pair{any_solid(kinds.a, random), any_solid(kinds.b, random), anywhere(random), {}};
    const Judge a = judge_of(pair.a), b = judge_of(pair.b);
    const Vec n = outside_of(pair.a, pair.pose_a, random);
    const Quaternion turn = product(small_turn(angle, random), turn_from(side_normal(pair.b, random), -n));
    const double gap = 0.01 * (bounding_radius(pair.a) + bounding_radius(pair.b));
    pair.pose_b = facing_side(pair, a, b, turn, n, signed_gap(query, gap), 2 * angle + 1e-12);
    return pair;
  });
}

std::optional<JudgedCell> nearly_touching(Query query, TwoKinds kinds, double part, std::size_t count) {
  Random random(seed_of(3, query, kinds));
  return judged(query, count, [&](std::size_t) {
    Pair pair{any_solid(kinds.a, random), any_solid(kinds.b, random), anywhere(random), {}};
    const Judge a = judge_of(pair.a), b = judge_of(pair.b);
    const double gap = part * (bounding_radius(pair.a) + bounding_radius(pair.b));
    const Vec n = outside_of(pair.a, pair.pose_a, random);
    pair.pose_b = facing_side(pair, a, b, random.orientation(), n, signed_gap(query, gap), 1e-12);
    return pair;
  });
}

JudgedCell on_a_floor(Kind kind, std::size_t triangles, std::size_t count) {
  constexpr double half = 4, depth = 0.01;
  JudgedCell cell;
  Solid floor{Kind::mesh, {}, {}, {}};
  if (triangles == 1) {
    floor.points = {{-4 * half, -2 * half, 0}, {4 * half, -2 * half, 0}, {0, 4 * half, 0}};
    floor.triangles = {{0, 1, 2}};
  } else {
    const int side = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 2));
    for (int j = 0; j <= side; ++j) {
      for (int i = 0; i <= side; ++i) {
        floor.points.push_back({half * (2.0 * i / side - 1), half * (2.0 * j / side - 1), 0});
      }
    }
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const int first = j * (side + 1) + i, last = first + side + 2;
        floor.triangles.push_back({first, first + 1, last});
        floor.triangles.push_back({first, last, last - 1});
      }
    }
  }
  cell.solids_a.push_back(std::move(floor));
  Random random(seed_of(4, Query::contacts, {Kind::mesh, kind}));
  for (std::size_t i = 0; i < count; ++i) {
    Solid solid = any_solid(kind, random);
    const Judge judge = judge_of(solid);
    // Every other one lies flat.
    const Quaternion turn = i % 2 == 0 ? Quaternion{1, 0, 0, 0} : random.orientation();
    Placement pose{{random.uniform(-2, 2), random.uniform(-2, 2), 0}, turn};
    const Quad down = oracle::support(judge.solid(), oracle_pose(pose).rotate_back({0, 0, -1}));
    pose.position[2] = static_cast<double>(down) - depth;
    cell.solids_b.push_back(std::move(solid));
    cell.add({0, i, {}, pose, {}}, quad(pose.position[2]) - down);
  }
  return cell;
}

}  // namespace bench
