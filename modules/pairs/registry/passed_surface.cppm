// SPDX-License-Identifier: Apache-2.0
// The contacts of one body that has passed a surface: as deep as the way back to the side from which it came. A body is
// a convex shape, or one of many solids.
export module abut.pairs.registry.passed_surface;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.many.kept_side;
import abut.narrow.many.triangle_contacts;
import abut.narrow.warm.side_memory;
import abut.pairs.registry;
import abut.pairs.registry.children;
import abut.pairs.rows.by_route;

namespace abut {

export template <class Ask>
void ask_surface(const AnyShape& shape, Ask&& ask) {
  std::visit(
      [&]<class S>(const S& surface) {
        if constexpr (Surface<S>) {
          ask(surface);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

template <class Ask>
void ask_convex(const AnyShape& shape, Ask&& ask) {
  std::visit(
      [&]<class S>(const S& body) {
        if constexpr (Convex<S>) {
          ask(core_of(body));
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// What an algorithm does not answer, the default one does.
template <class Ask>
void ask_again_by_default(const QuerySettings& settings, Manifold& out, Ask&& ask) {
  const std::size_t first = out.size();
  if (ask(settings) != Outcome::ok) {
    out.resize(first, ContactPoint{});
    static_cast<void>(ask(QuerySettings{.margin = settings.margin}));
  }
}
export inline void add_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                const QuerySettings& settings, Manifold& out) {
  ask_again_by_default(settings, out,
                       [&](const QuerySettings& asked) { return contacts_of_pair(a, b, pose_a, pose_b, asked, out); });
}

// What touches a surface: a convex shape of the table.
export struct LoneBody {
  AnyShape shape;

  template <class Ask>
  void ask(Ask&& ask) const {
    ask_convex(shape, ask);
  }
  // In the frame of the surface, which is side a.
  [[nodiscard]] Manifold contacts_with(const AnyShape& surface, const Pose& ab, const QuerySettings& settings) const {
    Manifold found;
    add_contacts(surface, shape, Pose::identity(), ab, settings, found);
    return found;
  }
};
// One of many solids, which have no place in the table.
export template <class Part>
struct OneOfMany {
  Part part;

  template <class Ask>
  void ask(Ask&& ask) const {
    ask(core_of(part));
  }
  [[nodiscard]] Manifold contacts_with(const AnyShape& surface, const Pose& ab, const QuerySettings& settings) const {
    Manifold found;
    ask_surface(surface, [&](const auto& its) {
      ask_again_by_default(settings, found, [&](const QuerySettings& asked) {
        return contacts_by_route(its, core_of(part), ab, asked, found);
      });
    });
    keep_deepest_of_directions(found, 0);
    return found;
  }
};

inline bool is_solid(const AnyShape& surface) {
  bool is = false;
  ask_surface(surface, [&]<class S>(const S& its) {
    if constexpr (Enclosing<S>) {
      is = its.is_solid();
    }
  });
  return is;
}

// In order of their numbers.
inline std::vector<Triangle> triangles_in(const AnyShape& surface, const Aabb& box) {
  std::vector<Triangle> found;
  ask_surface(surface, [&]<class S>(const S& its) {
    Aabb query = box;
    its.visit_parts(query, [&](const typename S::Part& part, std::uint32_t) { found.push_back(part); });
  });
  std::ranges::sort(found, {}, &Triangle::index);
  return found;
}

template <class Body>
std::vector<TouchedPart> touched_parts(const AnyShape& surface, const Body& body, const Pose& ab,
                                       const QuerySettings& settings) {
  std::vector<TouchedPart> touched;
  body.ask([&](const auto& core) {
    for (const Triangle& triangle : triangles_in(surface, core.aabb(ab).inflated(settings.margin))) {
      const Real limit = settings.margin + core.radius();
      const CoreSeparation found = separate_from_triangle(triangle, core, ab, settings, limit);
      if (!found.beyond && found.distance <= limit) {
        const Real height = dot(triangle.normal(), placed_centre(core, ab) - triangle.corners()[0]);
        touched.push_back({triangle, found.normal, height >= 0});
      }
    }
  });
  return touched;
}

// Where a body begins along a direction.
template <class Body>
Real lowest_along(const Body& body, const Pose& pose, const Vec3& direction) {
  Real lowest = 0;
  body.ask([&](const auto& core) {
    lowest = dot(direction, placed_support(core, place(core, pose), -direction).point) - core.radius();
  });
  return lowest;
}

template <class Body>
Real noise_of_body(const Body& body, const Pose& pose) {
  Real size = 0;
  body.ask(
      [&](const auto& core) { size = largest_magnitude(placed_centre(core, pose)) + core.extent() + core.radius(); });
  return noise_of(size);
}

// The contacts where the body has just come back, carried to where it is.
template <class Body>
void add_way_back(const AnyShape& surface, const Body& body, const Pose& ab, const QuerySettings& settings,
                  const WayBack& way, const Triangle& triangle, Manifold& out) {
  // Leaning further, contacts are those of another way.
  constexpr Real same_way = 0.9;
  const std::size_t first = out.size();
  const Vec3 shift = way.depth * way.normal;
  QuerySettings further = settings;
  further.margin += std::max(way.depth, Real{0});
  for (ContactPoint contact : body.contacts_with(surface, {ab.rotation, ab.position + shift}, further)) {
    contact.point_b += -shift;
    contact.distance = dot(contact.point_b - contact.point_a, contact.normal);
    contact.point_a = contact.point_b - contact.distance * contact.normal;
    const bool is_new = std::ranges::none_of(out, [&](const ContactPoint& other) { return other.id == contact.id; });
    if (is_new && dot(contact.normal, way.normal) > same_way && contact.distance <= settings.margin) {
      out.push_back(contact);
    }
  }
  if (out.size() > first) {
    return;
  }
  body.ask([&](const auto& core) {
    const Vec3 point = placed_support(core, place(core, ab), -way.normal).point - core.radius() * way.normal;
    const Feature face{FeatureKind::face, triangle.index()}, other{FeatureKind::face, 0};
    out.push_back({point + way.depth * way.normal, point, way.normal, -way.depth, face, other,
                   contact_id_of_part(contact_id(face, other), triangle.index())});
  });
}

// The touched triangle that a contact is of. Contacts of a plane may lie over triangles of it that are not touched:
// those are of any touched one in the plane.
inline std::optional<std::size_t> part_of_contact(std::span<const TouchedPart> touched, const ContactPoint& contact) {
  constexpr Real same_normal = 1 - 1e-9;
  if (const auto at = find_part(touched, contact.feature_a.index)) {
    return at;
  }
  for (std::size_t at = 0; at < touched.size(); ++at) {
    const Triangle& triangle = touched[at].triangle;
    const Real height = dot(triangle.normal(), contact.point_a - triangle.corners()[0]);
    if (std::fabs(dot(triangle.normal(), contact.normal)) > same_normal &&
        std::fabs(height) <= noise_of(largest_magnitude(contact.point_a) + triangle.extent())) {
      return at;
    }
  }
  return std::nullopt;
}

// The contacts on the side from which a body came, and the triangles that it has passed, in order.
struct PartedBySide {
  std::vector<ContactPoint> staying;
  std::vector<std::size_t> passed;
};
inline PartedBySide parted_by_side(std::span<const TouchedPart> touched, std::span<const ContactPoint> contacts,
                                   const SidesOfParts& sides, const SideMemory& before) {
  PartedBySide parted;
  std::vector<bool> is_passed(touched.size());
  for (const ContactPoint& contact : contacts) {
    const auto at = part_of_contact(touched, contact);
    const Vec3 face = at ? touched[*at].triangle.normal() : Vec3{0, 0, 0};
    const Real along = dot(contact.normal, face) * (at && sides.is_front(*at) ? 1 : -1);
    if (!at || touched[*at].triangle.is_one_sided() || is_on_side(contact, along, before)) {
      parted.staying.push_back(contact);
    } else {
      is_passed[*at] = true;
    }
  }
  for (std::size_t at = 0; at < touched.size(); ++at) {
    // A triangle that stops from its front only has no contact with what has passed it.
    const Triangle& triangle = touched[at].triangle;
    const Real along = dot(touched[at].normal, triangle.normal());
    const bool has_no_contact = !before.is_empty() && triangle.is_one_sided() && sides.is_front(at) && along < 0;
    if (is_passed[at] || (has_no_contact && is_of_face(along))) {
      parted.passed.push_back(at);
    }
  }
  return parted;
}

// Of one surface and one body that is placed by `ab` in its frame. None where the contacts without a memory stand.
export template <class Body>
std::optional<Manifold> contacts_of_passed(const AnyShape& surface, const Body& body, const Pose& ab,
                                           const QuerySettings& given, const SideMemory& before, SideMemory& after) {
  after = {};
  if (is_solid(surface)) {
    return std::nullopt;
  }
  QuerySettings settings = given;
  settings.margin = std::max(settings.margin, Real{0});
  const std::vector<TouchedPart> touched = touched_parts(surface, body, ab, settings);
  if (touched.empty()) {
    return std::nullopt;
  }
  const Manifold plain = body.contacts_with(surface, ab, settings);
  const SidesOfParts sides = sides_of(touched, plain, before, [&](std::uint32_t part) {
    std::optional<TriangleCorners> corners;
    ask_surface(surface, [&](const auto& its) {
      if (part < its.triangle_count()) {
        corners = its.corners(part);
      }
    });
    return corners;
  });

  const auto [staying, passed] = parted_by_side(touched, plain, sides, before);
  const auto ways = ways_back(touched, sides, passed, staying, noise_of_body(body, ab),
                              [&](const Vec3& direction) { return lowest_along(body, ab, direction); });
  Manifold found(staying.begin(), staying.end());
  for (const WayBack& way : ways) {
    add_way_back(surface, body, ab, settings, way, touched[way.part].triangle, found);
  }
  if (found.empty() && before.is_empty()) {
    return std::nullopt;
  }
  after.normal = found.empty() ? before.normal : std::ranges::min_element(found, {}, &ContactPoint::distance)->normal;
  for (std::size_t at = 0; at < touched.size(); ++at) {
    after.parts.push_back({touched[at].triangle.index(), sides.is_front(at)});
  }
  return passed.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace abut
