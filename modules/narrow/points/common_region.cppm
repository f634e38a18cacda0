// SPDX-License-Identifier: Apache-2.0
// The region that two supporting faces of cores share, corner by corner. A rim is a polygon to most of them; an edge
// that lies across it ends on the circle itself, as no corner of the polygon would be as deep.
export module abut.narrow.points.common_region;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.points.clip;

export namespace abut {

// Which edge of the polygon of a rim a point of the circle lies beyond.
[[nodiscard]] inline std::uint32_t edge_of_rim(const Rim& rim, Real x, Real y) {
  std::uint32_t edge = 0;
  for (std::uint32_t i = 0; i < rim_corners; ++i) {
    const bool is_after = rim_cosine(i) * y - rim_cosine(i + 12) * x >= 0;
    const bool is_before = rim_cosine(i + 1) * y - rim_cosine(i + 13) * x < 0;
    edge = is_after && is_before ? i : edge;
  }
  return rim.first + edge;
}

// The ends of the stretch of an edge that lies over the disc of a rim, seen along a normal; none where it misses the
// disc. Edge and normal are in the frame that `placed` puts the rim in; `is_of_a`: the rim is. False where the disc
// stands too steep.
[[nodiscard]] inline bool stretch_on_rim(const Rim& rim, const Pose& placed, bool is_of_a, const Face& edge,
                                         const Vec3& normal, ClipPoints& out) {
  constexpr Real steepest_cosine = 0.05;
  const Vec3 n = placed.rotation.undo(normal);
  if (!(std::fabs(n.z) > steepest_cosine)) {
    return false;
  }
  const Vec3 start = placed.undo(edge.vertices[0].point), end = placed.undo(edge.vertices[1].point);
  const Vec3 from = start + ((rim.height - start.z) / n.z) * n, to = end + ((rim.height - end.z) / n.z) * n;
  const Real x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
  const Real aside = from.x * y - from.y * x, under = square * rim.radius * rim.radius - aside * aside;
  if (!(square > 0)) {
    return false;
  }
  if (!(under > 0)) {
    return true;
  }
  const Real middle = -(from.x * x + from.y * y) / square, half = std::sqrt(under) / square;
  // An end of the edge on the circle within a tie is an end of the stretch, on whichever side rounding puts it. Under
  // the normal of a search on curved cores it lies there within the error of that.
  const Real tie = usual_error_of_curves * std::fmin(rim.radius / std::sqrt(square), Real{1}) + noise_of(1);
  const Real enter = middle - half > tie ? middle - half : 0, leave = middle + half < 1 - tie ? middle + half : 1;
  const auto append = [&](Real t, bool is_end, std::uint32_t vertex) {
    const Vec3 on_edge = edge.vertices[0].point + t * (edge.vertices[1].point - edge.vertices[0].point);
    const Vec3 local{from.x + t * x, from.y + t * y, rim.height};
    const Vec3 on_rim = placed * local;
    const Feature of_edge =
        is_end ? Feature{FeatureKind::vertex, vertex} : Feature{FeatureKind::edge, edge.vertices[0].edge};
    const Feature of_rim =
        is_end ? Feature{FeatureKind::face, rim.index} : Feature{FeatureKind::edge, edge_of_rim(rim, local.x, local.y)};
    out.push_back(is_of_a ? ClipPoint{on_rim, on_edge, of_rim, of_edge} : ClipPoint{on_edge, on_rim, of_edge, of_rim});
  };
  if (enter > leave + tie) {
    return true;
  }
  const bool is_one_point = leave - enter <= tie;
  if (!is_one_point || leave < 1) {
    append(enter, enter == 0, edge.vertices[0].vertex);
  }
  if (!is_one_point || leave == 1) {
    append(leave, leave == 1, edge.vertices[1].vertex);
  }
  return true;
}

// Both faces in the frame of a, under a unit normal from a to b. `wants_closest`: as clip_faces has it.
template <Convex A, Convex B>
[[gnu::always_inline]] inline void find_common_region(const A& a, const B& b, const Pose& ab, const Face& face_a,
                                                      const Face& face_b, const Vec3& normal, ClipPoints& out,
                                                      bool wants_closest = true) {
  if constexpr (Rimmed<A>) {
    if (face_b.vertices.size() == 2) {
      if (const std::optional<Rim> rim = a.supporting_rim(normal);
          rim && stretch_on_rim(*rim, Pose::identity(), true, face_b, normal, out)) {
        return;
      }
    }
  }
  if constexpr (Rimmed<B>) {
    if (face_a.vertices.size() == 2) {
      if (const std::optional<Rim> rim = b.supporting_rim(ab.rotation.undo(-normal));
          rim && stretch_on_rim(*rim, ab, false, face_a, normal, out)) {
        return;
      }
    }
  }
  clip_faces(face_a, face_b, normal, out, wants_closest);
}

}  // namespace abut
