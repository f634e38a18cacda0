// SPDX-License-Identifier: Apache-2.0
#include "solid_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/support.hpp"

namespace property {

namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

constexpr abut_quat no_turn{1, 0, 0, 0};

}  // namespace

Placement facing(const std::string& scene, const SolidSubject& a, const abut_pose& pose_a, const SolidSubject& b,
                 const abut_quat& turn_b, const Vec& n, double gap, double slack) {
  const oracle::Pose at_a = pose_of(pose_a);
  oracle::Pose at_b = pose_of(abut_pose{{0, 0, 0}, turn_b});
  const Vec on_a = at_a.place(support_point(a.solid, at_a.rotate_back(n), quad(slack)));
  const Vec on_b = at_b.place(support_point(b.solid, at_b.rotate_back(-n), quad(slack)));
  at_b.position = on_a - on_b;
  const Quad overlap = overlap_along(a.solid, at_a, b.solid, at_b, n);
  return {scene, pose_a, {rounded(at_b.position + n * (overlap + quad(gap))), turn_b}};
}

Vec main_direction(const SolidSubject& subject, Random& random) {
  const std::vector<Vec>& normals = subject.solid.normals;
  const Vec normal = normals[random() % normals.size()];
  return random() % 2 == 0 ? normal : -normal;
}

namespace {

struct Maker {
  const SolidSubject& a;
  const SolidSubject& b;
  Random& random;
  std::vector<Placement>& list;
  double reach;  // beyond this the shapes are apart
  double small;  // of the smaller shape

  [[nodiscard]] abut_pose random_pose(double distance) {
    return {moved({0, 0, 0}, random_direction(random), distance), random_orientation(random)};
  }

  void add_facing(const std::string& scene, const abut_pose& pose_a, const abut_quat& turn_b, const Vec& n, double gap,
                  double slack) {
    list.push_back(facing(scene, a, pose_a, b, turn_b, n, gap, slack));
  }

  // Random orientations, `gap` between the surfaces, near `centre`.
  void add_at_gap(const std::string& scene, const abut_vec3& centre, double gap) {
    const abut_pose pose_a{centre, random_orientation(random)};
    const Vec n = oracle::unit(vec_of(random_direction(random)));
    add_facing(scene, pose_a, random_orientation(random), n, gap, 0);
  }

  // The middle of a face or side of a against what b turns to it.
  void add_on_face(const std::string& scene, double gap) {
    const abut_pose pose_a = random_pose(small);
    add_facing(scene, pose_a, random_orientation(random), pose_of(pose_a).rotate(main_direction(a, random)), gap,
               1e-12);
  }

  // Orientations that differ by a quarter turn or none, and by a small angle.
  void add_aligned(const std::string& scene, double angle, double gap, bool quarter) {
    const abut_pose pose_a = random_pose(small);
    const std::array<abut_vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    abut_pose local{{0, 0, 0}, about(random_direction(random), angle)};
    if (quarter) local = composed({{0, 0, 0}, about(axes.at(random() % 3), std::acos(0.0))}, local);
    const abut_quat turn_b = composed(pose_a, local).orientation;
    add_facing(scene, pose_a, turn_b, pose_of(pose_a).rotate(main_direction(a, random)), gap, 2 * angle + 1e-12);
  }

  void add_deep() {
    const abut_pose pose_a = random_pose(reach);
    const double away = small * between(random, 0.05, 0.8);
    list.push_back(
        {"deep", pose_a, {moved(pose_a.position, random_direction(random), away), random_orientation(random)}});
  }

  void add_concentric() {
    const abut_pose pose_a = random_pose(reach);
    list.push_back({"coincident", pose_a, pose_a});
    list.push_back({"coincident", {{0, 0, 0}, no_turn}, {{0, 0, 0}, no_turn}});
    list.push_back({"concentric", pose_a, {pose_a.position, random_orientation(random)}});
  }
};

}  // namespace

std::vector<Placement> solid_placements(const SolidSubject& a, const SolidSubject& b, Random& random) {
  std::vector<Placement> list;
  const double sum = a.subject.size + b.subject.size;
  const double reach = sum > 0 ? sum : 1;
  Maker make{a, b, random, list, reach, std::min({a.subject.small, b.subject.small, reach})};
  make.add_at_gap("apart", {0, 0, 0}, make.reach * between(random, 0.01, 3));
  make.add_at_gap("far apart", {0, 0, 0}, make.reach * 100);
  make.add_at_gap("grazing", {0, 0, 0}, make.small * 1e-9);
  make.add_at_gap("touching", {0, 0, 0}, 0);
  make.add_at_gap("shallow", {0, 0, 0}, -make.small * 1e-9);
  make.add_at_gap("shallow", {0, 0, 0}, -make.small * 1e-3);
  make.add_on_face("grazing", make.small * 1e-2);
  make.add_on_face("touching", 0);
  make.add_on_face("shallow", -make.small * 1e-2);
  make.add_deep();
  make.add_concentric();
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
    const bool quarter = random() % 2 == 0;
    make.add_aligned("parallel", angle, make.small * 1e-2, quarter);
    make.add_aligned("parallel touching", angle, 0, !quarter);
    make.add_aligned("parallel overlapping", angle, -make.small * 1e-2, quarter);
  }
  for (const double far : {1e5, 1e7}) {
    const abut_vec3 centre = moved({0, 0, 0}, random_direction(random), far);
    make.add_at_gap("far from the origin", centre, make.small * between(random, 0.1, 1));
    make.add_at_gap("far from the origin", centre, -make.small * 1e-2);
  }
  return list;
}

}  // namespace property
