// How the support function of a core runs near a direction, up to second order: what Newton's method needs to find the
// least depth of curved cores, and what proves that it is the least one nearby.
//
// Directions near a unit n are v = n + w with w across n, w = (x, y) in the basis of a frame. The core is the largest
// of a few pieces there: one with support point `point`, and beyond each crease one whose points lie further by `step`.
export module abut.capability.second_order;
import abut.core.standard;
import abut.math;

export namespace abut {

// A unit direction and two others that form an orthonormal basis with it.
struct GermFrame {
  Vec3 n, x, y;
};

// A vector by its parts along a frame.
struct InFrame {
  Real n, x, y;
};
[[nodiscard]] [[gnu::always_inline]] inline InFrame in_frame(const GermFrame& frame, const Vec3& v) {
  return {dot(frame.n, v), dot(frame.x, v), dot(frame.y, v)};
}

struct Germ {
  InFrame point;
  // Second derivative of the piece. Its support function is at least that of `point` plus
  // w (second) w * stiffness_at(|w|) / (1 + sqrt(1 + |w|^2)).
  Real xx, xy, yy;
  Real share, slope;  // of that bound
  Real ball;          // radius of a ball inside that touches at `point`, or 0: no direction has less than its support
  Real disc;          // radius of a flat disc across n around `point`, or 0
  std::array<InFrame, 3> steps;
  std::size_t step_count;
  bool is_sum;  // the steps add up, as edges of a box do; else they lead to pieces of their own
};

[[nodiscard]] [[gnu::always_inline]] inline Germ germ_of_point(const InFrame& point) {
  Germ germ;
  germ.point = point;
  germ.xx = germ.xy = germ.yy = germ.disc = germ.slope = germ.ball = 0;
  germ.share = 1;
  germ.step_count = 0;
  germ.is_sum = true;
  return germ;
}

// Of |E v|, E being symmetric with values up to 1: sqrt(p^2 + ...) lies between |E n| + |w| and |v|. `share` is |E n|,
// `slope` the part of E E n / |E n| across n.
[[nodiscard]] [[gnu::always_inline]] inline Real stiffness_at(const Germ& germ, Real reach) {
  const Real beyond = germ.slope * reach - (1 - germ.share);
  const Real wide = 1 + 0.5 * (beyond > 0 ? beyond : 0), narrow = germ.share + reach;
  return germ.share / (wide < narrow ? wide : narrow);
}

// Support along n of a disc of a radius around a point, across the axis (0, 0, 1): n has the part `side` across that
// axis, in the direction (x, y).
struct DiscEdge {
  Real x, y, side;
};
inline constexpr Real flat_sine = 1e-12;  // a disc that looks along n as nearly as that is flat
[[gnu::always_inline]] inline void bend_by_disc(const GermFrame& frame, const DiscEdge& edge, Real radius, Germ& germ) {
  const Real along_x = edge.x * frame.x.y - edge.y * frame.x.x, along_y = edge.x * frame.y.y - edge.y * frame.y.x;
  const Real bend = radius / edge.side;
  germ.xx = bend * along_x * along_x;
  germ.xy = bend * along_x * along_y;
  germ.yy = bend * along_y * along_y;
  germ.share = edge.side;
  germ.slope = frame.n.z < 0 ? -frame.n.z : frame.n.z;
}

// Balls of one radius inside a core, around all points of a segment: centre +- half.
struct InnerBalls {
  Vec3 centre, half;
  Real radius;
};

// An outward normal of the outline that turns around Z to a core: away from the axis, and along it. Both are 0 where
// there are fewer.
struct OutlineNormal {
  Real out, up;
};
using OutlineNormals = std::array<OutlineNormal, 3>;

}  // namespace abut
