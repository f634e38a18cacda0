// SPDX-License-Identifier: Apache-2.0
// The way down to a point of least value nearby, where gradients may jump.
//
// Steps lead against the gradient, each brought back to where points may be (Goldstein 1964), with the length of
// Barzilai and Borwein (1988). Where a step leads up, the gradient there joins those so far: their shortest mean leads
// along the crease (Wolfe, A method of conjugate subgradients, 1975).
export module abut.narrow.ways.downhill;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.simplex;

export namespace abut {

// A point, and what a field has there, in the frame of the point.
struct FieldPoint {
  Vec3 point;
  FieldValue field;
};

// How long steps are: the first one, the longest one, and those that end the way. So does one that promises to gain
// no more than `least_gain`.
struct Steps {
  Real first, longest, end, least_gain;
};

// Which way is down, and how far to go against it.
struct WayDown {
  static constexpr int most_joined = 4;

  Vec3 mean;                   // of the gradients: the shortest one
  Real step;                   // a way is the mean times this
  int joined = 0;              // gradients beside the own one
  Vec3 last{0, 0, 0};          // that joined
  Real short_step = infinity;  // where the last step by the own gradient should have ended

  // `flat`: the step after which the gradient along the way would vanish.
  void go_on(const Vec3& gradient, Real flat, Real longest) {
    step = std::min(joined > 0 || flat == infinity ? 2 * step : std::min(flat, 4 * step), longest);
    // Along a crease the mean stays.
    mean = joined > 0 ? mean : gradient;
  }
  // `own`: the mean as the way showed it.
  void join(const Vec3& own, const Vec3& other, Real flat) {
    short_step = joined > 0 ? short_step : std::min(flat, step);
    mean = (joined > 0 ? closest_on_triangle(own, last, other, 1, 2, 4) : closest_on_segment(own, other, 1, 2)).point;
    last = other;
    ++joined;
  }
  void restart(const Vec3& gradient) {
    step = std::min(short_step, 0.25 * step);
    mean = gradient;
    joined = 0;
  }
};

// Downhill from a point, while a condition is met. onto(point) brings a point back to where it may be, or tells
// nothing; look(point) tells the value and the gradient there.
template <class Onto, class Look, class Condition>
[[nodiscard]] std::optional<FieldPoint> downhill(FieldPoint best, const Steps& steps, const Onto& onto,
                                                 const Look& look, const Condition& is_met) {
  constexpr int most_steps = 128;
  const Real end = steps.end * steps.end;
  WayDown down{best.field.gradient, steps.first};
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<Vec3> point = onto(best.point - down.step * down.mean);
    const Vec3 way = point.value_or(best.point) - best.point;
    const Real moved = squared_norm(way);
    if (!(moved > end && moved > steps.least_gain * down.step)) {
      if (down.joined == 0 && point) {
        break;
      }
      down.restart(best.field.gradient);
      continue;
    }
    const FieldPoint next = look(*point);
    const Real bend = dot(way, next.field.gradient - best.field.gradient), flat = bend > 0 ? moved / bend : infinity;
    if (next.field.value < best.field.value) {
      down.go_on(next.field.gradient, flat, steps.longest);
      best = next;
      if (!is_met(best.point)) {
        return std::nullopt;
      }
      continue;
    }
    // What a gradient leads to is seen where points may be.
    const std::optional<Vec3> other =
        down.joined < WayDown::most_joined ? onto(best.point - down.step * next.field.gradient) : std::nullopt;
    if (other) {
      down.join((-1 / down.step) * way, (1 / down.step) * (best.point - *other), flat);
    } else {
      down.restart(best.field.gradient);
    }
  }
  return best;
}

}  // namespace abut
