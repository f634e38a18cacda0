module abut.narrow.polytope.capped_epa;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;

namespace abut {
namespace {

// Beside a giant the bound of the search is no small part of a speck: the minimum found within it may be that of other
// features.
constexpr Real speck_share = 1e-6;

// The least depth of bodies of revolution around one axis, across their outlines. Nothing for others, or where no
// points under the normal overlap by it.
[[nodiscard]] std::optional<DepthMinimum> coaxial_minimum(const Difference& cores,
                                                          const SymmetricDirections& symmetries, Real error,
                                                          Real noise) {
  Vec3 best{0, 0, 0};
  Real least = infinity;
  for (const Vec3& n : symmetries.outlines.span()) {
    if (const Real depth = cores.depth_along(n); depth < least) {
      least = depth;
      best = n;
    }
  }
  const auto unit = UnitVec3::make(best);
  if (!unit || !(least > noise)) {
    return std::nullopt;
  }
  const auto found = points_under(cores, *unit, error, noise);
  const bool is_overlap = found && cores.depth_along(found->normal) <= found->depth + error + noise;
  return is_overlap ? found : std::nullopt;
}

}  // namespace

std::optional<EpaResult> with_points(const Difference& cores, Real error, const EpaResult& found) {
  const Real noise = cores.noise();
  const auto is_same = [&](const std::optional<DepthMinimum>& minimum) {
    return minimum && std::fabs(minimum->depth - found.depth) <= error;
  };
  EpaResult better = found;
  if (const auto under = points_under(cores, found.normal, error, noise); is_same(under)) {
    better.point_a = under->point_a;
    better.point_b = under->point_a - found.depth * found.normal;
  } else if (error > speck_share * cores.least_extent) {
    return std::nullopt;
  } else if (const auto near = minimum_near(cores, found.normal, error, noise); is_same(near)) {
    better.normal = near->normal;
    better.depth = near->depth;
    better.upper = near->upper;
    better.lower = found.lower < near->depth ? found.lower : near->depth;
    better.point_a = near->point_a;
    better.point_b = near->point_b;
  } else {
    return std::nullopt;
  }
  return better;
}

EpaResult capped_epa(const Difference& cores, Real error, const Simplex& start) {
  const Real noise = cores.noise();
  const SymmetricDirections symmetries = cores.symmetries();
  if (const auto found = coaxial_minimum(cores, symmetries, error, noise)) {
    return {found->depth, found->depth, found->upper, found->normal, found->point_a, found->point_b, 1};
  }
  return epa(cores, error, start);
}

}  // namespace abut
