// SPDX-License-Identifier: Apache-2.0
// Contacts of a convex shape with a surface, under the planes that hold the shape: those that it touches after the
// separating translation, and those of faces and features that it overlaps and that look the same way. A normal lies in
// the cone of normals of the whole surface by construction: where a neighbour reaches further, the shape would still
// overlap it.
export module abut.narrow.surface.contacts_under_planes;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.ways.continuation;
import abut.narrow.triangle.four_nearest;
import abut.narrow.ways.least_translation;
import abut.narrow.ways.leaving;
import abut.narrow.triangle.outermost_corners;
import abut.narrow.surface.separating_translation;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Whether the contact lies in the face of its triangle, on an edge or at a corner of it, which lie flat between two
// triangles: those are where the surface is cut, and no part of its shape.
[[nodiscard]] bool is_on_a_cut(const TriangleSource& surface, const Triangle& triangle, const Vec3& normal,
                               const Feature& feature, Real noise) {
  const auto is_flat = [&](std::uint32_t edge) {
    const Vec3 &from = triangle.corners()[edge], &to = triangle.corners()[(edge + 1) % 3];
    const unsigned ends = 1u << edge | 1u << ((edge + 1) % 3);
    const auto outward = UnitVec3::make(cross(to - from, triangle.normal()));
    return outward && surface.is_crest(triangle.index(), ends, normal, noise) &&
           surface.is_crest(triangle.index(), ends, -normal, noise) &&
           !surface.is_crest(triangle.index(), ends, *outward, noise);
  };
  if (feature.kind == FeatureKind::edge) {
    return is_flat(feature.index);
  }
  return feature.kind == FeatureKind::vertex && is_flat(feature.index) && is_flat((feature.index + 2) % 3);
}

// Whether one of fours of triangles holds a point of the surface and rises there: at a crack or a T-junction. `size`:
// of the smaller one of what meets.
template <class Fours>
[[nodiscard]] bool rises_at(const Fours& fours, const Vec3& point, const Vec3& normal, Real size, Real noise) {
  const Columns at = Columns::all(point), along = Columns::all(normal);
  return std::ranges::any_of(fours, [&](const auto& four) {
    const FourTriangles& t = four.triangles;
    const Lanes extent = maximum(largest_magnitude(t.b - t.a), largest_magnitude(t.c - t.a));
    const Lanes reach = crack_share * minimum(extent, all_lanes(size)) + noise;
    const Lanes rise = maximum(maximum(dot(along, t.a - at), dot(along, t.b - at)), dot(along, t.c - at));
    const std::uint64_t rising = four.present & bits_of(rise > 2 * reach);
    return rising != 0 && (rising & bits_of(FourNearest(t, point).square <= reach * reach)) != 0;
  });
}

// Whether two contacts are at the same place, on shapes of a size.
[[nodiscard]] inline bool is_same_place(const ContactPoint& one, const ContactPoint& other, Real size) {
  constexpr Real same_place = 1e-7;
  return squared_norm(one.point_b - other.point_b) <= same_place * size * (same_place * size);
}

// Whether one of the contacts so far is at the same place, and then the deeper one of both.
[[nodiscard]] inline bool is_told(const ContactPoint& contact, std::span<ContactPoint> so_far, Real size) {
  for (ContactPoint& known : so_far) {
    if (dot(known.normal, contact.normal) > same_normal && is_same_place(contact, known, size)) {
      if (contact.distance < known.distance) {
        known.point_a = contact.point_a;
        known.point_b = contact.point_b;
        known.normal = contact.normal;
        known.distance = contact.distance;
      }
      return true;
    }
  }
  return false;
}

// Whether the shortest translation that leaves the planes of all contacts is as long as the one that was found.
[[nodiscard]] inline bool do_part(std::span<const ContactPoint> contacts, Real length, Real tolerance) {
  constexpr std::size_t most_planes = 8;
  SmallVector<HalfSpaceToLeave, most_planes> planes;
  Real deepest = 0;
  for (const ContactPoint& contact : contacts) {
    deepest = std::max(deepest, -contact.distance);
    bool is_known = false;
    for (HalfSpaceToLeave& known : planes.span()) {
      if (dot(known.normal, contact.normal) > same_normal) {
        known.least = std::max(known.least, -contact.distance);
        is_known = true;
      }
    }
    if (!is_known && contact.distance < 0 && planes.size() < most_planes) {
      planes.push_back({contact.normal, -contact.distance});
    }
  }
  const Real enough = length * (1 - share_slack) - 2 * tolerance;
  if (deepest >= enough) {
    return true;
  }
  const auto move = planes.empty() ? std::nullopt : least_translation(planes.span());
  return move && norm(*move) >= enough;
}

