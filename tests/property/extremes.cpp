// SPDX-License-Identifier: Apache-2.0
#include "extremes.hpp"

#include <array>
#include <string>

#include "solid_scenes.hpp"

namespace property {

namespace {

using oracle::Vec;
using Numbers = std::vector<double>;

constexpr std::array<const char*, 10> kinds{"point",   "segment",  "triangle", "sphere",    "box",
                                            "capsule", "cylinder", "cone",     "ellipsoid", "hull"};

// The subjects of the certificates whose names begin so.
std::vector<SolidSubject> named(const std::string& beginning) {
  std::vector<SolidSubject> list;
  for (const char* kind : kinds) {
    for (SolidSubject& solid : solid_subjects(kind)) {
      if (solid.subject.name.starts_with(beginning)) list.push_back(std::move(solid));
    }
  }
  return list;
}

// As wide as a unit in every direction that the kind has.
Numbers unit_numbers(const std::string& kind) {
  if (kind == "point") return {};
  if (kind == "segment" || kind == "sphere") return {1};
  if (kind == "triangle") return {-1, -0.5, 0.125, 1, -0.5, 0.25, 0.25, 1, -0.5};
  if (kind == "box" || kind == "ellipsoid") return {1, 0.75, 0.5};
  if (kind == "capsule" || kind == "cylinder" || kind == "cone") return {0.5, 1};
  return {1, 0, 0, -1, 0.125, 0, 0.25, 1, 0, 0, -1, 0.25, 0.125, 0.25, 1, 0, 0.25, -1, 0.75, 0.75, 0.25};
}

std::vector<SolidSubject> scaled_solids(const std::string& name, double factor) {
  std::vector<SolidSubject> list;
  for (const char* kind : kinds) {
    Numbers numbers = unit_numbers(kind);
    for (double& number : numbers) number *= factor;
    list.push_back(make_solid(kind, name + " " + kind, numbers));
  }
  return list;
}

abut_pose random_pose(Random& random, double away) {
  return {moved({0, 0, 0}, random_direction(random), away), random_orientation(random)};
}

Vec random_normal(Random& random) { return oracle::unit(vec_of(random_direction(random))); }

bool has_inside(const SolidSubject& solid) {
  const std::string& kind = solid.subject.kind;
  return kind != "point" && kind != "segment" && kind != "triangle";
}

// Visits every pair of a list once.
template <typename Each>
void each_pair(const std::vector<SolidSubject>& list, const Each& each) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i; j < list.size(); ++j) each(list[i], list[j]);
  }
}

}  // namespace

std::vector<SolidSubject> plain_solids() { return named("plain "); }

void visit_size_ratio(double ratio, Random& random, const Visit& visit) {
  const double speck_size = 1e-6;
  const std::vector<SolidSubject> giants = scaled_solids("giant", ratio * speck_size);
  const std::vector<SolidSubject> specks = scaled_solids("speck", speck_size);
  for (const SolidSubject& giant : giants) {
    if (giant.subject.kind == "point") continue;
    for (const SolidSubject& speck : specks) {
      for (const double gap : {0.5, 0.0, -0.25}) {
        const abut_pose pose = random_pose(random, speck_size);
        const Vec on_face = pose_of(pose).rotate(main_direction(giant, random));
        const abut_quat turn = random_orientation(random);
        visit(giant, speck, facing("", giant, pose, speck, turn, random_normal(random), gap * speck_size, 0), {});
        visit(giant, speck, facing("", giant, pose, speck, turn, on_face, gap * speck_size, 1e-12), {});
      }
    }
  }
}

namespace {

// Across each other, nearly parallel, end to end. Needles lie along Z.
void visit_two_needles(const SolidSubject& a, const SolidSubject& b, Random& random, const Visit& visit) {
  const abut_pose pose = random_pose(random, 1);
  const Vec along_a = pose_of(pose).rotate({0, 0, 1});
  for (const double gap : {1e-7, 0.0, -5e-7}) {
    const abut_quat turn = random_orientation(random);
    const Vec along_b = pose_of(abut_pose{{0, 0, 0}, turn}).rotate({0, 0, 1});
    visit(a, b, facing("", a, pose, b, turn, oracle::unit(cross(along_a, along_b)), gap, 1e-5), {});
    const abut_pose tilted = composed(pose, {{0, 0, 0}, about(random_direction(random), 1e-6)});
    visit(a, b, facing("", a, pose, b, tilted.orientation, oracle::perpendicular(along_a), gap, 1e-5), {});
    visit(a, b, facing("", a, pose, b, pose.orientation, along_a, gap, 1e-5), {});
  }
}

// Face to face, nearly so, and the rim of one on the face of the other. Plates lie across Z.
void visit_two_plates(const SolidSubject& a, const SolidSubject& b, Random& random, const Visit& visit) {
  const abut_pose pose = random_pose(random, 1);
  const Vec up = pose_of(pose).rotate({0, 0, 1});
  for (const double gap : {1e-3, 0.0, -5e-7}) {
    const abut_pose tilted = composed(pose, {{0, 0, 0}, about(random_direction(random), 1e-6)});
    visit(a, b, facing("", a, pose, b, pose.orientation, up, gap, 1e-12), {});
    visit(a, b, facing("", a, pose, b, tilted.orientation, up, gap, 1e-5), {});
    visit(a, b, facing("", a, pose, b, random_orientation(random), up, gap, 1e-12), {});
  }
}

}  // namespace

