// SPDX-License-Identifier: Apache-2.0
module abut.narrow.points.closest_of_faces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

namespace abut {
namespace {

// A vertex and its projection along the normal.
struct Corner {
  Vec3 point;
  Real u, v;
};
using Corners = SmallVector<Corner, 16>;

[[nodiscard]] inline Real turn(const Corner& from, const Corner& to, const Corner& p) {
  return (to.u - from.u) * (p.v - from.v) - (to.v - from.v) * (p.u - from.u);
}

// The vertices that reach furthest along a direction, in the order of the face.
void outermost(const Face& face, const Vec3& direction, Real slack, const Vec3& base, const Tangents& tangents,
               Corners& out) {
  Real most = -infinity;
  for (const FaceVertex& vertex : face.vertices.span()) {
    most = std::max(most, dot(vertex.point - base, direction));
  }
  for (const FaceVertex& vertex : face.vertices.span()) {
    const Vec3 d = vertex.point - base;
    if (dot(d, direction) >= most - slack) {
      out.push_back({vertex.point, dot(d, tangents.first), dot(d, tangents.second)});
    }
  }
}

// Whether a polygon holds a point further than `slack` from its edges. A needle and a polygon without area hold none:
// rounding would take points beyond their ends for inside.
[[nodiscard]] bool holds(std::span<const Corner> polygon, const Corner& p, Real slack) {
  bool left = polygon.size() > 2, right = left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const Real side = turn(from, to, p), least = slack * (std::fabs(to.u - from.u) + std::fabs(to.v - from.v));
    left = left && side >= least;
    right = right && side <= -least;
  }
  return left != right;
}

[[nodiscard]] Corner at(const Corner& from, const Corner& to, Real t) {
  return {from.point + t * (to.point - from.point), from.u + t * (to.u - from.u), from.v + t * (to.v - from.v)};
}

// Where a segment comes closest to a point.
[[nodiscard]] Corner nearest_on(const Corner& from, const Corner& to, const Corner& p) {
  const Real u = to.u - from.u, v = to.v - from.v;
  const Real square = u * u + v * v;
  return square > 0 ? at(from, to, std::clamp(((p.u - from.u) * u + (p.v - from.v) * v) / square, Real{0}, Real{1}))
                    : from;
}

class Search {
 public:
  [[nodiscard]] const AcrossPair& best() const [[clang::lifetimebound]] { return best_; }

  void offer(const Corner& a, const Corner& b) {
    const Real u = b.u - a.u, v = b.v - a.v;
    if (u * u + v * v < least_) {
      least_ = u * u + v * v;
      best_ = {a.point, b.point};
    }
  }
  void offer_edges(const Corner& a0, const Corner& a1, const Corner& b0, const Corner& b1) {
    const Real start = turn(a0, a1, b0), end = turn(a0, a1, b1);
    const Real enter = turn(b0, b1, a0), leave = turn(b0, b1, a1);
    if ((start < 0) != (end < 0) && (enter < 0) != (leave < 0)) {
      offer(at(a0, a1, enter / (enter - leave)), at(b0, b1, start / (start - end)));
    }
    for (const Corner& a : {a0, a1}) {
      offer(a, nearest_on(b0, b1, a));
    }
    for (const Corner& b : {b0, b1}) {
      offer(nearest_on(a0, a1, b), b);
    }
  }

 private:
  Real least_ = infinity;
  AcrossPair best_{};
};

}  // namespace

AcrossPair points_across(const Face& a, const Face& b, const Vec3& normal, Real slack) {
  const Vec3 base = a.vertices[0].point;
  const Tangents tangents = tangents_of(normal);
  [[clang::uninitialized]] Corners corners_a;
  [[clang::uninitialized]] Corners corners_b;
  outermost(a, normal, slack, base, tangents, corners_a);
  outermost(b, -normal, slack, base, tangents, corners_b);
  const std::span<const Corner> of_a = corners_a.span(), of_b = corners_b.span();
  Search search;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      search.offer_edges(of_a[i], of_a[(i + 1) % of_a.size()], of_b[j], of_b[(j + 1) % of_b.size()]);
    }
  }
  // A part that lies over the inside of the other one has no edge near it.
  const Real height = dot(of_b[0].point - of_a[0].point, normal);
  if (holds(of_a, of_b[0], slack)) {
    return {of_b[0].point - height * normal, of_b[0].point};
  }
  if (holds(of_b, of_a[0], slack)) {
    return {of_a[0].point, of_a[0].point + height * normal};
  }
  return search.best();
}

}  // namespace abut
