module abut.narrow.polytope.depth_minimum;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;

namespace abut {
namespace {

// A symmetric matrix across a direction.
struct Form {
  Real xx, xy, yy;
  [[nodiscard]] inline Real along(Real x, Real y) const { return x * x * xx + 2 * x * y * xy + y * y * yy; }
  // Its least value on vectors of length one.
  [[nodiscard]] inline Real least() const { return 0.5 * (xx + yy - std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy)); }
  // Whether that is no less than a number.
  [[nodiscard]] inline bool is_at_least(Real value) const {
    const Real x = xx - value, y = yy - value;
    return x + y >= 0 && x * y >= xy * xy;
  }
  // What surely is left of it in a cap, or the ball where there is one, which loses nothing.
  inline void add_bound(Real factor, const Germ& germ, Real reach) {
    if (germ.ball > 0) {
      xx += factor * germ.ball;
      yy += factor * germ.ball;
    } else {
      add(factor * stiffness_at(germ, reach), germ);
    }
  }
  inline void add(Real factor, const Germ& germ) {
    xx += factor * germ.xx;
    xy += factor * germ.xy;
    yy += factor * germ.yy;
  }
};

// Caps that are tried, by the tangent t of their angle, and (1 + sqrt(1 + t^2)) / t.
struct Reach {
  Real tangent, ends;
};
constexpr std::array<Reach, 16> reaches{{{399.99, 1.002503},
                                         {199.99, 1.005012},
                                         {39.9875, 1.025320},
                                         {9.95, 1.105540},
                                         {4.8, 1.229804},
                                         {3.4286, 1.333330},
                                         {2.4, 1.500000},
                                         {1.5, 1.868517},
                                         {1, 2.414213},
                                         {0.75, 3.000000},
                                         {0.5, 4.236067},
                                         {0.25, 8.123105},
                                         {0.1, 20.049875},
                                         {0.05, 40.024984},
                                         {0.02, 100.009999},
                                         {0.01, 200.004999}}};

constexpr Real share_slack = 1e-9;
[[nodiscard]] inline bool is_share(Real share) { return share >= -share_slack && share <= 1 + share_slack; }
[[nodiscard]] inline Real clamped(Real share) { return share < 0 ? 0 : share > 1 ? 1 : share; }

constexpr int minimum_rounds = 12;

}  // namespace

Weights weights_of(const PairGerm& germ, const Stride& stride) {
  Weights weights;
  for (std::size_t i = 0; i < stride.count; ++i) {
    if (!germ.owner(stride.steps[i]).is_sum) {
      (germ.is_of_a(stride.steps[i]) ? weights.a : weights.b) -= stride.shares[i];
    }
  }
  return weights;
}