void visit_needles(Random& random, const Visit& visit) {
  each_pair(named("needle "), [&](const auto& a, const auto& b) { visit_two_needles(a, b, random, visit); });
}

void visit_plates(Random& random, const Visit& visit) {
  const std::vector<SolidSubject> plates = named("plate ");
  each_pair(plates, [&](const auto& a, const auto& b) { visit_two_plates(a, b, random, visit); });
  for (const SolidSubject& needle : named("needle ")) {
    for (const SolidSubject& plate : plates) visit_two_plates(plate, needle, random, visit);
  }
}

void visit_far(double distance, Random& random, const Visit& visit) {
  each_pair(plain_solids(), [&](const auto& a, const auto& b) {
    const abut_pose pose = random_pose(random, distance);
    for (const double gap : {0.25, 0.0, -0.0625}) {
      visit(a, b, facing("", a, pose, b, random_orientation(random), random_normal(random), gap, 0), {});
    }
  });
}

// Faces that look along Z, one of each kind that has them.
void visit_parallel_faces(double angle, Random& random, const Visit& visit) {
  std::vector<SolidSubject> list;
  list.push_back(make_solid("triangle", "triangle", {-1, -0.75, 0, 1, -0.5, 0, 0, 1, 0}));
  list.push_back(make_solid("box", "box", {1, 0.75, 0.5}));
  list.push_back(make_solid("cylinder", "cylinder", {0.75, 0.5}));
  list.push_back(make_solid("cone", "cone", {0.75, 0.5}));
  list.push_back(make_solid("hull", "prism", {-1, -1, 0, 1, -0.75, 0, 0.25, 1, 0, -1, -1, 1, 1, -0.75, 1, 0.25, 1, 1}));
  const abut_quat over{0, 1, 0, 0};  // half a turn about X: the base of a cone comes up
  each_pair(list, [&](const auto& a, const auto& b) {
    for (const double gap : {1e-2, 0.0, -1e-2}) {
      const abut_pose pose = random_pose(random, 1);
      const abut_pose turned = composed(pose, {{0, 0, 0}, over});
      const Vec up = pose_of(pose).rotate({0, 0, 1});
      const abut_pose tilted = composed(pose, {{0, 0, 0}, about(random_direction(random), angle)});
      visit(a, b, facing("", a, turned, b, tilted.orientation, up, gap, 2 * angle + 1e-12), {});
    }
  });
}

void visit_coincident(Random& random, const Visit& visit) {
  for (const char* name : {"plain ", "needle ", "plate "}) {
    for (const SolidSubject& solid : named(name)) {
      const abut_pose pose = random_pose(random, 1);
      visit(solid, solid, {"", pose, pose}, {});
    }
  }
}

void visit_concentric(Random& random, const Visit& visit) {
  each_pair(plain_solids(), [&](const auto& a, const auto& b) {
    const abut_pose pose = random_pose(random, 1);
    visit(a, b, {"", pose, {pose.position, random_orientation(random)}}, {});
  });
}

void visit_contained(Random& random, const Visit& visit) {
  const std::vector<SolidSubject> outer = scaled_solids("outer", 1);
  for (const double size : {1e-1, 1e-3}) {
    const std::vector<SolidSubject> inner = scaled_solids("inner", size);
    for (const SolidSubject& a : outer) {
      if (!has_inside(a)) continue;
      for (const SolidSubject& b : inner) {
        const abut_pose pose = random_pose(random, 1);
        const abut_vec3 place = moved(pose.position, random_direction(random), 0.125);
        visit(a, b, {"", pose, {place, random_orientation(random)}}, {});
      }
    }
  }
}

void visit_zero_size(Random& random, const Visit& visit) {
  std::vector<SolidSubject> zero = named("shrunk ");
  zero.push_back(make_solid("point", "point", {}));
  zero.push_back(make_solid("box", "shrunk box", {0, 0, 0}));
  zero.push_back(make_solid("hull", "shrunk hull", {0.25, 0.5, 0.75, 0.25, 0.5, 0.75, 0.25, 0.5, 0.75}));
  each_pair(zero, [&](const auto& a, const auto& b) {
    const abut_pose pose = random_pose(random, 1);
    for (const double gap : {0.25, 0.0}) {
      visit(a, b, facing("", a, pose, b, random_orientation(random), random_normal(random), gap, 0), {});
    }
  });
  for (const SolidSubject& solid : plain_solids()) {
    for (const SolidSubject& speck : zero) {
      const abut_pose pose = random_pose(random, 1);
      for (const double gap : {0.25, 0.0, -0.0625}) {
        visit(solid, speck, facing("", solid, pose, speck, random_orientation(random), random_normal(random), gap, 0),
              {});
      }
    }
  }
}

}  // namespace property
