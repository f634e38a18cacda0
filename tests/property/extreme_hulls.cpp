// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "extremes.hpp"
#include "solid_scenes.hpp"

namespace property {

namespace {

using oracle::Vec;
using Numbers = std::vector<double>;

const std::vector<double>& cube() {
  static const Numbers corners{-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5,
                               -0.5, -0.5, 0.5,  0.5, -0.5, 0.5,  -0.5, 0.5, 0.5,  0.5, 0.5, 0.5};
  return corners;
}

// Points of a unit circle that lies in a slanting plane to within rounding.
Numbers slanting_polygon(int corners) {
  Numbers numbers;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    numbers.insert(numbers.end(), {x, 0.8 * y, 0.6 * y});
  }
  return numbers;
}

Numbers joined(Numbers first, const Numbers& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Numbers shaken(Numbers numbers, double by, Random& random) {
  for (double& number : numbers) number += between(random, -by, by);
  return numbers;
}

// Against every plain solid at each gap along a direction at random.
void visit_hulls(const std::vector<SolidSubject>& hulls, const Numbers& gaps, Random& random, const Visit& visit) {
  const std::vector<SolidSubject> others = plain_solids();
  for (const SolidSubject& hull : hulls) {
    for (const SolidSubject& other : others) {
      for (const double gap : gaps) {
        const abut_pose pose{random_direction(random), random_orientation(random)};
        const Vec n = oracle::unit(vec_of(random_direction(random)));
        visit(hull, other, facing("", hull, pose, other, random_orientation(random), n, gap, 0), {});
      }
    }
  }
}

}  // namespace

void visit_flat_hulls(Random& random, const Visit& visit) {
  std::vector<SolidSubject> hulls;
  hulls.push_back(make_solid("hull", "point hull", {0.25, 0.5, 0.75}));
  hulls.push_back(make_solid("hull", "segment hull", {-0.5, 0, 0.25, 0.7, 0.3, 0.1}));
  hulls.push_back(
      make_solid("hull", "collinear hull", {0, 0, 0, 1, 1, 1, 0.5, 0.5, 0.5, 0.1, 0.1, 0.1, 0.7, 0.7, 0.7}));
  hulls.push_back(make_solid("hull", "triangle hull", {0, 0, 0, 1, 0.25, 0.5, -0.25, 1, 0.75}));
  hulls.push_back(make_solid("hull", "square hull", {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0}));
  hulls.push_back(make_solid("hull", "polygon hull", slanting_polygon(7)));
  visit_hulls(hulls, {0.25, 0, -0.0625}, random, visit);
  for (const SolidSubject& a : hulls) {
    for (const SolidSubject& b : hulls) {
      const abut_pose pose{random_direction(random), random_orientation(random)};
      visit(a, b, {"", pose, {pose.position, random_orientation(random)}}, {});
    }
  }
}

void visit_sliver_hulls(Random& random, const Visit& visit) {
  std::vector<SolidSubject> hulls;
  for (const double height : {1e-6, 1e-9, 1e-12, 1e-15}) {
    hulls.push_back(make_solid("hull", "sliver of four", {-1, -0.5, 0, 1, -0.5, 0, 0.25, 1, 0, 0.125, 0.25, height}));
    hulls.push_back(make_solid("hull", "bent square", {-1, -1, 0, 1, -1, height, -1, 1, height, 1, 1, 0}));
    hulls.push_back(make_solid("hull", "thin triangle", {-1, 0, 0, 1, 0, 0, 0.25, height, 0}));
  }
  visit_hulls(hulls, {0.25, 0, -0.0625}, random, visit);
}

void visit_repeating_hulls(Random& random, const Visit& visit) {
  std::vector<SolidSubject> hulls;
  hulls.push_back(make_solid("hull", "cube three times", joined(cube(), joined(cube(), cube()))));
  for (const double by : {1e-16, 1e-15, 1e-12, 1e-9, 1e-6}) {
    hulls.push_back(make_solid("hull", "cube and nearly the same", joined(cube(), shaken(cube(), by, random))));
  }
  visit_hulls(hulls, {0.25, 0, -0.0625}, random, visit);
}

namespace {

constexpr int many = 10'000;

Numbers ball_of_many(Random& random) {
  Numbers numbers;
  for (int i = 0; i < many; ++i) {
    const abut_vec3 p = random_direction(random);
    numbers.insert(numbers.end(), {p.x, 0.9 * p.y, 0.8 * p.z});
  }
  return numbers;
}

// Two faces of 5,000 corners each.
Numbers drum_of_many() {
  Numbers numbers;
  for (int i = 0; i < many; ++i) {
    const double angle = 4 * std::numbers::pi * i / many;
    numbers.insert(numbers.end(), {std::cos(angle), std::sin(angle), i < many / 2 ? -0.5 : 0.5});
  }
  return numbers;
}

// All inside or on a cube, many of them in its faces.
Numbers cube_of_many(Random& random) {
  Numbers numbers = cube();
  for (int i = static_cast<int>(cube().size()) / 3; i < many; ++i) {
    Numbers p{between(random, -0.5, 0.5), between(random, -0.5, 0.5), between(random, -0.5, 0.5)};
    p[random() % 3] = random() % 2 == 0 ? -0.5 : 0.5;
    numbers.insert(numbers.end(), p.begin(), p.end());
  }
  return numbers;
}

}  // namespace

void visit_large_hulls(Random& random, const Visit& visit) {
  std::vector<SolidSubject> hulls;
  hulls.push_back(make_solid("hull", "ball of 10000", ball_of_many(random)));
  hulls.push_back(make_solid("hull", "drum of 10000", drum_of_many()));
  hulls.push_back(make_solid("hull", "cube of 10000", cube_of_many(random)));
  visit_hulls(hulls, {0.25, 0}, random, visit);
}

}  // namespace property
