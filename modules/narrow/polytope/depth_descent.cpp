module abut.narrow.polytope.depth_descent;
import abut.capability.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;

namespace abut {
namespace {

[[nodiscard]] inline Real length_of(Real x, Real y) { return std::sqrt(x * x + y * y); }

// Directions across which the second-order model bends most and least, and by how much.
struct Bends {
  Real stiff, soft;
  Move along_stiff, along_soft;  // of length one
};
[[nodiscard]] Bends bends_of(const PairGerm& germ) {
  const Real xx = germ.a.xx + germ.b.xx - germ.point.n, xy = germ.a.xy + germ.b.xy,
             yy = germ.a.yy + germ.b.yy - germ.point.n;
  const Real mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), spread = std::sqrt(half * half + xy * xy);
  const Move along = half >= 0 ? Move{half + spread, xy} : Move{xy, spread - half};
  const Real length = length_of(along.x, along.y);
  const Move unit = length > 0 ? Move{along.x / length, along.y / length} : Move{1, 0};
  return {mean + spread, mean - spread, unit, {-unit.y, unit.x}};
}

constexpr Real stiff_share = 1e-3;  // of the depth: less bend than that makes no valley

// The points of both cores under a direction, seen from where the cores are apart along it.
void find_points_under(const Difference& cores, Real error, EpaResult& found) {
  const Real apart = 0.25 * cores.size;
  const Vec3 shift = (found.depth + apart) * found.normal;
  const auto shifted = [&](const Vec3& direction) {
    SupportPair pair = cores.support(direction);
    pair.b += shift;
    return pair;
  };
  Difference parted;
  parted.support = [&shifted](const Vec3& direction) { return shifted(direction); };
  parted.size = cores.size + norm(shift);
  const WideGjkResult near = wide_gjk(parted, found.normal, error, infinity, error);
  if (near.gjk.overlap) {
    return;
  }
  const Vec3 on_b = near.point_b - shift;
  // What is left between the points and the depth is shared by both.
  const Vec3 half = (0.5 * (found.depth + dot(on_b - near.point_a, found.normal))) * found.normal;
  found.point_a = near.point_a + half;
  found.point_b = on_b - half;
}

}  // namespace

Valley valley_of(const PairGerm& germ, Real radius) {
  const InFrame& r = germ.point;
  Valley valley{{0, 0}, {1, 0}};
  Real deepest = -1, steepest = 0;
  for (std::size_t i = 0; i < germ.step_count(); ++i) {
    const InFrame& u = germ.step(i);
    const Real length = length_of(u.x, u.y);
    if (!(length > 0)) {
      continue;
    }
    // The depth falls up to the crease and rises beyond it.
    const Real away = -u.n / length, fall = -(r.x * u.x + r.y * u.y) / length, rise = length - fall;
    if (!(std::fabs(away) < radius) || fall < 0 || rise < 0) {
      continue;
    }
    if (const Real drop = away > 0 ? away * fall : -away * rise; drop > deepest) {
      deepest = drop;
      valley.to_bottom = {away * u.x / length, away * u.y / length};
    }
    if (const Real steep = std::fmin(fall, rise); steep >= steepest) {
      steepest = steep;
      valley.along = {-u.y / length, u.x / length};
    }
  }
  if (deepest >= 0) {
    return valley;
  }
  const Bends bends = bends_of(germ);
  valley.along = bends.along_soft;
  if (bends.stiff > stiff_share * r.n) {
    const Move& across = bends.along_stiff;
    const Real stride = std::clamp(-(r.x * across.x + r.y * across.y) / bends.stiff, -radius, radius);
    valley.to_bottom = {stride * across.x, stride * across.y};
  }
  return valley;
}

