// SPDX-License-Identifier: Apache-2.0
// A half-space against a convex shape: exact in one step.
//
// Heights over the plane are the same in every frame. They are taken in the frame of the shape, so that only points
// that touch have to be placed.
export module abut.narrow.walls.half_space;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.points.lane_contact;

export namespace abut {

template <HalfSpace A, Convex B>
[[nodiscard]] Outcome half_space_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                          Distance& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const Vec3 n = a.normal();
  const SupportPoint lowest = b.support(ab.rotation.undo(-n));
  const Vec3 point_b = ab * lowest.point - b.radius() * n;
  const Real distance = dot(n, point_b) - a.offset();
  out = {distance, distance, distance, point_b - distance * n, point_b, n, Algorithm::analytic, 1};
  return Outcome::ok;
}

// The plane of a half-space, seen from a shape.
struct PlaneBelow {
  Vec3 normal;        // in the frame that the shape is placed in
  Vec3 local_normal;  // in that of the shape
  Real height;        // of the origin of the shape
  [[nodiscard]] [[gnu::always_inline]] inline Real height_of(const Vec3& local) const {
    return height + dot(local_normal, local);
  }
};
template <HalfSpace A>
[[nodiscard]] [[gnu::always_inline]] inline PlaneBelow plane_below(const A& a, const Pose& pose_a, const Pose& pose_b) {
  const Vec3 normal = pose_a.rotation * a.normal();
  return {normal, pose_b.rotation.undo(normal), dot(normal, pose_b.position - pose_a.position) - a.offset()};
}

// The contact of a point of a core that is rounded off by a radius. `distance`: of the rounded point.
[[nodiscard]] [[gnu::always_inline]] inline LaneContact contact_on_plane(const PlaneBelow& plane, Lanes core_point,
                                                                         Real radius, Real distance,
                                                                         const Feature& feature_b) {
  constexpr Feature whole{FeatureKind::whole, 0};
  const Lanes normal = lanes_of(plane.normal);
  return {multiply_add(normal, all_lanes(-(distance + radius)), core_point),
          multiply_add(normal, all_lanes(-radius), core_point),
          normal,
          distance,
          whole,
          feature_b,
          contact_id(whole, feature_b)};
}

// A point or the two ends of a segment. The higher end has no contact where the ball around the lower end is in the
// way.
template <Convex B, class Append>
  requires PointCored<B> || SegmentCored<B>
[[gnu::always_inline]] inline void ends_on_plane(const PlaneBelow& plane, const B& b, const Pose& pose, Real margin,
                                                 Append&& append) {
  const Lanes centre = lanes_of(pose.position);
  const auto touch = [&](Lanes end, Real height, Real reach, std::uint32_t vertex) {
    if (const Real distance = height - reach; distance <= margin) {
      append(contact_on_plane(plane, end, reach, distance, {FeatureKind::vertex, vertex}));
    }
  };
  if constexpr (PointCored<B>) {
    touch(centre, plane.height, b.radius(), 0);
  } else {
    const Real half = b.half().z, rise = std::fabs(half * plane.local_normal.z);
    if (plane.height - rise - b.radius() > margin) {
      return;
    }
    const bool is_upper_lower = half > 0 && plane.local_normal.z <= 0;
    const Lanes along = lanes_of(pose.rotation.z);
    const auto end = [&](bool is_upper) { return multiply_add(along, all_lanes(is_upper ? half : -half), centre); };
    touch(end(is_upper_lower), plane.height - rise, b.radius(), is_upper_lower ? 1 : 0);
    // From the higher end the way down leaves through the side, after radius / sine of the angle to the axis.
    const Vec3& n = plane.local_normal;
    const Real over = plane.height + rise - margin, square = over * over * (n.x * n.x + n.y * n.y);
    if (half > 0 && !(over > 0 && square > (1 + rounding_of(1)) * b.radius() * b.radius())) {
      const RoundReach found = reach_from_end(half, b.radius(), !is_upper_lower, -n);
      if (!found.is_of_other_end) {
        touch(end(!is_upper_lower), plane.height + rise, found.reach, is_upper_lower ? 0 : 1);
      }
    }
  }
}

using LaneBits = bool __attribute__((ext_vector_type(4)));
// A bit for each lane.
[[nodiscard]] [[gnu::always_inline]] inline std::uint32_t bits_within(Lanes distances, Real margin) {
  return std::bit_cast<std::uint8_t>(__builtin_convertvector(distances <= margin, LaneBits)) & 15u;
}

