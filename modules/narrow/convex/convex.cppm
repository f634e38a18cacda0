// SPDX-License-Identifier: Apache-2.0
// Signed distance and contacts of two convex shapes from the separation of their cores. Radii are added
// at the end, so a shallow contact of rounded shapes comes exactly from the distance of the cores.
export module abut.narrow.convex;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.points.clip;
export import abut.narrow.convex.closed_forms;
import abut.narrow.convex.field_cores;
import abut.narrow.convex.settle;
import abut.narrow.points.common_region;
import abut.narrow.points.lane_contact;
import abut.narrow.points.round_lift;
import abut.narrow.points.small_polygons;
import abut.narrow.libccd;
export import abut.narrow.convex.separation;
import abut.capability;

export namespace abut {

// Rounds the cores off: both surfaces move toward each other along the normal.
[[nodiscard]] [[gnu::always_inline]] inline Distance rounded(const CoreSeparation& core, Real radius_a, Real radius_b) {
  const Real radii = radius_a + radius_b;
  return {core.distance - radii,
          core.lower - core.rounding - radii,
          core.upper + core.rounding - radii,
          core.point_a + radius_a * core.normal,
          core.point_b - radius_b * core.normal,
          core.normal,
          core.algorithm,
          core.iterations};
}

// Whether an algorithm may answer for a pair of convex shapes at all.
template <Convex A, Convex B>
[[nodiscard]] inline bool may_answer(Algorithm algorithm) {
  return !(algorithm == Algorithm::analytic && !have_closed_form<A, B>) &&
         !(algorithm == Algorithm::sat && !(FewFaced<A> && FewFaced<B>));
}

// Whether an answer is by the algorithm that was asked for. Closed forms leave cores that overlap to
// others; axes bound the distance of separated cores only from below, so they need the overlap.
[[nodiscard]] inline bool is_by(Algorithm algorithm, const CoreSeparation& core) {
  return !(algorithm == Algorithm::analytic && core.algorithm != Algorithm::analytic) &&
         !(algorithm == Algorithm::sat && !core.overlap);
}

template <Convex A, Convex B>
[[nodiscard]] inline CoreSeparation separate_for_distance(const A& a, const B& b, const Pose& ab,
                                                          const QuerySettings& settings) {
  if constexpr (are_curved_fields<A, B>) {
    if (settings.algorithm == Algorithm::automatic) {
      if (const std::optional<CoreSeparation> found = separate_fields(a, b, ab, settings)) {
        return *found;
      }
    }
  }
  return separate_cores(a, b, ab, settings, infinity);
}

template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] Outcome convex_distance_by_search(const A& a, const B& b, const Pose& ab,
                                                                  const QuerySettings& settings, Distance& out) {
  if (!may_answer<A, B>(settings.algorithm)) {
    return Outcome::unsupported;
  }
  if (settings.algorithm == Algorithm::libccd_gjk || settings.algorithm == Algorithm::libccd_mpr) {
    return libccd_distance(a, b, ab, settings, out);
  }
  CoreSeparation core = separate_for_distance(a, b, ab, settings);
  if (!is_by(settings.algorithm, core)) {
    return Outcome::unsupported;
  }
  find_points(a, b, ab, core);
  out = rounded(core, a.radius(), b.radius());
  return Outcome::ok;
}

// Closed forms, where the shapes have any and they succeed, stay in registers from the pose to the answer:
// all else gets copies of the pose and of the answer, and starts afresh.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Outcome convex_distance(const A& a, const B& b, const Pose& ab,
                                                                    const QuerySettings& settings, Distance& out) {
  if constexpr (have_closed_form<A, B>) {
    [[clang::uninitialized]] CoreSeparation core;
    if (takes_closed_forms(settings.algorithm) && separate_in_closed_form(a, b, ab, settings, core)) [[likely]] {
      out = rounded(core, a.radius(), b.radius());
      return Outcome::ok;
    }
    const Pose placed = ab;
    [[clang::uninitialized]] Distance found;
    const Outcome outcome = convex_distance_by_search(a, b, placed, settings, found);
    out = found;
    return outcome;
  } else {
    return convex_distance_by_search(a, b, ab, settings, out);
  }
}

