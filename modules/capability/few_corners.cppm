// SPDX-License-Identifier: Apache-2.0
// A face of three or four corners in vector registers.
export module abut.capability.few_corners;
import abut.capability.concepts;
import abut.capability.core_feature;
import abut.capability.records;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

// As Face has it, a corner per lane. The last corner of a triangle stands twice.
struct FewCorners {
  Columns at;
  Vec3 normal;  // zero where there is no such face, or none with an area
  std::uint32_t index;
  std::array<std::uint32_t, 4> vertices, edges;
};

[[nodiscard]] inline bool has_few_corners(const Face& face) {
  return face.vertices.size() == 3 || face.vertices.size() == 4;
}
// Of a face that has few.
[[nodiscard]] inline FewCorners few_corners_of(const Face& face) {
  const std::span<const FaceVertex> vertices = face.vertices.span();
  const FaceVertex &first = vertices[0], &second = vertices[1], &third = vertices[2],
                   &fourth = vertices[vertices.size() - 1];
  return {
      Columns::of(lanes_of(first.point), lanes_of(second.point), lanes_of(third.point), lanes_of(fourth.point)),
      face.normal,
      face.index,
      {first.vertex, second.vertex, third.vertex, fourth.vertex},
      {first.edge, second.edge, third.edge, fourth.edge},
  };
}

// A shape that knows at once whether the face that looks furthest along a direction is such a one.
template <class S>
concept FewCornered = Convex<S> && requires(const S& shape, const Vec3& direction) {
  { shape.few_corners(direction) } -> std::same_as<FewCorners>;
};

// `feature`: of a core that knows its features, what lies furthest along the direction; else none.
template <FewCornered S>
[[nodiscard]] [[gnu::always_inline]] inline FewCorners few_corners(const S& shape, const Vec3& direction,
                                                                   const CoreFeature& feature) {
  if constexpr (Faceted<S>) {
    if (feature.kind != CoreFeature::Kind::none && shape.facets().is_closed) {
      return shape.few_corners(direction, feature);
    }
  }
  return shape.few_corners(direction);
}
// The same of a shape under a pose, with corners that are rounded as each by itself.
template <FewCornered S>
[[nodiscard]] [[gnu::always_inline]] inline FewCorners placed_few_corners(const S& shape, const Pose& pose,
                                                                          const Vec3& direction,
                                                                          const CoreFeature& feature) {
  FewCorners face = few_corners(shape, pose.rotation.undo(direction), feature);
  const auto& [x, y, z] = pose.rotation;
  face.at = face.at.x * Columns::all(x) + face.at.y * Columns::all(y) + face.at.z * Columns::all(z) +
            Columns::all(pose.position);
  face.normal = pose.rotation * face.normal;
  return face;
}

}  // namespace abut
