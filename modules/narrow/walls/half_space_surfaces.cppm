// SPDX-License-Identifier: Apache-2.0
// A half-space against a surface: the triangles that reach lowest.
export module abut.narrow.walls.half_space_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.walls.half_space;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.points.lane_contact;

export namespace abut {

// How much heights over a plane may be off by rounding.
template <Surface B>
[[nodiscard]] Real noise_of_heights(const B& b, const PlaneBelow& plane) {
  const Aabb box = b.aabb(Pose::identity());
  return rounding_of(largest_magnitude(maximum(absolute(box.low), absolute(box.high))) + std::fabs(plane.height));
}

// A half-space against the parts that reach lowest: what lies behind the plane counts.
template <HalfSpace A, Surface B>
[[nodiscard]] Outcome half_space_parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                Distance& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  const PlaneBelow plane = plane_below(a, Pose::identity(), ab);
  // Parts that are as low as the lowest so far are passed over: of a flat surface, these would be all.
  const Real noise = noise_of_heights(b, plane);
  Real limit = infinity;
  b.visit_below(plane.local_normal, limit, [&](const typename B::Part& part, std::uint32_t) {
    Distance distance{};
    if (half_space_distance(a, part, ab, settings, distance) == Outcome::ok) {
      take_part(distance, out);
    }
    limit = out.distance - plane.height - noise;
  });
  return Outcome::ok;
}

template <HalfSpace A, Surface B>
[[nodiscard]] Outcome half_space_parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                Manifold& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const PlaneBelow plane = plane_below(a, Pose::identity(), ab);
  Real limit = settings.margin - plane.height + noise_of_heights(b, plane);
  b.visit_below(plane.local_normal, limit, [&](const typename B::Part& part, std::uint32_t index) {
    face_on_plane(plane, part, ab, settings.margin, [&](const LaneContact& contact) {
      append_contact(contact, out);
      ContactPoint& added = out.back();
      added.id = contact_id_of_part(added.id, index);
      added.feature_b = {FeatureKind::face, index};
    });
  });
  return Outcome::ok;
}

}  // namespace abut