// What a core touches with where it is closest. `direction` in its own frame, unit.
template <Convex S>
[[nodiscard]] [[gnu::always_inline]] inline Feature closest_feature(const S& shape, const Face& face,
                                                                    const Vec3& direction) {
  if constexpr (requires { shape.supporting_rim(direction)->first; }) {
    if (const auto rim = shape.supporting_rim(direction)) {
      return feature_where_deepest(rim->first, direction.x * direction.x + direction.y * direction.y);
    }
  }
  return feature_of(face);
}

// How much less deep than a separation its deepest contact may be. What a search on curved cores found is as deep as
// theirs within its bound only.
template <Convex A, Convex B>
[[nodiscard]] inline Real blur_of_contacts(const A& a, const B& b, const Pose& ab) {
  const Real size = core_size(a, b, ab), tie = tie_share * (a.extent() < b.extent() ? a.extent() : b.extent());
  return Curved<A> || Curved<B> ? curve_blur(size) : noise_of(size) + tie;
}

// Appends the corners of the region that two supporting faces share under a given separation. Where the region misses
// the closest points, it appends these too, unless they are known not to count. Returns the least distance of what it
// appends; infinity where that is nothing.
template <Convex A, Convex B>
[[gnu::always_inline]] inline Real contacts_between(const A& a, const B& b, const Pose& ab, const Face& face_a,
                                                    const Face& face_b, const CoreSeparation& core, Real margin,
                                                    bool closest_count, Manifold& out) {
  const Real radii = a.radius() + b.radius();
  const std::size_t first = out.size();
  Real least = infinity;
  const auto append = [&](const ClipPoint& point, Real reach_a, Real reach_b) {
    const Real distance = dot(point.point_b - point.point_a, core.normal) - (reach_a + reach_b);
    if (distance <= margin) {
      least = distance < least ? distance : least;
      out.push_back({point.point_a + reach_a * core.normal, point.point_b - reach_b * core.normal, core.normal,
                     distance, point.feature_a, point.feature_b, contact_id(point.feature_a, point.feature_b)});
    }
  };
  [[clang::uninitialized]] ClipPoints points;
  find_common_region(a, b, ab, face_a, face_b, core.normal, points, closest_count);
  const RoundLift<A> lift_a(a, Pose::identity(), core.normal, true);
  const RoundLift<B> lift_b(b, ab, -core.normal, false);
  for (const ClipPoint& point : points.span()) {
    const std::optional<Real> reach_a = lift_a(point, point.point_a, points.span()),
                              reach_b = lift_b(point, point.point_b, points.span());
    if (reach_a && reach_b) {
      append(point, *reach_a, *reach_b);
    }
  }
  // Where the region misses the closest points, as between edges that cross, they are the contact.
  const Real size = core_size(a, b, ab);
  if (closest_count && (out.size() == first || least > core.distance - radii + blur_of_contacts(a, b, ab))) {
    CoreSeparation closest = core;
    if constexpr (Curved<A> || Curved<B>) {
      if (closest.points_open && !find_round_witness(a, b, ab, closest) &&
          !find_witness_over_face(face_a, face_b, closest)) {
        find_points_of_faces(face_a, face_b, points, size, closest);
      }
    } else if (closest.points_open) {
      find_points_of_faces(face_a, face_b, points, size, closest);
    }
    append({closest.point_a, closest.point_b, closest_feature(a, face_a, core.normal),
            closest_feature(b, face_b, ab.rotation.undo(-core.normal))},
           a.radius(), b.radius());
  }
  number_apart(std::span(out).subspan(first));
  return least;
}