// A box with extents in all directions: the corners of the face that looks down, four to a vector register.
template <class Append>
[[gnu::always_inline]] inline void corners_on_plane(const PlaneBelow& plane, const Vec3& half, const Pose& pose,
                                                    Real margin, Append&& append) {
  const Vec3 &n = plane.local_normal, rise{half.x * n.x, half.y * n.y, half.z * n.z}, size = absolute(rise);
  if (plane.height - (size.x + size.y + size.z) > margin) {
    return;
  }
  const int axis = longest_axis(n);
  const std::size_t across = static_cast<std::size_t>(axis), first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  // Arrays are read without a branch. The axis is as good as random, so that a branch would be mispredicted.
  const std::array<Real, 3> normals{n.x, n.y, n.z}, rises{rise.x, rise.y, rise.z}, halves{half.x, half.y, half.z};
  const std::array<Lanes, 3> columns{lanes_of(pose.rotation.x), lanes_of(pose.rotation.y), lanes_of(pose.rotation.z)};
  const Real side = normals[across] > 0 ? -1 : 1;
  constexpr std::array<Real, 4> ends_of_first{-1, 1, 1, -1}, ends_of_second{-1, -1, 1, 1};
  constexpr Lanes first_ends{-1, 1, 1, -1}, second_ends{-1, -1, 1, 1};
  const Lanes distances = plane.height + side * rises[across] + first_ends * rises[first] + second_ends * rises[second];
  const Lanes centre = multiply_add(columns[across], all_lanes(side * halves[across]), lanes_of(pose.position));
  const Lanes to_first = columns[first] * halves[first], to_second = columns[second] * halves[second];
  const std::uint32_t base = side > 0 ? 1u << across : 0u;
  for (std::uint32_t left = bits_within(distances, margin); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const Lanes along_first = multiply_add(to_first, all_lanes(ends_of_first[i]), centre);
    const Lanes corner = multiply_add(to_second, all_lanes(ends_of_second[i]), along_first);
    const std::uint32_t vertex = base | (6u >> i & 1u) << first | (12u >> i & 1u) << second;
    append(contact_on_plane(plane, corner, 0, distances[i], {FeatureKind::vertex, vertex}));
  }
}

// The corners of a disc that looks down, and its lowest point where that lies between two corners.
template <class Append>
[[gnu::always_inline]] inline void rim_on_plane(const PlaneBelow& plane, const Rim& rim, const Vec3& lowest,
                                                Real radius, Real noise, const Pose& pose, Real margin,
                                                Append&& append) {
  const Real level = plane.height_of({0, 0, rim.height}) - radius;
  const Real x = rim.radius * plane.local_normal.x, y = rim.radius * plane.local_normal.y;
  // The corners of two quarters. Those of the other two are opposite.
  constexpr Lanes cosines{rim_cosine(0), rim_cosine(1), rim_cosine(2), rim_cosine(3)};
  constexpr Lanes sines{rim_cosine(12), rim_cosine(13), rim_cosine(14), rim_cosine(15)};
  const Lanes quarter = cosines * x + sines * y, next = cosines * y - sines * x;
  const std::array<Lanes, 4> distances{level + quarter, level + next, level - quarter, level - next};
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const Lanes centre = multiply_add(columns.z, all_lanes(rim.height), lanes_of(pose.position));
  const Lanes to_x = columns.x * rim.radius, to_y = columns.y * rim.radius;
  std::uint32_t left = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    left |= bits_within(distances[i], margin) << (4 * i);
  }
  for (; left != 0; left &= left - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
    const Real cosine = rim_cosine(i), sine = rim_cosine(i + 12);
    const Lanes corner = multiply_add(to_y, all_lanes(sine), multiply_add(to_x, all_lanes(cosine), centre));
    append(contact_on_plane(plane, corner, radius, distances[i / 4][i % 4], {FeatureKind::vertex, rim.first + i}));
  }
  const Real deepest = plane.height_of(lowest) - radius;
  const Real least = -largest(-minimum(minimum(distances[0], distances[1]), minimum(distances[2], distances[3])));
  if (least > deepest + noise) {
    const Lanes point = columns.apply(lowest, lanes_of(pose.position));
    const Vec3& n = plane.local_normal;
    append(contact_on_plane(plane, point, radius, deepest, feature_where_deepest(rim.first, n.x * n.x + n.y * n.y)));
  }
}

