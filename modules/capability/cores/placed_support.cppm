// SPDX-License-Identifier: Apache-2.0
// Support points of a shape under a pose, by the shape's own way where it has one.
export module abut.capability.cores.placed_support;
import abut.capability.concepts;
import abut.capability.cores.core_feature;
import abut.capability.records;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

template <Convex S>
[[nodiscard]] inline auto place(const S& shape, const Pose& pose) {
  if constexpr (Placeable<S>) {
    return shape.placed(pose);
  } else {
    return pose;
  }
}

template <Convex S, class Placement>
[[nodiscard]] [[gnu::always_inline]] inline SupportPoint placed_support(const S& shape, const Placement& placement,
                                                                        const Vec3& direction) {
  if constexpr (Placeable<S>) {
    return placement.support(direction);
  } else {
    const SupportPoint local = shape.support(placement.rotation.undo(direction));
    return {placement * local.point, local.index};
  }
}

template <Convex S>
[[nodiscard]] inline Vec3 placed_centre(const S& shape, const Pose& pose) {
  if constexpr (BoxCored<S>) {
    return pose.position;
  } else {
    return pose * shape.centre();
  }
}

// Whether a core tells the face that has a feature.
template <Convex S>
[[nodiscard]] inline bool tells_face_of(const S& shape, const CoreFeature& feature) {
  if constexpr (Faceted<S>) {
    return feature.kind != CoreFeature::Kind::none && shape.facets().is_closed;
  } else {
    return false;
  }
}
// `feature`: of a core that knows its features, what lies furthest along the direction; else none.
template <Convex S>
[[nodiscard]] inline Face supporting_face(const S& shape, const Vec3& direction, const CoreFeature& feature) {
  if constexpr (Faceted<S>) {
    if (tells_face_of(shape, feature)) {
      return shape.supporting_face(direction, feature);
    }
  }
  return shape.supporting_face(direction);
}
template <Convex S>
[[nodiscard]] inline Face placed_face(const S& shape, const Pose& pose, const Vec3& direction,
                                      const CoreFeature& feature = {}) {
  Face face = supporting_face(shape, pose.rotation.undo(direction), feature);
  for (FaceVertex& vertex : face.vertices.span()) {
    vertex.point = pose * vertex.point;
  }
  face.normal = pose.rotation * face.normal;
  return face;
}

// `feature`: of a core that knows its features, what lies furthest along the direction; else none.
template <FewCornered S>
[[nodiscard]] [[gnu::always_inline]] inline FewCorners few_corners(const S& shape, const Vec3& direction,
                                                                   const CoreFeature& feature) {
  if constexpr (Faceted<S>) {
    if (tells_face_of(shape, feature)) {
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

// What a supporting face is as a feature.
[[nodiscard]] inline Feature feature_of(const Face& face) {
  return face.vertices.size() == 1   ? Feature{FeatureKind::vertex, face.vertices[0].vertex}
         : face.vertices.size() == 2 ? Feature{FeatureKind::edge, face.vertices[0].edge}
                                     : Feature{FeatureKind::face, face.index};
}

// The feature alone, by the shape's own way where it has one.
template <Convex S>
[[nodiscard]] inline Feature supporting_feature(const S& shape, const Vec3& direction) {
  if constexpr (requires { shape.supporting_feature(direction); }) {
    return shape.supporting_feature(direction);
  } else {
    return feature_of(shape.supporting_face(direction));
  }
}

// A core that is one point.
struct PlacedPoint {
  Vec3 centre;
  [[nodiscard]] inline SupportPoint support(const Vec3&) const { return {centre, 0}; }
  [[nodiscard]] inline Real reach(const Vec3&) const { return 0; }
};

// A core that is a segment: centre +- half.
struct PlacedSegment {
  Vec3 centre, half;
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const bool upper = dot(half, direction) >= 0;
    return {upper ? centre + half : centre - half, upper ? 1u : 0u};
  }
  [[nodiscard]] inline Real reach(const Vec3& direction) const { return std::fabs(dot(half, direction)); }
};

}  // namespace abut
