// SPDX-License-Identifier: Apache-2.0
// Contacts of two surfaces, pair by pair of their triangles. Pairs that touch after the separating translation have the
// normal of that touch, others those of their faces and edges. Such a normal counts where both surfaces lie behind the
// plane across it, each on its side.
module abut.narrow.two_surfaces.two_sources;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.surface.contacts_under_planes;
import abut.narrow.ways.continuation;
import abut.narrow.two_surfaces.crossing_surfaces;
import abut.narrow.two_surfaces.leaving_pairs;
import abut.narrow.ways.least_translation;
import abut.narrow.triangle.outermost_corners;
import abut.narrow.two_surfaces.placed_triangles;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

namespace abut {
namespace {

constexpr Pose here = Pose::identity();
// A face that leans by less than this angle, in radians, lies on another one with all its corners.
constexpr Real lean_of_faces = 0.01;

class [[gsl::Pointer]] Contacts {
 public:
  Contacts(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
           CrossingSurfaces& surfaces, bool is_swapped, Manifold& out)
      : a_(a), b_(b), ab_(ab), settings_(settings), surfaces_(surfaces), is_swapped_(is_swapped), out_(out) {}

  // `translation`: the one found where both meet.
  void append(const std::optional<SeparatingTranslation>& translation) {
    if (translation) {
      most_ = translation->length * (1 + share_slack) + surfaces_.tolerance();
      append_touched(*translation);
    }
    for (const NearPair& pair : surfaces_.near()) {
      if (translation && pair.is_overlapped) {
        append_overlapped(pair, *translation);
      } else {
        append_apart(pair);
      }
    }
    if (translation && translation->ends_behind) {
      append_jammed();
    } else if (translation && !do_part(std::span(out_).subspan(first_), translation->length, surfaces_.tolerance())) {
      append_whole(*translation);
    }
    if (!translation) {
      append_nearest();
    }
  }

 private:
  void append_touched(const SeparatingTranslation& translation) {
    constexpr Real same_direction = 1e-12;  // of unit vectors
    SmallVector<TouchedPair, 32> touched;
    surfaces_.visit_touched(translation, [&](const TouchedPair& pair) { touched.push_back(pair); });
    std::ranges::sort(touched.span(), {},
                      [](const TouchedPair& pair) { return std::tuple(pair.a.number, pair.b.number); });
    for (const TouchedPair& pair : touched.span()) {
      if (!last_ || pair.length > last_->length) {
        last_ = pair;
      }
      const Triangle a = pair.a.part(), b = pair.b.part();
      if (!Fronts<Triangle>(a, b, here).allows(pair.normal)) {
        continue;
      }
      const std::size_t first = out_.size();
      if (is_along(pair.normal, a.normal())) {
        append_under_face_of_a(a, b, pair.normal);
      } else if (is_along(pair.normal, b.normal())) {
        append_under_face_of_b(a, b, pair.normal);
      } else if (largest_magnitude(pair.normal - translation.direction) <= same_direction) {
        // Features that are touched after a translation aslant lie beside each other before it.
        CoreSeparation core = along(pair.normal, pair.length);
        core.point_b = last_point_of(pair.a.corners, pair.b.corners, translation.direction, pair.length);
        core.point_a = core.point_b + pair.length * pair.normal;
        append_under(a, b, core, true);
      }
      if (is_steep(a, pair.normal) || is_steep(b, pair.normal)) {
        keep_touched(first, -pair.length * dot(pair.normal, translation.direction));
      }
    }
  }

