// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.points_under;
import abut.capability.cores.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;
import abut.narrow.polytope.newton_step;

namespace abut {

namespace {

// The minimum along a normal itself, whatever is around.
[[nodiscard]] std::optional<DepthMinimum> minimum_under(const Difference& cores, const Vec3& normal, Real error,
                                                        Real noise) {
  const DirectionFrame frame = frame_along(normal);
  const PairSecondOrder near = cores.second_order(frame);
  const Real disc = near.a.disc + near.b.disc, tolerance = error / 16;
  const auto step = disc > 0 ? std::optional(step_on_disc(near, noise)) : newton_step(near, noise, tolerance);
  if (!step) {
    return std::nullopt;
  }
  const InFrame point = point_after(near, *step);
  const bool is_under = disc > 0 ? std::hypot(point.x, point.y) <= disc : error_after(near, *step) <= tolerance;
  return is_under ? std::optional(minimum_at(frame, near, *step)) : std::nullopt;
}

}  // namespace

std::optional<EpaResult> with_points(const Difference& cores, Real error, const EpaResult& found) {
  const Real noise = cores.noise();
  const auto is_same = [&](const std::optional<DepthMinimum>& minimum) {
    return minimum && std::fabs(minimum->depth - found.depth) <= error;
  };
  EpaResult pointed = found;
  if (const auto under = minimum_under(cores, found.normal, error, noise); is_same(under)) {
    pointed.point_a = under->point_a;
    pointed.point_b = under->point_a - found.depth * found.normal;
    return pointed;
  }
  if (const auto beside = minimum_near(cores, found.normal, error, noise); is_same(beside)) {
    pointed = {beside->depth,   std::fmin(found.lower, beside->depth),
               beside->upper,   beside->normal,
               beside->point_a, beside->point_b,
               found.iterations};
    return pointed;
  }
  return std::nullopt;
}

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
  // The points share what is left between them and the depth.
  const Vec3 half = (0.5 * (found.depth + dot(on_b - near.point_a, found.normal))) * found.normal;
  found.point_a = near.point_a + half;
  found.point_b = on_b - half;
}

}  // namespace abut