template <Convex B>
class [[gsl::Pointer]] ContactsUnderPlanes {
 public:
  ContactsUnderPlanes(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings,
                      SurfaceSearch<B>& search, Manifold& out)
      : surface_(surface), b_(b), ab_(ab), settings_(settings), search_(search), out_(out), first_(out.size()) {}

  // `translation`: the one found where something is overlapped.
  void append(const SeparatingTranslation* translation) {
    if (translation != nullptr) {
      most_ = translation->length;
      if (surface_.sides() == StoppingSides::solid) {
        // What is inside may meet faces further on.
        beyond_ = b_.aabb({ab_.rotation, ab_.position + translation->length * translation->direction});
      }
      add_touches(*translation);
      add_overlapped(*translation);
    }
    add_apart(translation != nullptr);
    // In the order of the triangles that lend them: depths that tie change places with each jitter.
    std::ranges::sort(planes_.span(), {}, &Plane::number);
    for (std::uint32_t i = 0; i < planes_.size(); ++i) {
      append_under(planes_[i], i);
    }
    if (translation != nullptr && !do_part(std::span(out_).subspan(first_), translation->length, search_.tolerance())) {
      append_whole(*translation);
    }
    if (translation == nullptr) {
      append_nearest();
    }
  }

 private:
  struct Plane {
    Vec3 normal;
    CoreSeparation core;  // along the normal, of the triangle that lends it
    NearPlace at;
    std::uint32_t number;  // of that triangle
    bool has_closest;      // whether the points of the separation are the closest ones of that triangle
  };

  static constexpr Real same_direction = 1e-12;  // of unit vectors

  void add(const Vec3& normal, const CoreSeparation& core, const NearPlace& at, bool has_closest) {
    if (std::ranges::none_of(planes_.span(),
                             [&](const Plane& known) { return dot(known.normal, normal) > same_normal; })) {
      planes_.push_back({normal, core, at, search_.number_at(at), has_closest});
    }
  }

  // What a touch after the translation says of the shape before it.
  [[nodiscard]] CoreSeparation separation_before(const SurfaceTouch& touch, const Vec3& move) const {
    const Triangle triangle = search_.triangle_at(touch.at);
    CoreSeparation core = separate_along(triangle, touch.normal);
    if (!is_along(touch.normal, triangle.normal())) {
      const CoreSeparation after = separate_outside(triangle, b_, {ab_.rotation, ab_.position + move}, settings_);
      CoreSeparation closest = after;
      find_points(triangle, b_, {ab_.rotation, ab_.position + move}, closest);
      core.point_b = closest.point_b - move;
      core.point_a = core.point_b - core.distance * core.normal;
      core.points_open = false;
    }
    return core;
  }
  [[nodiscard]] CoreSeparation separate_along(const Triangle& triangle, const Vec3& normal) const {
    CoreSeparation core{};
    core.normal = normal;
    core.point_b = placed_support(b_, place(b_, ab_), -normal).point;
    core.distance = core.lower = core.upper = dot(normal, core.point_b - triangle.support(normal).point);
    core.point_a = core.point_b - core.distance * normal;
    core.overlap = core.distance < 0;
    core.algorithm = Algorithm::gjk_epa;
    return core;
  }

  void add_touches(const SeparatingTranslation& translation) {
    const Vec3 move = translation.length * translation.direction;
    for (const SurfaceTouch& touch : translation.touches.span()) {
      const NearFour& four = search_.find_planes(touch.at.four);
      const bool is_one_sided = (four.one_sided >> touch.at.lane & 1u) != 0;
      // A feature that is touched after a translation aslant lies beside the shape before it.
      const Vec3 aslant = touch.normal - translation.direction;
      const bool is_face = is_along(touch.normal, four.normals[touch.at.lane]);
      if ((is_face || largest_magnitude(aslant) <= same_direction) &&
          (!is_one_sided || dot(four.normals[touch.at.lane], touch.normal) >= least_cosine_of_front)) {
        add(touch.normal, separation_before(touch, move), touch.at, !is_face);
      }
      if (!is_face) {
        add_face_touched(touch, translation);
      }
    }
  }
  // A corner on the border of a face touches both.
  void add_face_touched(const SurfaceTouch& touch, const SeparatingTranslation& translation) {
    constexpr Real near_share = 1e-7;
    const Triangle triangle = search_.triangle_at(touch.at);
    const Real along = dot(triangle.normal(), translation.direction);
    if (!triangle.has_area() || (triangle.is_one_sided() && along < 0)) {
      return;
    }
    const Vec3 normal = along < 0 ? -triangle.normal() : triangle.normal();
    const Real before = dot(normal, triangle.corners()[0]) - lowest_point_along(b_, ab_, normal);
    if (std::fabs(before - std::fabs(along) * translation.length) <= near_share * (b_.extent() + b_.radius())) {
      add(normal, separate_along(triangle, normal), touch.at, false);
    }
  }

