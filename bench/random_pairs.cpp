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
  for (std::size_t i = 0; i < count; ++i) {
    solids.push_back(random_solid(kind, random));
    if (is_hull(kind)) {
      find_surface(solids.back());
    }
  }
  return solids;
}

Case random_case(std::span<const Solid> solids_a, std::span<const Solid> solids_b, Random& random) {
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

}  // namespace bench
