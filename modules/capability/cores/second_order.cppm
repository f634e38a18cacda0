// SPDX-License-Identifier: Apache-2.0
// How the support function of a core runs near a direction, up to second order: what Newton's method needs to find the
// least depth of curved cores, and what proves that it is the least one nearby.
//
// Directions near a unit n are
//   v = n + w,  w across n,  w = (x, y) in the basis of a frame.
// The support function is the largest of a few smooth pieces there. One has the support point `point`. Each edge leads
// to another one, on the far side of a crease.
export module abut.capability.cores.second_order;
import abut.core.standard;
import abut.math;

export namespace abut {

// A unit direction and two others that form an orthonormal basis with it.
struct DirectionFrame {
  Vec3 n, x, y;
};

// A vector by its parts along a frame.
struct InFrame {
  Real n, x, y;
};
[[nodiscard]] [[gnu::always_inline]] inline InFrame in_frame(const DirectionFrame& frame, const Vec3& v) {
  return {dot(frame.n, v), dot(frame.x, v), dot(frame.y, v)};
}

struct SecondOrder {
  InFrame point;
  // Second derivative of the piece. Its support function is at least that of `point` plus
  // w (second) w * stiffness_at(|w|) / (1 + sqrt(1 + |w|^2)).
  Real xx, xy, yy;
  Real share, slope;  // of that bound
  Real ball;          // radius of a ball inside that touches at `point`, or 0: no direction has less than its support
  Real disc;          // radius of a flat disc across n around `point`, or 0
  std::array<InFrame, 3> edges;
  std::size_t edge_count;
  bool is_sum;  // the edges add up, as those of a box do; else each leads to a piece of its own
};

[[nodiscard]] [[gnu::always_inline]] inline SecondOrder second_order_of_point(const InFrame& point) {
  SecondOrder near;
  near.point = point;
  near.xx = near.xy = near.yy = near.disc = near.slope = near.ball = 0;
  near.share = 1;
  near.edge_count = 0;
  near.is_sum = true;
  return near;
}

// The support function is |E v| times a length, where E is symmetric with eigenvalues up to 1. `share` is |E n|, and
// `slope` the part of E E n / |E n| across n. The bound comes from two others:
//   |E v| <= |E n| + |w|,  |E v| <= |v|
[[nodiscard]] [[gnu::always_inline]] inline Real stiffness_at(const SecondOrder& near, Real reach) {
  const Real beyond = near.slope * reach - (1 - near.share);
  const Real wide = 1 + 0.5 * (beyond > 0 ? beyond : 0), narrow = near.share + reach;
  return near.share / (wide < narrow ? wide : narrow);
}

// How a direction n looks at a disc across Z: `side` is the length of its part across Z, and (x, y) the direction of
// that part.
struct DiscEdge {
  Real x, y, side;
};
inline constexpr Real flat_sine = 1e-12;  // a disc that looks along n as nearly as that is flat
[[gnu::always_inline]] inline void bend_by_disc(const DirectionFrame& frame, const DiscEdge& edge, Real radius,
                                                SecondOrder& near) {
  const Real along_x = edge.x * frame.x.y - edge.y * frame.x.x, along_y = edge.x * frame.y.y - edge.y * frame.y.x;
  const Real bend = radius / edge.side;
  near.xx = bend * along_x * along_x;
  near.xy = bend * along_x * along_y;
  near.yy = bend * along_y * along_y;
  near.share = edge.side;
  near.slope = frame.n.z < 0 ? -frame.n.z : frame.n.z;
}

// Balls of one radius inside a core, around all points of a segment: centre +- half.
struct InnerBalls {
  Vec3 centre, half;
  Real radius;
};

}  // namespace abut