  // What is jammed between fronts is pushed to the front of each.
  void append_overlapped(const NearPair& pair, const SeparatingTranslation& translation) {
    constexpr Real along_way = 1e-6;
    const Real least_along = translation.ends_behind ? -1 : along_way;
    const Vec3& direction = translation.direction;
    const Triangle a = pair.a.part(), b = pair.b.part();
    const Fronts<Triangle> fronts(a, b, here);
    const auto toward = [&](const Vec3& normal) {
      const bool is_turned = translation.ends_behind ? !fronts.allows(normal) : dot(normal, direction) < 0;
      return is_turned ? -normal : normal;
    };
    const auto leads_on = [&](const Vec3& normal) {
      return dot(normal, direction) > least_along && fronts.allows(normal);
    };
    // Neither reaches further behind the face of the other one than the translation leads.
    const auto is_held = [&](const Vec3& normal) {
      return -abut::least_along(a.corners(), -normal) - abut::least_along(b.corners(), normal) <= most_;
    };
    if (const Vec3 normal = toward(a.normal());
        leads_on(normal) && is_held(normal) && is_of_b(pair.b, normal, lean_of_faces)) {
      append_under_face_of_a(a, b, normal);
      visit_beside(a_, a_.part(a.index()), surfaces_.triangles_of_a(), normal, a, b,
                   [&](const Triangle& other) { append_under_face_of_a(other, b, normal); });
    }
    if (const Vec3 normal = toward(b.normal());
        leads_on(normal) && is_held(normal) && is_of_a(pair.a, normal, lean_of_faces)) {
      append_under_face_of_b(a, b, normal);
      visit_beside(b_, local(b), surfaces_.triangles_of_b(), normal, b, a,
                   [&](const Triangle& other) { append_under_face_of_b(a, other, normal); });
    }
    const Vec3& own = pair.found.core.normal;
    if (leads_on(own) && !is_along(own, a.normal()) && !is_along(own, b.normal())) {
      append_own(pair);
    }
  }
  // Calls visit(triangle) for what goes on beside a face, in its plane, near a triangle of the other surface: that may
  // lie over it without being overlapped. `local`: the face in the frame of its surface.
  template <class Visitor>
  void visit_beside(const SurfaceSource& surface, const Triangle& local, const PlacedTriangles& near,
                    const Vec3& normal, const Triangle& face, const Triangle& other, const Visitor& visit) const {
    const Real noise = surfaces_.touching();
    constexpr std::array<unsigned, 3> edges{0b011, 0b110, 0b101};
    if (std::ranges::none_of(edges, [&](unsigned ends) {
          return surface.is_crest(local.index(), ends, local.normal(), noise) &&
                 surface.is_crest(local.index(), ends, -local.normal(), noise);
        })) {
      return;
    }
    const Columns along = Columns::all(normal);
    const Real height = dot(normal, face.corners()[0]);
    const Aabb box = other.box().inflated(most_ < infinity ? most_ : noise);
    for (const PlacedFour& four : near.fours()) {
      std::uint64_t left = four.present & four.triangles.overlapping(box);
      if (left == 0) {
        continue;
      }
      const Lanes cosine = dot(four.normals, along);
      left &= bits_of((absolute(cosine) > all_lanes(same_normal)) &
                      (absolute(dot(along, four.triangles.a) - height) <= all_lanes(noise)));
      for (; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t number = std::span(four.triangles.numbers)[lane];
        if (number != face.index()) {
          visit(Triangle(four.triangles[lane], number, (four.one_sided >> lane & 1u) != 0));
        }
      }
    }
  }
  void append_apart(const NearPair& pair) { append_own(pair); }
  // The separation of two triangles, where it is one of their surfaces.
  void append_own(const NearPair& pair) {
    const Vec3& normal = pair.found.core.normal;
    if (!is_of_a(pair.a, normal, 0) || !is_of_b(pair.b, normal, 0)) {
      return;
    }
    const Triangle a = pair.a.part(), b = pair.b.part();
    const CoreSeparation core = completed(a, b, here, pair.found);
    const Real noise = noise_of(core_size(a, b, here));
    const auto rises = [&](bool shares_corners, const Triangle& of, const PlacedTriangles& near, const Vec3& point,
                           const Vec3& outward) {
      return !shares_corners && !is_along(outward, of.normal()) &&
             rises_at(near.fours(), point, outward, surfaces_.size(), noise);
    };
    if (!rises(a_.is_terrain(), a, surfaces_.triangles_of_a(), core.point_a, normal) &&
        !rises(b_.is_terrain(), b, surfaces_.triangles_of_b(), core.point_b, -normal)) {
      append_under(a, b, core, true);
    }
  }

