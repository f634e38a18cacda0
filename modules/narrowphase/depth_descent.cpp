module abut.narrowphase.depth_descent;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.depth_minimum;
import abut.shape;
import abut.shape.germ;

namespace abut {
namespace {

[[nodiscard]] inline Real length_of(Real x, Real y) { return std::sqrt(x * x + y * y); }

// Directions across which the second-order model bends most and least, and by how much.
struct Bends {
  Real stiff, soft;
  Move along_stiff, along_soft;  // of length one
};
[[nodiscard]] Bends bends_of(const PairGerm& germ) {
  const Real xx = germ.a.xx + germ.b.xx - germ.point.n, xy = germ.a.xy + germ.b.xy, yy = germ.a.yy + germ.b.yy - germ.point.n;
  const Real mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), spread = std::sqrt(half * half + xy * xy);
  const Move along = half >= 0 ? Move{half + spread, xy} : Move{xy, spread - half};
  const Real length = length_of(along.x, along.y);
  const Move unit = length > 0 ? Move{along.x / length, along.y / length} : Move{1, 0};
  return {mean + spread, mean - spread, unit, {-unit.y, unit.x}};
}

constexpr Real stiff_share = 1e-3;  // of the depth: less bend than that makes no valley

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

}  // namespace abut