bool stride_to_minimum(const PairGerm& germ, const Weights& weights, Real noise, Real spare, Stride& stride) {
  if (germ.a.disc > 0 || germ.b.disc > 0) {
    return false;
  }
  const InFrame& r = germ.point;
  const std::size_t count = germ.step_count();
  Form form{-r.n, 0, -r.n};
  form.add(weights.a, germ.a);
  form.add(weights.b, germ.b);
  // No other piece may be further out there.
  const auto consider = [&](const Stride& tried) {
    if (!(tried.square < stride.square)) {
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_taken = (tried.count > 0 && tried.steps[0] == i) || (tried.count > 1 && tried.steps[1] == i);
      const InFrame& step = germ.step(i);
      if (!is_taken && step.n + step.x * tried.x + step.y * tried.y > noise) {
        return;
      }
    }
    stride = tried;
  };
  const Real determinant = form.xx * form.yy - form.xy * form.xy;
  if (form.xx + form.yy > 0 && determinant > 0) {
    Stride free;
    free.x = (form.xy * r.y - form.yy * r.x) / determinant;
    free.y = (form.xy * r.x - form.xx * r.y) / determinant;
    free.square = free.x * free.x + free.y * free.y;
    consider(free);
  }
  if (r.x * r.x + r.y * r.y <= spare * spare && form.least() >= -spare) {
    // All directions nearby may be as good.
    Stride here;
    here.square = 0;
    consider(here);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const InFrame& u = germ.step(i);
    const Real square = u.x * u.x + u.y * u.y;
    if (!(square > 0) || !(u.n * u.n < square)) {
      continue;
    }
    const Real inverse = 1 / square;
    // Along the crease, which is straight in these coordinates or nearly so.
    const Real at_x = -u.n * inverse * u.x, at_y = -u.n * inverse * u.y;
    const Real rise = r.x * at_x + r.y * at_y;  // of the depth, up to the crease
    const Real bend = form.along(-u.y, u.x) - rise * square;
    if (bend > -spare * square) {
      const Real slope = -u.y * (r.x + form.xx * at_x + form.xy * at_y) + u.x * (r.y + form.xy * at_x + form.yy * at_y);
      const bool is_level = std::fabs(slope) <= spare * std::sqrt(square);
      if (is_level || bend > 0) {
        const Real t = is_level ? 0 : -slope / bend;
        Stride on;
        on.x = at_x - t * u.y;
        on.y = at_y + t * u.x;
        on.square = on.x * on.x + on.y * on.y;
        const Real pull_x = r.x + form.xx * on.x + form.xy * on.y, pull_y = r.y + form.xy * on.x + form.yy * on.y;
        const Real share = -(u.x * pull_x + u.y * pull_y) * inverse;
        on.steps[0] = i;
        on.shares[0] = clamped(share);
        on.count = 1;
        if (is_share(share)) {
          consider(on);
        }
      }
    }
    for (std::size_t j = i + 1; j < count; ++j) {
      const InFrame& v = germ.step(j);
      const Real across = u.x * v.y - u.y * v.x;
      if (!(across * across > 1e-20 * square * (v.x * v.x + v.y * v.y))) {
        continue;
      }
      const Real scale = 1 / across;
      Stride both;
      both.x = scale * (v.n * u.y - u.n * v.y);
      both.y = scale * (u.n * v.x - v.n * u.x);
      both.square = both.x * both.x + both.y * both.y;
      const Real pull_x = r.x + form.xx * both.x + form.xy * both.y, pull_y = r.y + form.xy * both.x + form.yy * both.y;
      const Real first = scale * (pull_y * v.x - pull_x * v.y), second = scale * (pull_x * u.y - pull_y * u.x);
      const bool is_of_one = germ.is_of_a(i) == germ.is_of_a(j) && !germ.owner(i).is_sum;
      both.steps = {i, j};
      both.shares = {clamped(first), clamped(second)};
      both.count = 2;
      if (is_share(first) && is_share(second) && (!is_of_one || first + second <= 1)) {
        consider(both);
      }
    }
  }
  return stride.square < infinity;
}

Stride stride_on_disc(const PairGerm& germ, Real noise) {
  Stride stride;
  stride.square = 0;
  for (std::size_t i = 0; i < germ.step_count() && stride.count < 2; ++i) {
    const InFrame& step = germ.step(i);
    if (std::fabs(step.n) <= noise && step.x * step.x + step.y * step.y > 0) {
      stride.steps[stride.count++] = i;
    }
  }
  // Each in turn, as near as it goes: those of a box are across each other, so that once is enough.
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < stride.count; ++i) {
      const InFrame& step = germ.step(stride.steps[i]);
      const InFrame foot = foot_of(germ, stride);
      const Real square = step.x * step.x + step.y * step.y;
      stride.shares[i] = clamped(stride.shares[i] - (foot.x * step.x + foot.y * step.y) / square);
    }
  }
  if (stride.count == 2 && !germ.owner(stride.steps[0]).is_sum &&
      germ.is_of_a(stride.steps[0]) == germ.is_of_a(stride.steps[1])) {
    const Real sum = stride.shares[0] + stride.shares[1];
    if (sum > 1) {
      stride.shares = {stride.shares[0] / sum, stride.shares[1] / sum};
    }
  }
  return stride;
}

