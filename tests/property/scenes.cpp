// SPDX-License-Identifier: Apache-2.0
#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace property {

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

abut_vec3 random_direction(Random& random) {
  for (;;) {
    const abut_vec3 v{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    const double length = std::hypot(v.x, v.y, v.z);
    if (length <= 1 && length > 0.1) return {v.x / length, v.y / length, v.z / length};
  }
}

abut_quat about(const abut_vec3& axis, double angle) {
  const double sine = std::sin(angle / 2);
  return {std::cos(angle / 2), axis.x * sine, axis.y * sine, axis.z * sine};
}

abut_vec3 rounded(const oracle::Vec& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

abut_vec3 moved(const abut_vec3& from, const abut_vec3& along, double distance) {
  return {from.x + along.x * distance, from.y + along.y * distance, from.z + along.z * distance};
}

namespace {

abut_quat product(const abut_quat& p, const abut_quat& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

}  // namespace

abut_quat random_orientation(Random& random) { return about(random_direction(random), between(random, 0.1, 3)); }

abut_pose composed(const abut_pose& second, const abut_pose& first) {
  return {rounded(pose_of(second).place(vec_of(first.position))), product(second.orientation, first.orientation)};
}

abut_pose moved_to_gap(const Subject& a, const abut_pose& pose_a, const Subject& b, const abut_pose& pose_b,
                       double gap) {
  const oracle::Answer answer = oracle::signed_distance(a.measured, pose_of(pose_a), b.measured, pose_of(pose_b));
  abut_pose result = pose_b;
  result.position = rounded(vec_of(pose_b.position) - answer.normal * (answer.distance - oracle::quad(gap)));
  return result;
}

namespace {

// Lengths that the scenes are built from.
struct Lengths {
  double reach;  // beyond this the shapes are apart
  double small;  // of the smaller shape
};

Lengths lengths_of(const Subject& a, const Subject& b) {
  return {a.size + b.size, std::min({a.small, b.small, a.size + b.size > 0 ? a.size + b.size : 1.0})};
}

abut_pose random_pose(Random& random, double distance) {
  return {moved({0, 0, 0}, random_direction(random), distance), random_orientation(random)};
}

struct Maker {
  const Subject& a;
  const Subject& b;
  Random& random;
  std::vector<Placement>& list;
  Lengths lengths;

  // Random orientations, `gap` between the surfaces, near `centre`.
  void add_at_gap(const std::string& scene, const abut_vec3& centre, double gap) {
    const abut_pose pose_a{centre, random_orientation(random)};
    abut_pose pose_b = random_pose(random, 1.5 * lengths.reach + 1e-3);
    pose_b.position = moved(pose_b.position, centre, 1);
    list.push_back({scene, pose_a, moved_to_gap(a, pose_a, b, pose_b, gap)});
  }

  // Orientations that differ by a quarter turn or none, and by a small angle; offset along a local axis of a.
  void add_aligned(const std::string& scene, double angle, double gap, bool quarter) {
    const abut_pose pose_a = random_pose(random, lengths.small);
    abut_quat turn = about(random_direction(random), angle);
    const std::array<abut_vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (quarter) turn = product(about(axes.at(random() % 3), std::acos(0.0)), turn);
    abut_pose local{{0, 0, 0}, turn};
    local.position = moved({0, 0, 0}, axes.at(random() % 3), 1.25 * lengths.reach);
    list.push_back({scene, pose_a, moved_to_gap(a, pose_a, b, composed(pose_a, local), gap)});
  }

  void add_deep() {
    const abut_pose pose_a = random_pose(random, lengths.reach);
    abut_pose pose_b = pose_a;
    pose_b.position = moved(pose_a.position, random_direction(random), lengths.small * between(random, 0.05, 0.8));
    pose_b.orientation = random_orientation(random);
    list.push_back({"deep", pose_a, pose_b});
  }

  void add_concentric() {
    const abut_pose pose_a = random_pose(random, lengths.reach);
    list.push_back({"coincident", pose_a, pose_a});
    list.push_back({"coincident", {{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}});
    list.push_back({"concentric", pose_a, {pose_a.position, random_orientation(random)}});
  }
};

}  // namespace

std::vector<Placement> placements(const Subject& a, const Subject& b, Random& random) {
  std::vector<Placement> list;
  const Lengths lengths = lengths_of(a, b);
  Maker make{a, b, random, list, lengths};
  make.add_at_gap("apart", {0, 0, 0}, lengths.reach * between(random, 0.01, 3));
  make.add_at_gap("far apart", {0, 0, 0}, lengths.reach * 100);
  make.add_at_gap("grazing", {0, 0, 0}, lengths.small * 1e-9);
  make.add_at_gap("touching", {0, 0, 0}, 0);
  make.add_at_gap("shallow", {0, 0, 0}, -lengths.small * 1e-9);
  make.add_at_gap("shallow", {0, 0, 0}, -lengths.small * 1e-3);
  make.add_deep();
  make.add_concentric();
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
    const bool quarter = random() % 2 == 0;
    make.add_aligned("parallel", angle, lengths.small * 1e-2, quarter);
    make.add_aligned("parallel touching", angle, 0, !quarter);
    make.add_aligned("parallel overlapping", angle, -lengths.small * 1e-2, quarter);
  }
  for (const double far : {1e5, 1e7}) {
    const abut_vec3 centre = moved({0, 0, 0}, random_direction(random), far);
    make.add_at_gap("far from the origin", centre, lengths.small * between(random, 0.1, 1));
    make.add_at_gap("far from the origin", centre, -lengths.small * 1e-2);
  }
  return list;
}

std::vector<Placement> placements_above(const Subject& a, const Subject& b, Random& random) {
  std::vector<Placement> list;
  for (int i = 0; i < 12; ++i) {
    const abut_pose on_a{{between(random, -0.3, 1) * a.size, between(random, -0.3, 1) * a.size, 0},
                         random_orientation(random)};
    const double height = 0.6 + b.size + between(random, 0, i % 3 == 0 ? a.size : 0.1);
    abut_pose local = on_a;
    local.position.z = height;
    const abut_pose pose_a =
        i % 2 == 0 ? abut_pose{{0, 0, 0}, {1, 0, 0, 0}} : random_pose(random, i % 4 == 1 ? 3 : 1e5);
    list.push_back({"apart", pose_a, composed(pose_a, local)});
  }
  return list;
}

}  // namespace property
