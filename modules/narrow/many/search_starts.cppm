// SPDX-License-Identifier: Apache-2.0
// Directions where searches for a separating translation begin.
export module abut.narrow.many.search_starts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.leaving;
export import abut.narrow.many.near_triangles;

export namespace abut {

struct SearchStart {
  Vec3 direction;
  Real estimate;  // those that are less are tried first
};
using SearchStarts = SmallVector<SearchStart, 48>;

// Of those that are alike the greater estimate counts.
void add_start(const Vec3& direction, Real estimate, SearchStarts& starts);

// The planes of what is overlapped, each with how far it is left. False where there are many. `leaves_backs`: whether
// fronts may be left through their backs.
[[nodiscard]] bool add_planes(std::span<const OverlappedFour> overlapped, bool leaves_backs, SearchStarts& starts);

// Of many: the mean normals in cells of the sphere of directions, weighted by area, but no more than a shape of a size
// can reach.
void add_mean_normals(std::span<const OverlappedFour> overlapped, Real size, bool leaves_backs, SearchStarts& starts);

// Whether a shape lies in many faces that look about the same way: within 45 degrees of a direction, or all of its
// opposite.
[[nodiscard]] bool are_ground(std::span<const OverlappedFour> overlapped, const Vec3& direction);

// Normals of the faces of a shape, and what is across its axis. They come last.
template <Convex B>
void add_own_directions(const B& b, const Pose& ab, bool are_few, SearchStarts& starts) {
  const Real size = b.extent() + b.radius();
  const Real last = are_few ? 10 * size : Real{0};
  if constexpr (leaves_by_axes<B>) {
    for (const Vec3& face : b.face_normals()) {
      if (squared_norm(face) > 0) {
        add_start(ab.rotation * face, last, starts);
        add_start(-(ab.rotation * face), last, starts);
      }
    }
    for (const Vec3& edge : b.edge_directions()) {
      if (const auto along = UnitVec3::make(ab.rotation * edge)) {
        add_start(*along, last, starts);
        add_start(-*along, last, starts);
      }
    }
  } else if constexpr (SegmentCored<B> || Rimmed<B>) {
    constexpr Real least_across = 0.05;
    const Vec3& axis = ab.rotation.z;
    const std::size_t count = starts.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto [direction, estimate] = starts[i];
      const Vec3 across = direction - dot(direction, axis) * axis;
      if (norm(across) > least_across) {
        add_start(*UnitVec3::make(across), are_few ? estimate + size : 0.1 * estimate, starts);
      }
    }
    if constexpr (Rimmed<B>) {
      add_start(axis, last, starts);
      add_start(-axis, last, starts);
    }
  }
}

}  // namespace abut
