module abut.narrow.polytope.capped_epa;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.direction_cover;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;
import abut.narrow.polytope;

namespace abut {
namespace {

constexpr std::size_t cap_limit = 12;
// After so many vertices caps are also looked for from where the depth is larger by up to this factor: where many
// directions are as good, a polytope alone proves none of them.
constexpr std::uint32_t patience = 30;
constexpr Real near_least = 1.25;
using Caps = SmallVector<DepthMinimum, cap_limit>;

// Beside a giant the bound of the search is no small part of a speck: the minimum found within it may be that of other
// features.
constexpr Real speck_share = 1e-6;

// The points under one triangle of a polytope need not lie across each other; those of the minimum near its normal do.
[[nodiscard]] EpaResult polished(const Difference& cores, Real error, const EpaResult& found) {
  return with_points(cores, error, found).value_or(found);
}

// Of bodies of revolution around one axis, along the outlines. Nothing for others, or where no points are found under
// the normal.
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
  return points_under(cores, *unit, error, noise);
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
  // A depth that is not the overlap along its normal comes from a minimum that went astray: the polytope alone decides
  // then.
  const auto judged = [&](const EpaResult& found) {
    const bool is_overlap = cores.depth_along(found.normal) <= found.depth + error + noise;
    return is_overlap ? found : polished(cores, error, epa(cores, error, start));
  };
  const SymmetricDirections symmetries = cores.symmetries();
  if (const auto found = coaxial_minimum(cores, symmetries, error, noise)) {
    return judged({found->depth, found->depth, found->upper, found->normal, found->point_a, found->point_b, 1});
  }
  EpaResult result{0, -infinity, infinity, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, 0};

  [[clang::uninitialized]] Caps caps;
  [[clang::uninitialized]] DirectionCover cover;
  cores.add_balls(noise, cover);
  std::size_t best = cap_limit;
  const auto keep = [&](const std::optional<DepthMinimum>& found) {
    if (!found) {
      return false;
    }
    for (const DepthMinimum& cap : caps.span()) {
      if (dot(cap.normal, found->normal) > 1 - 1e-9 && cap.cosine <= found->cosine) {
        return false;
      }
    }
    if (found->upper < result.upper) {
      result.upper = found->upper;
      best = caps.size();
      cover.set_depth(found->upper);
    }
    caps.push_back(*found);
    cover.add(found->normal, found->cosine);
    return true;
  };
  const auto descend = [&](const Vec3& from) { return keep(minimum_near(cores, from, error, noise)); };

  for (const Vec3& axis : symmetries.discs.span()) {
    if (cores.depth_along(axis) < result.upper) {
      keep(minimum_on_disc(cores, axis, error, noise));
    }
  }
  // From where the search for a common point has ended.
  if (start.size == 4) {
    const auto toward = UnitVec3::make(closest_on_faces(start).point);
    if (toward && cores.depth_along(*toward) < result.upper) {
      descend(*toward);
    }
  }

  const auto answer = [&](Real lower) {
    const DepthMinimum& least = caps[best];
    result.lower = lower;
    for (const DepthMinimum& cap : caps.span()) {
      result.lower = cap.lower < result.lower ? cap.lower : result.lower;
    }
    result.normal = least.normal;
    result.depth = least.depth;
    result.point_a = least.point_a;
    result.point_b = least.point_b;
    result.lower = result.lower < result.depth ? result.lower : result.depth;
    return result;
  };
  if (cover.is_whole()) {
    return judged(answer(infinity));
  }

  // Out of line, as all that has a polytope. The lower bound where all directions are proven.
  const auto search_outside = [&]() __attribute__((noinline)) -> std::optional<Real> {
    [[clang::uninitialized]] Polytope polytope;
    polytope.reset();
    Simplex first = start;
    if (best < caps.size()) {
      // The foot of the minimum, and what reaches furthest around the other side.
      const DepthMinimum& top = caps[best];
      const Tangents across = tangents_of(top.normal);
      first.size = 0;
      first.push({top.depth * top.normal, top.point_a, no_index, no_index});
      constexpr std::array<std::array<Real, 2>, 3> around{{{1, 0}, {-0.5, 0.866}, {-0.5, -0.866}}};
      for (const auto& [x, y] : around) {
        first.push(cores.vertex_toward(x * across.first + y * across.second - 0.4 * top.normal));
      }
    }
    const FlatDifference flat = polytope.start(first, noise, cores);
    if (flat.is_flat) {
      return std::nullopt;
    }
    for (std::uint32_t iteration = 1; iteration <= Polytope::vertex_limit; ++iteration) {
      result.iterations = iteration;
      std::size_t face = polytope.least_face();
      while (polytope.distance(face) < result.upper - error &&
             cover.holds(polytope.normal(face), (polytope.distance(face) - noise) / result.upper)) {
        polytope.hide(face);
        face = polytope.least_face();
      }
      if (polytope.distance(face) >= result.upper - error) {
        return best < caps.size() ? std::optional(polytope.distance(face)) : std::nullopt;
      }
      const Vec3 normal = polytope.normal(face);
      const DifferenceVertex vertex = cores.vertex_toward(normal);
      const Real reach = dot(normal, vertex.w);
      const bool may_be_least =
          reach < result.upper + error || (iteration > patience && reach < near_least * result.upper);
      if (caps.size() < cap_limit && may_be_least && descend(normal)) {
        // The foot of the minimum, where it is in sight, is worth more than the end of the body.
        const DepthMinimum& top = caps[caps.size() - 1];
        const Vec3 foot = top.depth * top.normal;
        const bool is_seen = dot(normal, foot) > polytope.distance(face) + noise;
        if (!polytope.expand(face, is_seen ? DifferenceVertex{foot, top.point_a, no_index, no_index} : vertex, noise)) {
          break;
        }
        continue;
      }
      if (reach - polytope.distance(face) <= noise || polytope.contains(vertex) ||
          !polytope.expand(face, vertex, noise)) {
        break;
      }
    }
    return std::nullopt;
  };
  const std::optional<Real> lower = search_outside();
  return lower ? judged(answer(*lower)) : polished(cores, error, epa(cores, error, start));
}

}  // namespace abut