  // Whether no neighbour of a triangle reaches further along a normal, but for what leans. `local`: the same in the
  // frame of the surface.
  [[nodiscard]] bool is_of_surface(const SurfaceSource& surface, const PlacedTriangle& triangle, const Vec3& normal,
                                   const Vec3& local, Real lean) const {
    const Triangle part = triangle.part();
    if (!part.has_area() || is_along(normal, part.normal())) {
      return true;
    }
    const Vec3 extent = part.box().high - part.box().low;
    const Real noise = std::max(surfaces_.touching(), lean * largest_magnitude(extent));
    const unsigned corners = outermost_corners(triangle.corners, normal, noise);
    return corners == 7 || surface.is_crest(triangle.number, corners, local, noise);
  }
  [[nodiscard]] bool is_of_a(const PlacedTriangle& triangle, const Vec3& normal, Real lean) const {
    return is_of_surface(a_, triangle, normal, normal, lean);
  }
  [[nodiscard]] bool is_of_b(const PlacedTriangle& triangle, const Vec3& normal, Real lean) const {
    return is_of_surface(b_, triangle, -normal, -ab_.rotation.undo(normal), lean);
  }

  [[nodiscard]] static CoreSeparation along(const Vec3& normal, Real depth) {
    CoreSeparation core{};
    core.normal = normal;
    core.distance = core.lower = core.upper = -depth;
    core.overlap = depth > 0;
    core.algorithm = Algorithm::gjk_epa;
    return core;
  }
  void append_under_face_of_a(const Triangle& a, const Triangle& b, const Vec3& normal) {
    const Vec3 exact = dot(normal, a.normal()) < 0 ? -a.normal() : a.normal();
    const CoreSeparation core = along_face(a, b, here, along(normal, 0), exact);
    append_under(a, b, core, is_over(a, core.point_a));
  }
  void append_under_face_of_b(const Triangle& a, const Triangle& b, const Vec3& normal) {
    const Vec3 exact = dot(normal, b.normal()) < 0 ? -b.normal() : b.normal();
    const CoreSeparation core = along_other_face(a, b, here, along(normal, 0), exact);
    append_under(a, b, core, is_over(b, core.point_b));
  }
  void append_under(const Triangle& a, const Triangle& b, const CoreSeparation& core, bool closest_count) {
    const std::size_t first = out_.size();
    contacts_under(a, b, here, core, settings_.margin, closest_count, out_);
    const Real noise = surfaces_.touching();
    std::size_t kept = first;
    for (std::size_t i = first; i < out_.size(); ++i) {
      ContactPoint contact = out_[i];
      if (-contact.distance > most_ ||
          (is_along(contact.normal, a.normal()) && is_on_a_cut(a_, a, contact.normal, contact.feature_a, noise)) ||
          (is_along(contact.normal, b.normal()) &&
           is_on_a_cut(b_, local(b), ab_.rotation.undo(contact.normal), contact.feature_b, noise)) ||
          is_told(contact, std::span(out_).subspan(first_, kept - first_), surfaces_.size())) {
        continue;
      }
      name(contact, a.index(), b.index());
      out_[kept++] = contact;
    }
    out_.resize(kept, ContactPoint{});
  }
  // Of a face that leans further only the lowest points count: another one lies flatter there.
  [[nodiscard]] static bool is_steep(const Triangle& triangle, const Vec3& normal) {
    constexpr Real least_cosine = 0.7;
    return triangle.has_area() && std::fabs(dot(triangle.normal(), normal)) < least_cosine;
  }
  void keep_touched(std::size_t first, Real distance) {
    const Real most = distance + surfaces_.tolerance();
    const auto begin = out_.begin() + static_cast<std::ptrdiff_t>(first);
    out_.erase(std::remove_if(begin, out_.end(), [&](const ContactPoint& its) { return its.distance > most; }),
               out_.end());
  }
  // In the frame of its surface.
  [[nodiscard]] Triangle local(const Triangle& b) const { return b_.part(b.index()); }
  // As if the surfaces came in the order that was asked for.
  void name(ContactPoint& contact, std::uint32_t number_a, std::uint32_t number_b) const {
    const std::uint64_t features = is_swapped_ ? contact_id(contact.feature_b, contact.feature_a)
                                               : contact_id(contact.feature_a, contact.feature_b);
    contact.id = contact_id_of_part(contact_id_of_part(features, is_swapped_ ? number_b : number_a),
                                    is_swapped_ ? number_a : number_b);
    contact.feature_a = {FeatureKind::face, number_a};
    contact.feature_b = {FeatureKind::face, number_b};
  }
  // The touch after the translation, as a contact along it.
  void append_whole(const SeparatingTranslation& translation) {
    if (!(-translation.length <= settings_.margin) || !last_) {
      return;
    }
    const Vec3 point_b = last_point_of(last_->a.corners, last_->b.corners, translation.direction, last_->length);
    const Feature whole{FeatureKind::whole, 0};
    out_.push_back({point_b + translation.length * translation.direction,
                    point_b,
                    translation.direction,
                    -translation.length,
                    {FeatureKind::face, last_->a.number},
                    {FeatureKind::face, last_->b.number},
                    mixed(~contact_id(whole, whole))});
  }
  // Where no way leads to the front of all, the deepest pair that has one to the fronts of both tells its own.
  void append_jammed() {
    if (out_.size() > first_) {
      return;
    }
    const NearPair* deepest = nullptr;
    for (const NearPair& pair : surfaces_.near()) {
      if (pair.is_overlapped && (deepest == nullptr || pair.gap < deepest->gap) &&
          Fronts<Triangle>(pair.a.part(), pair.b.part(), here).allows(pair.found.core.normal)) {
        deepest = &pair;
      }
    }
    if (deepest != nullptr) {
      const Triangle a = deepest->a.part(), b = deepest->b.part();
      append_under(a, b, completed(a, b, here, deepest->found), true);
    }
  }
  // Rounding may leave the nearest points in the cone of no triangle. Then the nearest pair has a contact after all.
  void append_nearest() {
    const std::span<const NearPair> near = surfaces_.near();
    if (near.empty()) {
      return;
    }
    const NearPair& nearest = *std::ranges::min_element(near, {}, &NearPair::gap);
    const auto is_as_near = [&](const ContactPoint& contact) {
      return contact.distance <= std::max(nearest.gap, Real{0}) + surfaces_.touching();
    };
    if (std::ranges::none_of(std::span(out_).subspan(first_), is_as_near)) {
      const Triangle a = nearest.a.part(), b = nearest.b.part();
      append_under(a, b, completed(a, b, here, nearest.found), true);
    }
  }

  const SurfaceSource& a_;
  const SurfaceSource& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  CrossingSurfaces& surfaces_;
  bool is_swapped_;
  Manifold& out_;
  std::size_t first_ = out_.size();
  Real most_ = infinity;  // how deep a contact may be
  std::optional<TouchedPair> last_;
};

void append_contacts(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
                     bool is_swapped, Manifold& out) {
  CrossingSurfaces surfaces(a, b, ab, settings, settings.margin);
  const auto translation = surfaces.is_met() ? std::optional(surfaces.find()) : std::nullopt;
  Contacts(a, b, ab, settings, surfaces, is_swapped, out).append(translation);
}

}  // namespace

void contacts_of_surfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
                          Manifold& out) {
  const std::size_t first = out.size();
  if (!is_moved_first(a, b, ab)) {
    append_contacts(a, b, ab, settings, false, out);
  } else {
    append_contacts(b, a, ab.inverse(), settings, true, out);
    for (ContactPoint& contact : std::span(out).subspan(first)) {
      move_by(contact, ab, true);
    }
  }
  number_apart(std::span(out).subspan(first));
}

}  // namespace abut