  // The planes of faces under the lowest point of the shape, and the ways out of single triangles that lead out of the
  // surface.
  void add_overlapped(const SeparatingTranslation& translation) {
    constexpr Real least_along = 1e-6;
    for (const NearTriangle& near : search_.near()) {
      if (!near.is_overlapped) {
        continue;
      }
      const Triangle triangle = search_.triangle_at(near.at);
      const Real along = dot(triangle.normal(), translation.direction);
      if (triangle.has_area() && (triangle.is_one_sided() ? along > least_along : std::fabs(along) > least_along)) {
        const Vec3 normal = along > 0 ? triangle.normal() : -triangle.normal();
        const Real depth = along > 0 ? near.behind : near.before;
        if (depth <= most_ * (1 + share_slack) + search_.tolerance()) {
          const CoreSeparation core = along_face(triangle, b_, ab_, near.found.core, normal);
          if (is_over(triangle, core.point_a)) {
            add(normal, core, near.at, true);
          }
        }
      }
      const CoreSeparation& own = near.found.core;
      if (dot(own.normal, translation.direction) > least_along && !is_along(own.normal, triangle.normal()) &&
          Fronts<B>(triangle, b_, ab_).allows(own.normal) && is_of_surface(triangle, near)) {
        add(own.normal, completed(triangle, b_, ab_, near.found), near.at, true);
      }
    }
  }
  // Of what is not overlapped, or by no more than ends a search.
  void add_apart(bool is_overlapped) {
    for (const NearTriangle& near : search_.near()) {
      const Triangle triangle = search_.triangle_at(near.at);
      if (!(is_overlapped && near.is_overlapped) && Fronts<B>(triangle, b_, ab_).allows(near.found.core.normal) &&
          is_of_surface(triangle, near)) {
        add(near.found.core.normal, completed(triangle, b_, ab_, near.found), near.at, true);
      }
    }
  }
  // Whether no neighbour reaches further along the normal of a separation.
  [[nodiscard]] bool is_of_surface(const Triangle& triangle, const NearTriangle& near) const {
    const CoreSeparation& core = near.found.core;
    const Real noise = noise_of(core_size(triangle, b_, ab_));
    if (!triangle.has_area() || is_along(core.normal, triangle.normal())) {
      return true;
    }
    const unsigned corners = outermost_corners(triangle.corners(), core.normal, noise);
    if (corners != 7 && !surface_.is_crest(triangle.index(), corners, core.normal, noise)) {
      return false;
    }
    const CoreSeparation whole = completed(triangle, b_, ab_, near.found);
    return surface_.is_terrain() ||
           !rises_at(search_.fours(), whole.point_a, core.normal, b_.extent() + b_.radius(), noise);
  }
  void append_under(const Plane& plane, std::uint32_t ordinal) {
    const Triangle lender = search_.triangle_at(plane.at);
    const bool is_face = is_along(plane.normal, lender.normal());
    if constexpr (PointCored<B>) {
      if (!is_face) {
        append_from(plane, lender, plane.core, true, ordinal);
        return;
      }
    } else if (!is_face) {
      append_from_feature(plane, lender, ordinal);
    }
    append_faces(plane, ordinal);
    if constexpr (!PointCored<B>) {
      append_features(plane, ordinal);
    }
  }

  // The touch after the translation, as a contact along it.
  void append_whole(const SeparatingTranslation& translation) {
    if (!(-translation.length <= settings_.margin) || translation.touches.empty()) {
      return;
    }
    const Triangle triangle = search_.triangle_at(last_touch(translation).at);
    const Vec3 move = translation.length * translation.direction;
    const Vec3 point_b = search_.last_point(translation, b_);
    const Feature feature_a{FeatureKind::face, triangle.index()},
        feature_b = supporting_feature(b_, ab_.rotation.undo(-translation.direction));
    out_.push_back({point_b + move, point_b, translation.direction, -translation.length, feature_a, feature_b,
                    mixed(~contact_id({FeatureKind::whole, 0}, {FeatureKind::whole, 0}))});
  }