void collect_moves(const PairGerm& germ, Real length, Moves& moves) {
  moves.clear();
  const InFrame& r = germ.point;
  const auto add_against = [&](Real x, Real y) {
    if (const Real slope = length_of(x, y); slope > 0) {
      moves.push_back({-length * x / slope, -length * y / slope});
    }
  };
  add_against(r.x, r.y);
  const Move soft = bends_of(germ).along_soft;
  moves.push_back({length * soft.x, length * soft.y});
  moves.push_back({-length * soft.x, -length * soft.y});
  for (std::size_t i = 0; i < germ.step_count(); ++i) {
    const InFrame& u = germ.step(i);
    const Real size = length_of(u.x, u.y);
    if (!(std::fabs(u.n) < length * size)) {
      continue;
    }
    const Move at{-u.n / size * (u.x / size), -u.n / size * (u.y / size)};
    const Move along{-length * u.y / size, length * u.x / size};
    moves.push_back(at);
    moves.push_back({at.x + along.x, at.y + along.y});
    moves.push_back({at.x - along.x, at.y - along.y});
    add_against(r.x + u.x, r.y + u.y);
  }
}

[[nodiscard]] inline Vec3 moved(const GermFrame& frame, const Move& move) {
  return UnitVec3::make(frame.n + move.x * frame.x + move.y * frame.y).value_or(UnitVec3::axis_z()).vec();
}

constexpr int descent_rounds = 40, corrections = 6;
constexpr Real first_stride = 0.5, least_stride = 1e-9, settled_stride = 1e-14;

Descent descend(const Difference& cores, const Vec3& from, Real error, Real noise) {
  const Real step = error / 64;  // less than this is no progress
  Descent here{from, cores.depth_along(from), std::nullopt};
  Real radius = first_stride;
  for (int round = 0; round < descent_rounds && radius > least_stride; ++round) {
    const GermFrame frame = frame_along(here.normal);
    const PairGerm germ = cores.germ(frame);
    Stride stride;
    const bool is_modelled = weighed_stride(germ, noise, error / 16, stride);
    if (is_modelled && error_of_foot(germ, stride) <= error / 16) {
      here.minimum = points_at(frame, germ, stride);
      return here;
    }
    Descent next{here.normal, here.depth - step, std::nullopt};
    bool is_lower = false;
    const auto try_move = [&](const Move& move) {
      Vec3 n = moved(frame, move);
      for (int correction = 0; correction < corrections; ++correction) {
        if (const Real depth = cores.depth_along(n); depth < next.depth) {
          next = {n, depth, std::nullopt};
          is_lower = true;
        }
        const GermFrame there = frame_along(n);
        const Move back = valley_of(cores.germ(there), radius).to_bottom;
        if (std::fabs(back.x) + std::fabs(back.y) < settled_stride) {
          break;
        }
        n = moved(there, back);
      }
    };
    if (is_modelled) {
      const Real shorten = stride.square > radius * radius ? radius / std::sqrt(stride.square) : 1;
      try_move({shorten * stride.x, shorten * stride.y});
    }
    if (!is_lower) {
      [[clang::uninitialized]] Moves moves;
      collect_moves(germ, radius, moves);
      for (const Move& move : moves.span()) {
        try_move(move);
      }
    }
    if (is_lower) {
      here = next;
    }
    radius = is_lower ? std::fmin(first_stride, 2 * radius) : 0.25 * radius;
  }
  return here;
}

constexpr int walk_steps = 32;
constexpr Real walk_stride = 0.2;

void walk_valley(const Difference& cores, const Vec3& from, const std::function<bool(const Vec3&)>& visit) {
  Vec3 n = from, ahead{0, 0, 0};
  for (int step = 0; step < walk_steps; ++step) {
    const GermFrame frame = frame_along(n);
    const Move along = valley_of(cores.germ(frame), walk_stride).along;
    const Real side = dot(along.x * frame.x + along.y * frame.y, ahead) < 0 ? -walk_stride : walk_stride;
    Vec3 next = moved(frame, {side * along.x, side * along.y});
    for (int correction = 0; correction < corrections; ++correction) {
      const GermFrame there = frame_along(next);
      next = moved(there, valley_of(cores.germ(there), walk_stride).to_bottom);
    }
    ahead = next - n;
    n = next;
    const bool is_around = step > 2 && dot(n, from) > 1 - 0.5 * walk_stride * walk_stride;
    if (is_around || !visit(n)) {
      return;
    }
  }
}