CapReach cap_of(const PairGerm& germ, const Stride& stride, const InFrame& foot, Real spare) {
  // How much of the ends of each step is left on either side of the foot, and of the pieces there.
  Weights weights;
  std::array<Real, 2> rests{0, 0};
  for (std::size_t i = 0; i < stride.count; ++i) {
    const Real share = stride.shares[i];
    rests[i] = share < 1 - share ? share : 1 - share;
  }
  const bool is_of_one = stride.count == 2 && germ.is_of_a(stride.steps[0]) == germ.is_of_a(stride.steps[1]) &&
                         !germ.owner(stride.steps[0]).is_sum;
  if (is_of_one) {
    const Real both = 0.5 * (1 - stride.shares[0] - stride.shares[1]);
    const Real less = stride.shares[0] < stride.shares[1] ? stride.shares[0] : stride.shares[1];
    rests[0] = rests[1] = both < 0 ? 0 : both < less ? both : less;
  } else {
    for (std::size_t i = 0; i < stride.count; ++i) {
      const Germ& owner = germ.owner(stride.steps[i]);
      if (!owner.is_sum && owner.xx + owner.yy > 0) {
        rests[i] *= 0.5;
        (germ.is_of_a(stride.steps[i]) ? weights.a : weights.b) = 1 - stride.shares[i] - rests[i];
      }
    }
  }
  const Real disc = germ.a.disc + germ.b.disc, aside = std::sqrt(foot.x * foot.x + foot.y * foot.y);
  if (disc > 0 && aside > disc) {
    return {0, -infinity};
  }
  Real lost = disc > 0 ? 0 : aside;
  for (std::size_t i = 0; i < stride.count; ++i) {
    lost += std::fabs(germ.step(stride.steps[i]).n);
  }
  // Beyond an edge or a disc the body goes on along it, which counts by its length over that of w.
  Form straight{disc > 0 ? disc - aside : 0, 0, disc > 0 ? disc - aside : 0};
  for (std::size_t i = 0; i < stride.count; ++i) {
    const InFrame& step = germ.step(stride.steps[i]);
    const Real square = step.x * step.x + step.y * step.y, rest = square > 0 ? rests[i] / std::sqrt(square) : 0;
    straight.xx += rest * step.x * step.x;
    straight.xy += rest * step.x * step.y;
    straight.yy += rest * step.y * step.y;
  }
  const auto form_at = [&](const Reach& reach) {
    Form form{reach.ends * straight.xx, reach.ends * straight.xy, reach.ends * straight.yy};
    form.add_bound(weights.a, germ.a, reach.tangent);
    form.add_bound(weights.b, germ.b, reach.tangent);
    return form;
  };
  // The form grows as the cap shrinks.
  std::size_t low = 0, high = reaches.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (form_at(reaches[middle]).is_at_least(foot.n - spare)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  if (low == reaches.size()) {
    return {0, -infinity};
  }
  const Real short_by = foot.n - form_at(reaches[low]).least();
  return {reaches[low].tangent, foot.n - lost - (short_by > 0 ? short_by : 0)};
}

std::optional<DepthMinimum> minimum_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride, Real spare) {
  const InFrame foot = foot_of(germ, stride);
  const CapReach cap = cap_of(germ, stride, foot, spare);
  if (!(cap.tangent > 0) || !(foot.n > 0)) {
    return std::nullopt;
  }
  DepthMinimum found = points_at(frame, germ, stride);
  found.lower = cap.lower;
  found.cosine = 1 / std::sqrt(1 + cap.tangent * cap.tangent);
  return found;
}

