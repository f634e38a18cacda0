// A triangle of a surface against a convex shape, or against a triangle of another surface. Beside the
// convex pair this knows two things about surfaces: a one-sided triangle only pushes to its front, and
// at an inner edge, across which the surface goes on, only the normal of the face counts, so that
// sliding shapes do not trip over seams.
export module abut.narrowphase.triangle_contacts;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.convex;
import abut.shape;

export namespace abut {

// Barycentric weights below this put a point on the edge opposite to the corner.
inline constexpr Real on_edge = 1e-7;

// Whether a point of a triangle lies on inner edges only, so that the surface goes on around it.
[[nodiscard]] inline bool is_inner_point(const Triangle& triangle, const Vec3& point) {
  const auto& corners = triangle.corners();
  const Vec3 scaled = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Real square = squared_norm(scaled);
  if (triangle.inner_edges() == 0 || !(square > 0)) {
    return false;
  }
  unsigned touched = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real weight = dot(scaled, cross(corners[(i + 1) % 3] - corners[i], point - corners[i])) / square;
    if (std::fabs(weight) <= on_edge) {
      touched |= 1u << i;
    }
  }
  return touched != 0 && (touched & triangle.inner_edges()) == touched;
}

// Whether a point of the plane of a triangle lies on the triangle, within rounding.
[[nodiscard]] inline bool is_over(const Triangle& triangle, const Vec3& point) {
  const auto& corners = triangle.corners();
  const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  Real size = largest_magnitude(point);
  for (const Vec3& corner : corners) {
    size = std::max(size, largest_magnitude(corner));
  }
  // Beyond a sharp corner points are outside of its edges by rounding only.
  if (!triangle.box().inflated(32 * epsilon * size).overlaps({point, point})) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = corners[(i + 1) % 3] - corners[i];
    const Real slack = 32 * epsilon * size * std::sqrt(squared_norm(n) * squared_norm(edge));
    if (dot(n, cross(edge, point - corners[i])) < -slack) {
      return false;
    }
  }
  return true;
}

// The separation of a triangle and a core. Axes that nearly agree may leave points that are not on the
// triangle, or not across each other; the outermost features under the normal then tell better ones.
template <Convex B>
[[nodiscard]] CoreSeparation separate_from_triangle(const Triangle& triangle, const B& b, const Pose& ab,
                                                    const QuerySettings& settings, Real limit) {
  CoreSeparation core = separate_cores(triangle, b, ab, settings, limit);
  // Curved surfaces have no features that would tell better ones than the search did.
  if (core.overlap && !Curved<B>) {
    const Real noise = noise_of(core_size(triangle, b, ab));
    const Vec3 aside = core.point_b - core.point_a - core.distance * core.normal;
    core.points_open = core.points_open || largest_magnitude(aside) > noise ||
                       !triangle.box().inflated(noise).overlaps({core.point_a, core.point_a}) ||
                       (triangle.has_area() && !is_over(triangle, core.point_a));
    find_points(triangle, b, ab, core);
  }
  return core;
}

// Which ways a pair may be parted: the front of either side, where that side is a one-sided triangle.
template <Convex B>
class Fronts {
 public:
  Fronts(const Triangle& triangle, const B& b, const Pose& ab) : a_(triangle.is_one_sided() ? triangle.normal() : Vec3{0, 0, 0}) {
    if constexpr (std::same_as<B, Triangle>) {
      b_ = b.is_one_sided() ? -(ab.rotation * b.normal()) : Vec3{0, 0, 0};
    }
  }
  [[nodiscard]] bool allows(const Vec3& normal) const { return dot(normal, a_) >= 0 && dot(normal, b_) >= 0; }
  // For normals that are those of the sides, within rounding.
  [[nodiscard]] bool nearly_allows(const Vec3& normal) const {
    return dot(normal, a_) >= -1e-12 && dot(normal, b_) >= -1e-12;
  }

 private:
  Vec3 a_, b_{0, 0, 0};
};

// A separation along the normal of a face, and whether its closest points lie on that face: the foot of
// the lowest point of the other side may be beside it.
struct Turned {
  CoreSeparation separation;
  bool is_over;
};

template <Convex B>
[[nodiscard]] Turned along_face(const Triangle& triangle, const B& b, const Pose& ab, const CoreSeparation& core, const Vec3& normal) {
  CoreSeparation turned = core;
  turned.normal = normal;
  turned.point_b = placed_support(b, place(b, ab), -normal).point;
  turned.distance = turned.lower = turned.upper = dot(normal, turned.point_b - triangle.corners()[0]);
  turned.point_a = turned.point_b - turned.distance * normal;
  return {turned, is_over(triangle, turned.point_a)};
}

// The same with the face on side b.
[[nodiscard]] inline Turned along_other_face(const Triangle& triangle, const Triangle& b, const Pose& ab, const CoreSeparation& core,
                                             const Vec3& normal) {
  CoreSeparation turned = core;
  turned.normal = normal;
  turned.point_a = triangle.support(normal).point;
  turned.distance = turned.lower = turned.upper = dot(normal, ab * b.corners()[0] - turned.point_a);
  turned.point_b = turned.point_a + turned.distance * normal;
  return {turned, is_over(b, ab.undo(turned.point_b))};
}

