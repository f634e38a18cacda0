// SPDX-License-Identifier: Apache-2.0
#include "random_pairs.hpp"

#include <array>

namespace bench {
namespace {

// Its orientation applied to z: the way out of a plane.
Point up(const std::array<double, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

}  // namespace

std::vector<Solid> random_solids(Kind kind, std::size_t count, Random& random) {
  std::vector<Solid> solids;
  if (is_surface(kind)) {
    solids.push_back(terrain(kind, random));
    return solids;
  }
  for (std::size_t i = 0; i < count; ++i) {
    solids.push_back(random_solid(kind, random));
    if (is_hull(kind)) {
      find_surface(solids.back());
    }
  }
  return solids;
}

namespace {

// Above a terrain or in it, well within its border.
Case case_on_terrain(const Solid& surface, std::span<const Solid> solids, Random& random) {
  Case one{0, random.below(solids.size()), {}, {}};
  const auto side = static_cast<std::size_t>(surface.sizes[0]);
  const Point& sample =
      surface.points[(side / 8 + random.below(side * 3 / 4)) * side + side / 8 + random.below(side * 3 / 4)];
  const double above = random.uniform(0, 1.2) * bounding_radius(solids[one.b]);
  one.pose_b = {{sample[0], sample[1], sample[2] + above}, random.orientation()};
  return one;
}

}  // namespace

Case random_case(std::span<const Solid> solids_a, std::span<const Solid> solids_b, Random& random) {
  if (is_surface(solids_a.front().kind)) {
    return case_on_terrain(solids_a.front(), solids_b, random);
  }
  Case one{random.below(solids_a.size()), random.below(solids_b.size()), {}, {}};
  const Solid& a = solids_a[one.a];
  const Point centre{random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)};
  one.pose_a = {centre, random.orientation()};
  const Point any = random.direction();
  const Point direction = a.kind == Kind::plane ? up(one.pose_a.orientation) : any;
  const double reach = bounding_radius(a) + bounding_radius(solids_b[one.b]);
  const double apart = random.uniform(0, 1.5) * reach;
  one.pose_b = {{centre[0] + apart * direction[0], centre[1] + apart * direction[1], centre[2] + apart * direction[2]},
                random.orientation()};
  return one;
}

void give_motion(Case& one, double reach, Random& random) { give_motion(one, one.pose_a.position, reach, random); }

void give_motion(Case& one, const Point& aim, double reach, Random& random) {
  const Point aside = random.direction();
  const double way = random.uniform(1, 2), miss = random.uniform(0, 0.7) * reach;
  for (std::size_t i = 0; i < 3; ++i) {
    one.motion[i] = way * (aim[i] - one.pose_b.position[i]) + miss * aside[i];
  }
}

}  // namespace bench