  // Rounding may leave the nearest point in the cone of no triangle. Then the nearest triangle has a contact after all.
  void append_nearest() {
    const NearTriangle* nearest = nullptr;
    for (const NearTriangle& near : search_.near()) {
      if (Fronts<B>(search_.triangle_at(near.at), b_, ab_).allows(near.found.core.normal) &&
          (nearest == nullptr || near.gap < nearest->gap)) {
        nearest = &near;
      }
    }
    if (nearest == nullptr) {
      return;
    }
    const Triangle triangle = search_.triangle_at(nearest->at);
    const Real noise = touching_within<B>(core_size(triangle, b_, ab_), settings_);
    const auto is_as_near = [&](const ContactPoint& contact) { return contact.distance <= nearest->gap + noise; };
    if (std::ranges::none_of(std::span(out_).subspan(first_), is_as_near)) {
      const CoreSeparation core = completed(triangle, b_, ab_, nearest->found);
      append_from({core.normal, core, nearest->at, triangle.index(), true}, triangle, core, true,
                  static_cast<std::uint32_t>(planes_.size()));
    }
  }

  // Of all triangles in planes of this normal.
  void append_faces(const Plane& plane, std::uint32_t ordinal) {
    const Real lowest = lowest_point_along(b_, ab_, plane.normal);
    const Columns normal = Columns::all(plane.normal);
    const Real reach = std::max(settings_.margin, Real{0}) + search_.tolerance();
    Aabb box = b_.aabb(ab_).inflated(reach);
    box.include(beyond_);
    SmallVector<NearPlace, 128> places;
    for (std::uint32_t i = 0; i < search_.fours().size(); ++i) {
      std::uint64_t left = search_.fours()[i].present & search_.fours()[i].triangles.overlapping(box);
      if (left == 0) {
        continue;
      }
      const NearFour& four = search_.find_planes(i);
      const Lanes along = dot(four.normals, normal);
      const Lanes depth = (along > all_lanes(0) ? four.heights : -four.heights) - lowest;
      left &= bits_of((absolute(along) > all_lanes(same_normal)) & (depth >= all_lanes(-reach)) &
                      (depth <= all_lanes(most_ * (1 + share_slack) + search_.tolerance()))) &
              ~(four.one_sided & bits_of(along < all_lanes(0)));
      for (; left != 0; left &= left - 1) {
        places.push_back({i, static_cast<std::uint32_t>(std::countr_zero(left))});
      }
    }
    search_.sort_by_number(places.span());
    for (const NearPlace& place : places.span()) {
      const Triangle triangle = search_.triangle_at(place);
      if (plane.has_closest && triangle.index() == plane.number) {
        append_from(plane, triangle, plane.core, true, ordinal);
        continue;
      }
      const Vec3 face = triangle.normal();
      const CoreSeparation core = along_face(triangle, b_, ab_, plane.core, dot(face, plane.normal) > 0 ? face : -face);
      append_from(plane, triangle, core, is_over(triangle, core.point_a), ordinal);
    }
  }
  void append_from(const Plane& plane, const Triangle& triangle, const CoreSeparation& core, bool closest_count,
                   std::uint32_t ordinal) {
    const std::size_t first = out_.size();
    contacts_under(triangle, b_, ab_, core, settings_.margin, closest_count, out_);
    const bool is_face = is_along(plane.normal, triangle.normal());
    keep(first, triangle, is_face, ordinal);
  }

