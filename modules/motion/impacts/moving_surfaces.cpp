// SPDX-License-Identifier: Apache-2.0
module abut.motion.impacts.moving_surfaces;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.impacts.convex_impact;
import abut.pairs.taken_apart.convex_part;
import abut.motion.impacts.impact_search;
import abut.motion.impacts.motion_order;
import abut.motion.paths.path;
import abut.motion.impacts.relative_motion;
import abut.motion.impacts.whole_impact;
import abut.pairs.registry;
import abut.trees.boxes.two_trees;

namespace abut {
namespace {

// Two surfaces within a span in which they turn little: triangles whose boxes may meet, mostly in the order of time.
template <Surface A, Surface B>
void meet_triangles(const A& a, const Subject& on_a, const B& b, const Subject& on_b, const TimeSpan& span,
                    Search& search) {
  const Carrier &way_a = on_a.on, &way_b = on_b.on;
  const auto bend_of = [&](const Carrier& frame, const Subject& moving) {
    return relative_bounds(frame.path, moving.on.path, moving.on.path.radius_of(moving.box), span).bend;
  };
  MotionOrder order(a.origin(), b.origin(), relative(way_a.at(span.begin), way_b.at(span.begin)),
                    relative(way_a.at(span.end), way_b.at(span.end)), span, bend_of(way_a, on_b), bend_of(way_b, on_a),
                    search.slack());
  const ConvexPart none = ConvexPart::of(Ball(0));
  MovingPair pair{moving_part(none, way_a.path, way_a.local), moving_part(none, way_b.path, way_b.local),
                  search.settings};
  std::optional<std::uint32_t> held;  // often several triangles of a meet one of b, one after the other
  visit_two(a, b, order, std::min(span.end, search.best.end()), [&](std::uint32_t of_a, std::uint32_t of_b) {
    const Real way = order.way_of(a.corners(of_a), b.corners(of_b));
    if (way >= search.best.end()) {
      return search.best.end();
    }
    if (held != of_b) {
      pair.b = moving_part(ConvexPart::of(b.part(of_b)), way_b.path, way_b.local);
      held = of_b;
    }
    pair.a = moving_part(ConvexPart::of(a.part(of_a)), way_a.path, way_a.local);
    const Real end = search.best.end();
    meet_parts(pair, {way, span.end}, on_a.child, on_b.child, search);
    if (search.best.end() < std::min(end, span.end)) {
      const Real touch = search.best.end();
      order.end_at(touch, relative(way_a.at(touch), way_b.at(touch)));
    }
    return search.best.end();
  });
}

// About how large the triangles of a surface are.
template <Surface S>
Real size_of_triangles(const S& surface, const Aabb& box) {
  return largest_magnitude(box.high - box.low) / std::sqrt(static_cast<Real>(surface.triangle_count()));
}

// So many spans that in each the ways of points are bent by little beside a triangle. Triangles that are apart by less
// than the bend would have to be asked one by one.
std::uint32_t span_count(Real triangle, Real bend, Real duration) {
  if (!(bend > 0)) {
    return 1;
  }
  constexpr Real bent_share = 0.1, most_spans = 4096;
  const Real longest = std::sqrt(8 * bent_share * triangle / bend);
  return static_cast<std::uint32_t>(std::clamp(std::ceil(duration / longest), Real{1}, most_spans));
}

}  // namespace

void meet_surfaces(const Subject& a, const Subject& b, const TimeSpan& span, Search& search) {
  const Real bend = std::max(relative_bounds(a.on.path, b.on.path, b.on.path.radius_of(b.box), span).bend,
                             relative_bounds(b.on.path, a.on.path, a.on.path.radius_of(a.box), span).bend);
  std::visit(
      [&]<class A, class B>(const A& its, const B& other) {
        if constexpr (Surface<A> && Surface<B>) {
          const Real triangle = std::min(size_of_triangles(its, a.box), size_of_triangles(other, b.box));
          const std::uint32_t count = span_count(triangle, bend, span.length());
          const Real step = span.length() / count;
          Real begin = span.begin;
          for (std::uint32_t i = 1; i <= count && begin < search.best.end(); ++i) {
            const Real end = i < count ? span.begin + i * step : span.end;
            meet_triangles(its, a, other, b, {begin, end}, search);
            begin = end;
          }
        }
      },
      static_cast<const AnyShape::Variant&>(a.shape), static_cast<const AnyShape::Variant&>(b.shape));
}

}  // namespace abut