// The same for what faces the normal of a separation.
template <Convex A, Convex B>
Real contacts_under(const A& a, const B& b, const Pose& ab, const CoreSeparation& core, Real margin, bool closest_count,
                    Manifold& out) {
  if constexpr (FewCornered<A> && FewCornered<B> && !have_closed_contacts<A, B>) {
    const ContactsWanted wanted{core.normal,  core.distance - (a.radius() + b.radius()),
                                a.radius(),   b.radius(),
                                margin,       blur_of_contacts(a, b, ab),
                                closest_count};
    const FewCorners corners_a = few_corners(a, core.normal, core.features.a),
                     corners_b = placed_few_corners(b, ab, -core.normal, core.features.b);
    if (const auto least = append_contacts_of(corners_a, corners_b, wanted, out)) {
      return *least;
    }
  }
  if (!meet_in_a_point<A, B>(ab)) {
    [[clang::uninitialized]] const Face face_a = supporting_face(a, core.normal, core.features.a);
    [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal, core.features.b);
    return contacts_between(a, b, ab, face_a, face_b, core, margin, closest_count, out);
  }
  if (closest_count) {
    CoreSeparation closest = core;
    find_points(a, b, ab, closest);
    const Real distance = dot(closest.point_b - closest.point_a, core.normal) - (a.radius() + b.radius());
    if (distance <= margin) {
      const Feature feature_a = supporting_feature(a, core.normal);
      const Feature feature_b = supporting_feature(b, ab.rotation.undo(-core.normal));
      out.push_back({closest.point_a + a.radius() * core.normal, closest.point_b - b.radius() * core.normal,
                     core.normal, distance, feature_a, feature_b, contact_id(feature_a, feature_b)});
      return distance;
    }
  }
  return infinity;
}

// The separation that contacts are made from.
template <Convex A, Convex B>
[[nodiscard]] inline CoreSeparation separate_for_contacts(const A& a, const B& b, const Pose& ab,
                                                          const QuerySettings& settings) {
  CoreSeparation core = separate_cores(a, b, ab, settings, settings.margin + (a.radius() + b.radius()));
  if constexpr (are_featured<A, B>) {
    if (settings.algorithm == Algorithm::automatic && core.overlap &&
        (core.algorithm == Algorithm::gjk_epa || core.algorithm == Algorithm::rims)) {
      const Real size = core_size(a, b, ab);
      settle_on_features(a, b, ab, size, error_of(a, b, size, settings), core);
    }
  }
  if constexpr (are_side_and_polytope<A, B>) {
    if (settings.algorithm == Algorithm::automatic && !core.beyond && !core.features.are_known()) {
      const Real size = core_size(a, b, ab);
      settle_on_side(a, b, ab, size, error_of(a, b, size, settings), core);
    }
  }
  return core;
}

template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] Outcome convex_contacts_by_search(const A& a, const B& b, const Pose& ab,
                                                                  const QuerySettings& settings, Manifold& out) {
  if (!may_answer<A, B>(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const Real radii = a.radius() + b.radius();
  CoreSeparation core{};
  if (settings.algorithm == Algorithm::libccd_gjk || settings.algorithm == Algorithm::libccd_mpr) {
    Distance found{};
    const Outcome outcome = libccd_distance(a, b, ab, settings, found);
    if (outcome == Outcome::apart || (outcome == Outcome::ok && found.distance > settings.margin)) {
      return Outcome::ok;
    }
    if (outcome != Outcome::ok) {
      return outcome;
    }
    core.normal = found.normal;
    core.distance = found.distance + radii;
    core.point_a = found.point_a - a.radius() * found.normal;
    core.point_b = found.point_b + b.radius() * found.normal;
  } else {
    core = separate_for_contacts(a, b, ab, settings);
    if (core.beyond || core.distance - radii > settings.margin) {
      return Outcome::ok;
    }
    if (!is_by(settings.algorithm, core)) {
      return Outcome::unsupported;
    }
  }
  contacts_under(a, b, ab, core, settings.margin, true, out);
  return Outcome::ok;
}

// As with distances, closed forms stay in registers where they succeed.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Outcome convex_contacts(const A& a, const B& b, const Pose& ab,
                                                                    const QuerySettings& settings, Manifold& out) {
  if constexpr (have_closed_contacts<A, B>) {
    const auto append = [&](const LaneContact& contact) { append_contact(contact, out); };
    if (contacts_in_closed_form(a, b, ab, settings, append)) [[likely]] {
      return Outcome::ok;
    }
    const Pose placed = ab;
    return convex_contacts_by_search(a, b, placed, settings, out);
  } else {
    return convex_contacts_by_search(a, b, ab, settings, out);
  }
}

}  // namespace abut