  // Edges and vertices of what is overlapped that are outermost of the surface along the normal, beside the triangle
  // that lends it.
  void append_features(const Plane& plane, std::uint32_t ordinal) {
    for (const NearTriangle& near : search_.near()) {
      if (!near.is_overlapped || search_.number_at(near.at) == plane.number) {
        continue;
      }
      const Triangle triangle = search_.triangle_at(near.at);
      const Real along = dot(triangle.normal(), plane.normal);
      if ((triangle.has_area() && along > same_normal) || (triangle.is_one_sided() && along < least_cosine_of_front)) {
        continue;
      }
      append_from_feature(plane, triangle, ordinal);
    }
  }
  void append_from_feature(const Plane& plane, const Triangle& triangle, std::uint32_t ordinal) {
    const Real noise = noise_of(core_size(triangle, b_, ab_));
    const unsigned corners = outermost_corners(triangle.corners(), plane.normal, noise);
    const bool is_lender = triangle.index() == plane.number;
    CoreSeparation core = is_lender ? plane.core : separate_along(triangle, plane.normal);
    if (-core.distance + b_.radius() > most_ * (1 + share_slack) + search_.tolerance() ||
        core.distance - b_.radius() > std::max(settings_.margin, Real{0})) {
      return;
    }
    if (!is_lender && (corners == 7 || !surface_.is_crest(triangle.index(), corners, plane.normal, noise))) {
      return;
    }
    [[clang::uninitialized]] Face face;
    face.index = 0;
    face.normal = {0, 0, 0};
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      if ((corners >> corner & 1u) != 0) {
        const std::uint32_t next = (corner + 1) % 3;
        face.vertices.push_back({triangle.corners()[corner], corner, (corners >> next & 1u) != 0 ? corner : next});
      }
    }
    if (face.vertices.size() == 2) {
      // The edge that leads from one of them to the other.
      const std::uint32_t edge = corners == 3 ? 0 : corners == 6 ? 1 : 2;
      face.vertices[0].edge = face.vertices[1].edge = edge;
    }
    const std::size_t first = out_.size();
    const Face other = placed_face(b_, ab_, -plane.normal);
    contacts_between(triangle, b_, ab_, face, other, core, settings_.margin, is_lender, out_);
    if (is_lender && !core.points_open) {
      settle_closest(first, core, feature_of(face), closest_feature(b_, other, ab_.rotation.undo(-core.normal)));
    }
    keep(first, triangle, false, ordinal);
  }
  // The corners of a region come near the closest points within ties of features. The closest points are exact.
  void settle_closest(std::size_t first, const CoreSeparation& core, const Feature& of_a, const Feature& of_b) {
    const Real distance = core.distance - b_.radius();
    if (!(distance <= settings_.margin)) {
      return;
    }
    const ContactPoint closest{
        core.point_a,          core.point_b - b_.radius() * core.normal, core.normal, distance, of_a, of_b,
        contact_id(of_a, of_b)};
    ContactPoint* nearest = nullptr;
    for (ContactPoint& contact : std::span(out_).subspan(first)) {
      nearest = nearest == nullptr || contact.distance < nearest->distance ? &contact : nearest;
    }
    if (nearest == nullptr) {
      out_.push_back(closest);
    } else if (nearest->distance > distance) {
      const bool is_same = is_same_place(*nearest, closest, b_.extent() + b_.radius());
      if (!is_same && nearest->distance > distance + noise_of(size_of_b())) {
        out_.push_back(closest);
      } else if (is_same) {
        nearest->point_a = closest.point_a;
        nearest->point_b = closest.point_b;
        nearest->distance = distance;
      }
    }
  }
  [[nodiscard]] Real size_of_b() const { return largest_magnitude(ab_.position) + b_.extent() + b_.radius(); }
  // Names the contacts from `first` on, and takes out those that another triangle has told, or that lie where the
  // surface is cut.
  void keep(std::size_t first, const Triangle& triangle, bool is_face, std::uint32_t ordinal) {
    const Real size = core_size(triangle, b_, ab_), noise = noise_of(size);
    std::size_t kept = first;
    for (std::size_t i = first; i < out_.size(); ++i) {
      ContactPoint contact = out_[i];
      if (-contact.distance > most_ * (1 + share_slack) + search_.tolerance() ||
          (is_face && is_on_a_cut(surface_, triangle, contact.normal, contact.feature_a, noise)) ||
          is_told(contact, std::span(out_).subspan(first_, kept - first_), b_.extent() + b_.radius())) {
        continue;
      }
      const bool is_in_face =
          contact.feature_a.kind == FeatureKind::face || contact.feature_a.kind == FeatureKind::whole;
      contact.id = is_in_face ? contact_id_of_part(contact_id({FeatureKind::face, 0}, contact.feature_b), ordinal)
                              : contact_id_of_part(contact.id, surface_.number_in_shape(triangle.index()));
      contact.feature_a = {FeatureKind::face, triangle.index()};
      out_[kept++] = contact;
    }
    out_.resize(kept, ContactPoint{});
  }
  const TriangleSource& surface_;
  const B& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  SurfaceSearch<B>& search_;
  Manifold& out_;
  std::size_t first_;
  Real most_ = infinity;  // how deep a contact may be
  Aabb beyond_ = Aabb::empty();
  SmallVector<Plane, 12> planes_;
};

}  // namespace abut