DepthMinimum points_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride) {
  const InFrame foot = foot_of(germ, stride);
  // The points of both bodies whose difference is the foot: a disc has one under any point near its middle.
  InFrame on_a = germ.a.point;
  for (std::size_t i = 0; i < stride.count; ++i) {
    if (germ.is_of_a(stride.steps[i])) {
      const InFrame& step = germ.step(stride.steps[i]);
      const Real share = stride.shares[i] * germ.part_of_a[stride.steps[i]];
      on_a.x += share * step.x;
      on_a.y += share * step.y;
      on_a.n += share * step.n;
    }
  }
  const Real disc = germ.a.disc + germ.b.disc;
  if (disc > 0) {
    const Real part = germ.a.disc / disc;
    on_a.x -= part * foot.x;
    on_a.y -= part * foot.y;
  }
  DepthMinimum found;
  found.normal = frame.n;
  found.depth = found.upper = foot.n;
  for (std::size_t i = 0; i < stride.count; ++i) {
    found.upper += std::fabs(germ.step(stride.steps[i]).n);
  }
  found.lower = foot.n;
  found.cosine = 1;
  found.point_a = on_a.n * frame.n + on_a.x * frame.x + on_a.y * frame.y;
  found.point_b = found.point_a - foot.n * frame.n;
  return found;
}

bool weighed_stride(const PairGerm& germ, Real noise, Real spare, Stride& stride) {
  stride = {};
  if (!stride_to_minimum(germ, {}, noise, spare, stride)) {
    return false;
  }
  const Weights weights = weights_of(germ, stride);
  if (weights.a == 1 && weights.b == 1) {
    return true;
  }
  stride = {};
  return stride_to_minimum(germ, weights, noise, spare, stride);
}

Real error_of_foot(const PairGerm& germ, const Stride& stride) {
  const InFrame foot = foot_of(germ, stride);
  Real off = std::sqrt(foot.x * foot.x + foot.y * foot.y);
  for (std::size_t i = 0; i < stride.count; ++i) {
    off += std::fabs(germ.step(stride.steps[i]).n);
  }
  return off;
}

std::optional<DepthMinimum> minimum_near(const Difference& cores, const Vec3& direction, Real error, Real noise) {
  Vec3 n = direction;
  for (int round = 0; round < minimum_rounds; ++round) {
    const GermFrame frame = frame_along(n);
    const PairGerm germ = cores.germ(frame);
    Stride stride;
    if (!weighed_stride(germ, noise, error / 16, stride)) {
      return std::nullopt;
    }
    if (error_of_foot(germ, stride) <= error / 16) {
      return minimum_at(frame, germ, stride, error / 16);
    }
    const Real shorten = stride.square > 0.25 ? 0.5 / std::sqrt(stride.square) : 1;
    const auto next = UnitVec3::make(n + (shorten * stride.x) * frame.x + (shorten * stride.y) * frame.y);
    if (!next) {
      return std::nullopt;
    }
    n = *next;
  }
  return std::nullopt;
}

std::optional<DepthMinimum> points_under(const Difference& cores, const Vec3& normal, Real error, Real noise) {
  const GermFrame frame = frame_along(normal);
  const PairGerm germ = cores.germ(frame);
  Stride stride;
  if (germ.a.disc > 0 || germ.b.disc > 0) {
    stride = stride_on_disc(germ, noise);
    const InFrame foot = foot_of(germ, stride);
    if (std::hypot(foot.x, foot.y) > germ.a.disc + germ.b.disc) {
      return std::nullopt;
    }
  } else if (!weighed_stride(germ, noise, error / 16, stride) || error_of_foot(germ, stride) > error / 16) {
    return std::nullopt;
  }
  return points_at(frame, germ, stride);
}

std::optional<DepthMinimum> minimum_on_disc(const Difference& cores, const Vec3& axis, Real error, Real noise) {
  const GermFrame frame = frame_along(axis);
  const PairGerm germ = cores.germ(frame);
  return minimum_at(frame, germ, stride_on_disc(germ, noise), error / 16);
}

}  // namespace abut
