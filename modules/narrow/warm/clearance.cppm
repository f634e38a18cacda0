// How much room there is around a point of a facet that two features make.
export module abut.narrow.warm.clearance;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.fan.hull_sat;
import abut.narrow.warm.features;

export namespace abut {

// How far a point beside a face is inside its edges, seen along its normal; of a disc one of its corners decides.
[[nodiscard]] inline Real clearance_within(const Face& face, const Vec3& point) {
  const auto vertices = face.vertices.span();
  Real least = vertices.size() > 2 ? infinity : -infinity;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3& from = vertices[i].point;
    const Vec3 along = vertices[i + 1 < vertices.size() ? i + 1 : 0].point - from;
    const Real side = dot(cross(face.normal, along), point - from),
               square = side * std::fabs(side) / squared_norm(along);
    least = square < least ? square : least;
  }
  return least > 0 ? std::sqrt(least) : least;
}

// How far a point of a segment is from its ends.
[[nodiscard]] inline Real room_within(const Vec3& from, const Vec3& along, const Vec3& point) {
  const Real length = std::sqrt(squared_norm(along));
  return 0.5 * length - std::fabs(dot(point - from, along) / length - 0.5 * length);
}
// Of both edges at their crossing, which is `on_a` and `on_b` in the frame of a. Nothing is left of an edge that is no
// longer what its body has furthest out: `noise` behind the support point.
template <Faceted S>
[[nodiscard]] inline Real room_on_line(const S& hull, std::uint16_t number, const Vec3& point, const Vec3& outward,
                                       Real noise) {
  const auto& line = hull.facets().lines[number];
  const Vec3 from = vec3_of(line.from);
  return std::fabs(dot(outward, point - from)) <= noise ? room_within(from, vec3_of(line.along), point) : -infinity;
}
template <BoxCored S>
[[nodiscard]] inline Real room_on_axis(const S& box, int axis, const Vec3& point) {
  return box.half()[axis] - std::fabs(point[axis]);
}
// Of a round body only where it is as wide at either end.
template <FlatEnded S>
[[nodiscard]] inline Real room_on_side(const S& shape, const Vec3& point) {
  const auto top = shape.supporting_rim({0, 0, 1}), bottom = shape.supporting_rim({0, 0, -1});
  const bool is_straight = top && bottom && top->radius == bottom->radius && top->height == -bottom->height;
  return is_straight ? top->height - std::fabs(point.z) : -infinity;
}
template <Edged S>
[[nodiscard]] inline Real room_on_edge(const S& shape, std::uint16_t number, const Vec3& point, const Vec3& outward,
                                       Real noise) {
  if constexpr (Faceted<S>) {
    return room_on_line(shape, number, point, outward, noise);
  } else if constexpr (BoxCored<S>) {
    return room_on_axis(shape, number, point);
  } else {
    return room_on_side(shape, point);
  }
}
template <Edged A, Edged B>
[[nodiscard]] inline Real room_on_edges(const A& a, const B& b, const Pose& ab, const PairFeatures& features,
                                        const Vec3& normal, const Vec3& on_a, const Vec3& on_b, Real noise) {
  const auto& numbers = features.numbers;
  const Vec3 local = ab.undo(on_b), outward = ab.rotation.undo(-normal);
  if constexpr (FlatEnded<A> || FlatEnded<B>) {
    return std::fmin(room_on_edge(a, numbers[0], on_a, normal, noise),
                     room_on_edge(b, numbers[1], local, outward, noise));
  } else if constexpr (Faceted<A> && Faceted<B>) {
    const auto& points = b.facets().points;
    const Vec3 from = vec3_of(points[numbers[1]]);
    const bool is_outermost = std::fabs(dot(outward, local - from)) <= noise;
    const Real room = is_outermost ? room_within(from, vec3_of(points[numbers[2]]) - from, local) : -infinity;
    return std::fmin(room_on_line(a, numbers[0], on_a, normal, noise), room);
  } else if constexpr (Faceted<A>) {
    return std::fmin(room_on_line(a, numbers[0], on_a, normal, noise), room_on_axis(b, numbers[1], local));
  } else {
    return std::fmin(room_on_axis(a, numbers[1], on_a), room_on_line(b, numbers[0], local, outward, noise));
  }
}

}  // namespace abut