// A contact that was left to a neighbour across an inner edge. When no neighbour reports one that is as
// deep, it counts after all.
struct LeftToNeighbour {
  struct Pair {
    Triangle triangle;
    std::uint32_t part_of_b;
    CoreSeparation core;
  };
  std::optional<Pair> deepest;

  void offer(const Triangle& triangle, std::uint32_t part_of_b, const CoreSeparation& core) {
    if (!deepest || core.distance < deepest->core.distance) {
      deepest.emplace(Pair{triangle, part_of_b, core});
    }
  }
};

// Appends the contacts under a given separation, named after the triangle: seen from outside, the
// feature of a surface is its triangle; the number of the contact still tells the corners and edges of
// the triangle apart.
template <Convex B>
void append_contacts(const Triangle& triangle, const B& b, const Pose& ab, const CoreSeparation& core, Real margin, bool closest_count,
                     Manifold& out) {
  const std::size_t first = out.size();
  contacts_under(triangle, b, ab, core, margin, closest_count, out);
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    contact.id = mixed(contact.id + triangle.index());
    contact.feature_a = {FeatureKind::face, triangle.index()};
  }
}

// `part_of_b`: the number of b where it is a part itself.
template <Convex B>
void triangle_contacts(const Triangle& triangle, const B& b, std::uint32_t part_of_b, const Pose& ab, const QuerySettings& settings,
                       LeftToNeighbour& left, Manifold& out) {
  const Real radii = b.radius();
  const CoreSeparation core = separate_from_triangle(triangle, b, ab, settings, settings.margin + radii);
  if (core.beyond || core.distance - radii > settings.margin) {
    return;
  }
  const Fronts<B> fronts(triangle, b, ab);
  const bool is_allowed = fronts.allows(core.normal);
  // Of a core that is beside or behind a triangle, only what its rounding has sunk in from the front counts.
  if (!is_allowed && !core.overlap &&
      !(core.distance < radii && dot(triangle.normal(), placed_centre(b, ab) - triangle.corners()[0]) >= 0)) {
    return;
  }
  // The normals of faces that may stand in for the normal that was found; the one that parts them sooner does.
  std::optional<CoreSeparation> turned;
  bool is_over_face = false, was_turned = false;
  const bool is_apart = is_allowed && !core.overlap;
  const auto turn = [&](const Triangle& side, const Vec3& normal, bool is_inner, const auto& separation_along) {
    const bool is_face_normal = std::fabs(dot(core.normal, normal)) > 1 - 1e-12;
    if (!side.has_area() || (is_allowed && (!is_inner || is_face_normal))) {
      return;
    }
    was_turned = true;
    for (const Vec3& direction : {normal, -normal}) {
      const auto [separation, is_over] = separation_along(direction);
      // Cores that are apart are on the side that their closest points tell.
      const bool is_this_side = !is_apart || dot(core.normal, direction) >= 0;
      if (is_this_side && fronts.nearly_allows(direction) && (!turned || separation.distance > turned->distance)) {
        turned = separation;
        is_over_face = is_over;
      }
    }
  };
  turn(triangle, triangle.normal(), is_inner_point(triangle, core.point_a),
       [&](const Vec3& direction) { return along_face(triangle, b, ab, core, direction); });
  if constexpr (std::same_as<B, Triangle>) {
    turn(b, -(ab.rotation * b.normal()), is_inner_point(b, ab.undo(core.point_b)),
         [&](const Vec3& direction) { return along_other_face(triangle, b, ab, core, direction); });
  }
  if (!was_turned) {
    append_contacts(triangle, b, ab, core, settings.margin, true, out);
    return;
  }
  if (is_allowed) {
    left.offer(triangle, part_of_b, core);
  }
  // After a turn the closest points may lie beside the triangle, over a neighbour that has them too.
  if (turned) {
    const auto first = std::ssize(out);
    append_contacts(triangle, b, ab, *turned, settings.margin, is_over_face, out);
    // What passes the plane of the triangle beside it and reaches under it is no overlap.
    const Real least = is_apart ? core.distance - radii - 4 * core.rounding : -infinity;
    out.erase(std::remove_if(out.begin() + first, out.end(), [&](const ContactPoint& contact) { return contact.distance < least; }),
              out.end());
  }
}

// The contacts left to neighbours, of which the deepest counts where those from `first` on are less deep.
// It has a number of its own: the same features may have met under the normal of the face.
template <Convex B>
void append_left(const LeftToNeighbour::Pair& left, const B& b, const Pose& ab, Real margin, std::size_t first, Manifold& out) {
  const Real deep = left.core.distance - b.radius() + 4 * left.core.rounding;
  if (std::ranges::any_of(std::span(out).subspan(first), [&](const ContactPoint& contact) { return contact.distance <= deep; })) {
    return;
  }
  Manifold found;
  append_contacts(left.triangle, b, ab, left.core, margin, true, found);
  const auto deepest = std::ranges::min_element(found, {}, &ContactPoint::distance);
  if (deepest != found.end()) {
    deepest->id = mixed(~deepest->id);
    out.push_back(*deepest);
  }
}

}  // namespace abut