// Whether a polytope knows which face at a vertex looks along a direction.
template <class S>
inline constexpr bool has_faces_at_vertices =
    requires(const S& shape) { shape.data().face_along(std::uint32_t{}, Vec3{}); };

// The corners of the face at the lowest vertex that looks down.
template <Convex B, class Append>
  requires has_faces_at_vertices<B>
[[gnu::always_inline]] inline void face_at_vertex_on_plane(const PlaneBelow& plane, const B& b, std::uint32_t lowest,
                                                           const Pose& pose, Real margin, Append&& append) {
  const auto& hull = b.data();
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const auto& face = hull.faces[hull.face_along(lowest, -plane.local_normal)];
  for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
    const std::uint32_t vertex = hull.face_vertices[i];
    const Vec3& local = hull.vertices[vertex];
    if (const Real distance = plane.height_of(local) - b.radius(); distance <= margin) {
      const Lanes point = columns.apply(local, lanes_of(pose.position));
      append(contact_on_plane(plane, point, b.radius(), distance, {FeatureKind::vertex, vertex}));
    }
  }
}

// The corners of the face that looks down, and the lowest point where that is no corner, as on a rim.
template <Convex B, class Append>
[[gnu::always_inline]] inline void face_on_plane(const PlaneBelow& plane, const B& b, const Pose& pose, Real margin,
                                                 Append&& append) {
  const Vec3 down = -plane.local_normal;
  // The rounding of heights over the plane.
  const Real noise = noise_of(b.extent() + std::fabs(plane.height));
  // A bound without a root tells most shapes that do not touch.
  if constexpr (requires { b.is_short_of(down, noise); }) {
    if (b.is_short_of(down, plane.height - b.radius() - margin - noise)) {
      return;
    }
  }
  const SupportPoint lowest = b.support(down);
  const Real deepest = plane.height_of(lowest.point) - b.radius();
  if (deepest > margin) {
    return;
  }
  if constexpr (has_faces_at_vertices<B>) {
    if (!b.data().faces.empty()) [[likely]] {
      return face_at_vertex_on_plane(plane, b, lowest.index, pose, margin, append);
    }
  } else if constexpr (Rimmed<B>) {
    if (const auto rim = b.supporting_rim(down)) {
      return rim_on_plane(plane, *rim, lowest.point, b.radius(), noise, pose, margin, append);
    }
  }
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const auto touch = [&](const Vec3& point, Real distance, const Feature& feature) {
    append(contact_on_plane(plane, columns.apply(point, lanes_of(pose.position)), b.radius(), distance, feature));
  };
  [[clang::uninitialized]] const Face face = b.supporting_face(down);
  Real least = infinity;
  for (const FaceVertex& vertex : face.vertices.span()) {
    const Real distance = plane.height_of(vertex.point) - b.radius();
    least = distance < least ? distance : least;
    if (distance <= margin) {
      touch(vertex.point, distance, {FeatureKind::vertex, vertex.vertex});
    }
  }
  if constexpr (Curved<B>) {
    if (least > deepest + noise) {
      touch(lowest.point, deepest, feature_of(face));
    }
  }
}

// Appends the contacts one by one, in the frame that both shapes are placed in.
template <HalfSpace A, Convex B, class Append>
[[nodiscard]] [[gnu::always_inline]] inline Outcome half_space_contacts(const A& a, const B& b, const Pose& pose_a,
                                                                        const Pose& pose_b,
                                                                        const QuerySettings& settings,
                                                                        Append&& append) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const PlaneBelow plane = plane_below(a, pose_a, pose_b);
  if constexpr (PointCored<B> || SegmentCored<B>) {
    ends_on_plane(plane, b, pose_b, settings.margin, append);
    return Outcome::ok;
  } else if constexpr (BoxCored<B>) {
    const Vec3& half = b.half();
    if (half.x > 0 && half.y > 0 && half.z > 0) [[likely]] {
      corners_on_plane(plane, half, pose_b, settings.margin, append);
      return Outcome::ok;
    }
  }
  face_on_plane(plane, b, pose_b, settings.margin, append);
  return Outcome::ok;
}

// The same in the frame of a.
template <HalfSpace A, Convex B>
[[nodiscard]] Outcome half_space_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                          Manifold& out) {
  const auto append = [&](const LaneContact& contact) { append_contact(contact, out); };
  return half_space_contacts(a, b, Pose::identity(), ab, settings, append);
}

}  // namespace abut
