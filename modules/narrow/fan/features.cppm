// SPDX-License-Identifier: Apache-2.0
// The features of cores by their numbers: normals of faces, edges with their ends, and the normal that two features
// give. Searches and pair memory both make their normals here, so that the same features give the same bits.
export module abut.narrow.fan.features;
import abut.capability;
import abut.core.standard;
import abut.math;
export import abut.narrow.cores.core_separation;
import abut.narrow.fan.facets;
import abut.narrow.fan.sat;

export namespace abut {

// Cores whose faces and edges have numbers.
template <class S>
inline constexpr bool is_numbered = Faceted<S> || Rimmed<S> || Triangular<S> || BoxCored<S>;
template <class A, class B>
inline constexpr bool are_numbered = is_numbered<A> && is_numbered<B>;

[[nodiscard]] inline Vec3 unit_axis(std::size_t axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

// The unit normal out of a face.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline Vec3 face_normal(const S& shape, std::size_t index) {
  if constexpr (Faceted<S>) {
    const auto& planes = shape.facets().planes[index / 4];
    return {planes.x[index % 4], planes.y[index % 4], planes.z[index % 4]};
  } else {
    const Real sign = index % 2 == 1 ? 1 : -1;
    if constexpr (Triangular<S>) {
      return sign * shape.normal();
    } else {
      return sign * unit_axis(index / 2);
    }
  }
}

// An edge from its start to its end.
struct CoreEdge {
  Vec3 from, along;
};
// Of parallel edges of a box, and of all lines along a round side, the one furthest along `outward`.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline CoreEdge edge_of(const S& shape, std::size_t index, const Vec3& outward) {
  if constexpr (Faceted<S>) {
    const auto& line = shape.facets().lines[index];
    return {vec3_of(line.from), vec3_of(line.along)};
  } else if constexpr (Rimmed<S>) {
    const Discs discs = shape.discs();
    const Sideways out = sideways_of(outward);
    const Real aside = discs.top - discs.bottom;
    return {{discs.bottom * out.x, discs.bottom * out.y, -discs.half_height},
            {aside * out.x, aside * out.y, 2 * discs.half_height}};
  } else if constexpr (Triangular<S>) {
    return {shape.corners()[index], shape.edge_directions()[index]};
  } else {
    const Vec3 half = shape.half();
    const auto at = [&](std::size_t axis, Real reach, Real direction) {
      return axis == index ? -reach : std::copysign(reach, direction);
    };
    return {{at(0, half.x, outward.x), at(1, half.y, outward.y), at(2, half.z, outward.z)},
            (2 * half[static_cast<int>(index)]) * unit_axis(index)};
  }
}

// Where a normal across an edge leads does not depend on the length of the edge.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline Vec3 edge_direction(const S& shape, std::size_t index) {
  if constexpr (Faceted<S>) {
    return vec3_of(shape.facets().lines[index].along);
  } else if constexpr (Triangular<S>) {
    return shape.edge_directions()[index];
  } else {
    return unit_axis(index);
  }
}

// Whether features give a normal by themselves: lines on the side of a cone lead along its axis nowhere.
template <Convex S>
[[nodiscard]] inline bool has_straight_edges(const S& shape) {
  if constexpr (Rimmed<S>) {
    const Discs discs = shape.discs();
    return discs.top == discs.bottom;
  } else {
    return true;
  }
}

// The unit normal from a to b, in the frame of a, of features that are known.
template <Convex A, Convex B>
  requires are_numbered<A, B>
[[nodiscard]] inline Vec3 normal_of(const A& a, const B& b, const Pose& ab, const CoreFeatures& features) {
  if (features.are_edges()) {
    const Vec3 edge_a = edge_direction(a, features.a.index), edge_b = ab.rotation * edge_direction(b, features.b.index);
    const Vec3 across = cross(edge_a, edge_b);
    const Vec3 n = unit_across_edges(edge_a, edge_b, across, squared_norm(across));
    return features.a.is_backward != features.b.is_backward ? -n : n;
  }
  return features.a.kind == CoreFeature::Kind::face ? face_normal(a, features.a.index)
                                                    : -(ab.rotation * face_normal(b, features.b.index));
}

// Directs the edge of a such that the normal across both leads along a given one.
template <Convex A, Convex B>
  requires are_numbered<A, B>
inline void direct_edges(const A& a, const B& b, const Pose& ab, const Vec3& normal, CoreFeatures& features) {
  if (features.are_edges()) {
    const Vec3 edge_b = ab.rotation * edge_direction(b, features.b.index);
    features.b.is_backward = false;
    features.a.is_backward = dot(cross(edge_direction(a, features.a.index), edge_b), normal) < 0;
  }
}

}  // namespace abut