constexpr int sweep_reach = 2;
constexpr std::size_t sweep_size = 98, descent_limit = 8;
constexpr Real valley_share = 1e-3;  // of the depth, by which the bottom of a valley may rise
constexpr Real same_start = 0.9;     // cosine between directions that need not both be tried

EpaResult least_of_descents(const Difference& cores, Real error, const EpaResult& found) {
  const Real noise = cores.noise();
  Descent least{found.normal, infinity, std::nullopt};
  const auto keep = [&](const Descent& tried) {
    // Of equal depths the one whose points are known.
    const bool is_better = tried.minimum && !least.minimum ? tried.depth < least.depth + error / 16
                                                           : tried.depth < least.depth - error / 16;
    if (is_better || !(least.depth < infinity)) {
      least = tried;
    }
  };
  [[clang::uninitialized]] SmallVector<Vec3, descent_limit + 1> starts;
  const auto descend_from = [&](const Vec3& n) {
    for (const Vec3& start : starts.span()) {
      if (dot(start, n) > same_start) {
        return;
      }
    }
    starts.push_back(n);
    keep(descend(cores, n, error, noise));
  };
  descend_from(found.normal);
  const SymmetricDirections symmetries = cores.symmetries();
  for (const Vec3& axis : symmetries.discs.span()) {
    keep({axis, cores.depth_along(axis), points_under(cores, axis, error, noise)});
  }
  // A flat or slender core bends within so few directions that only its own axes lead there.
  for (const Vec3& axis : cores.axes) {
    for (const Vec3& n : {axis, -axis}) {
      if (cores.depth_along(n) < least.depth * (1 + valley_share)) {
        keep(descend(cores, n, error, noise));
      }
    }
  }
  // Toward the points on the surface of a cubic grid.
  [[clang::uninitialized]] SmallVector<Vec3, sweep_size> directions;
  [[clang::uninitialized]] SmallVector<Real, sweep_size> depths;
  for (int x = -sweep_reach; x <= sweep_reach; ++x) {
    for (int y = -sweep_reach; y <= sweep_reach; ++y) {
      for (int z = -sweep_reach; z <= sweep_reach; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == sweep_reach) {
          const Vec3 toward{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
          directions.push_back((1 / norm(toward)) * toward);
          depths.push_back(cores.depth_along(directions[directions.size() - 1]));
        }
      }
    }
  }
  while (starts.size() < descent_limit) {
    const auto least_of_sweep = std::ranges::min_element(depths.span());
    if (!(*least_of_sweep < infinity)) {
      break;
    }
    descend_from(directions[static_cast<std::size_t>(least_of_sweep - depths.span().begin())]);
    *least_of_sweep = infinity;
  }
  // A valley may have more low places than the sweep has found, where the other core has corners.
  const Descent first = least;
  walk_valley(cores, first.normal, [&](const Vec3& n) {
    const Real depth = cores.depth_along(n);
    const bool is_low = depth < first.depth * (1 + valley_share);
    if (is_low) {
      keep(descend(cores, n, error, noise));
    }
    return is_low;
  });
  EpaResult better = found;
  better.normal = least.normal;
  better.depth = better.upper = least.depth;
  if (least.minimum) {
    better.point_a = least.minimum->point_a;
    better.point_b = better.point_a - least.depth * least.normal;
  } else {
    find_points_under(cores, error, better);
  }
  better.lower = std::fmin(found.lower, better.depth);
  return better;
}

}  // namespace abut
