// SPDX-License-Identifier: Apache-2.0
// The contacts of one body with a surface that keeps the side from which the body came. A body is a convex shape, or
// one of many solids.
export module abut.pairs.surfaces.met.passed_surface;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.narrow.sides.kept_side;
import abut.narrow.sides.kept_source;
import abut.narrow.surface.surfaces;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;
import abut.narrow.warm.side_memory;
import abut.pairs.registry;
import abut.pairs.composites.children;
import abut.pairs.surfaces.met.convex_on_source;
import abut.pairs.rows.by_route;

namespace abut {

// What touches a surface: a convex shape of the table.
export struct LoneBody {
  AnyShape shape;

  template <class Ask>
  void ask(Ask&& ask) const {
    with_core(shape, ask);
  }
  // In the frame of the surface, which is side a.
  [[nodiscard]] Manifold contacts_with(const TriangleSource& surface, const Pose& ab,
                                       const QuerySettings& settings) const {
    Manifold found;
    contacts_on_source(surface, shape, ab, settings, found);
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
  [[nodiscard]] Manifold contacts_with(const TriangleSource& surface, const Pose& ab,
                                       const QuerySettings& settings) const {
    Manifold found;
    contacts_on_surface(surface, core_of(part), ab, settings, found);
    keep_deepest_of_directions(found, 0);
    return found;
  }
};

// In order of their numbers.
inline std::vector<Triangle> triangles_in(const TriangleSource& surface, const Aabb& box) {
  std::vector<Triangle> found;
  surface.visit(box, [&](const FourTriangles& four, std::uint64_t present) {
    const std::uint64_t one_sided = surface.one_sided(four);
    for (; present != 0; present &= present - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(present));
      found.emplace_back(four[lane], std::span(four.numbers)[lane], (one_sided >> lane & 1u) != 0);
    }
    return true;
  });
  std::ranges::sort(found, {}, &Triangle::index);
  return found;
}

template <class Body>
std::vector<TouchedPart> touched_parts(std::span<const Triangle> near, const Body& body, const Pose& ab,
                                       const QuerySettings& settings) {
  std::vector<TouchedPart> touched;
  body.ask([&](const auto& core) {
    const Aabb box = core.aabb(ab).inflated(settings.margin);
    const Real limit = settings.margin + core.radius();
    for (const Triangle& triangle : near) {
      const CoreSeparation found =
          triangle.box().overlaps(box) ? separate_from_triangle(triangle, core, ab, settings, limit) : CoreSeparation{};
      if (triangle.box().overlaps(box) && !found.beyond && found.distance <= limit) {
        const Real height = dot(triangle.normal(), placed_centre(core, ab) - triangle.corners()[0]);
        touched.push_back({triangle, found.normal, height >= 0});
      }
    }
  });
  return touched;
}

// A body may be wholly behind a triangle that it touches within the margin. It is led back through the plane of one,
// the shortest way that there is.
template <class Body>
std::optional<ContactPoint> way_back(std::span<const TouchedPart> touched, const SidesOfParts& sides, const Body& body,
                                     const Pose& ab) {
  std::optional<ContactPoint> least;
  body.ask([&](const auto& core) {
    for (std::size_t at = 0; at < touched.size(); ++at) {
      const Triangle& triangle = touched[at].triangle;
      const Vec3 normal = sides.is_front(at) ? triangle.normal() : -triangle.normal();
      if (!(dot(touched[at].normal, normal) < 0) || (triangle.is_one_sided() && !sides.is_front(at))) {
        continue;
      }
      const Vec3 point = placed_support(core, place(core, ab), -normal).point - core.radius() * normal;
      const Real distance = dot(normal, point - triangle.corners()[0]);
      if (!least || distance > least->distance) {
        const Feature face{FeatureKind::face, triangle.index()}, other{FeatureKind::face, 0};
        least = {point - distance * normal,
                 point,
                 normal,
                 distance,
                 face,
                 other,
                 contact_id_of_part(contact_id(face, other), triangle.index())};
      }
    }
  });
  return least;
}

// Of one surface and one body that is placed by `ab` in its frame. None where the contacts without a memory stand.
export template <class Body>
std::optional<Manifold> contacts_of_passed(const AnyShape& shape, const Body& body, const Pose& ab,
                                           const QuerySettings& given, const SideMemory& before, SideMemory& after) {
  after = {};
  QuerySettings settings = given;
  settings.margin = std::max(settings.margin, Real{0});
  settings.algorithm = parts_support(settings.algorithm) ? settings.algorithm : Algorithm::automatic;
  Manifold found;
  with_surface(shape, [&]<class S>(const S& its) {
    const SourceOf<S> surface(its);
    if (surface.sides() == StoppingSides::solid) {
      return;
    }
    std::vector<Triangle> near;
    body.ask([&](const auto& core) {
      // Sides spread over what a way out may meet.
      const Real size = core.extent() + core.radius();
      near = triangles_in(surface, core.aabb(ab).inflated(std::max(settings.margin, 0.5 * size)));
    });
    const std::vector<TouchedPart> touched = touched_parts(near, body, ab, settings);
    if (touched.empty()) {
      return;
    }
    const auto corners_of = [&](std::uint32_t part) {
      return part < its.triangle_count() ? std::optional(its.corners(part)) : std::nullopt;
    };
    const SidesOfParts sides = sides_of(touched, body.contacts_with(surface, ab, settings), before, corners_of);
    for (std::size_t at = 0; at < touched.size(); ++at) {
      after.parts.push_back({touched[at].triangle.index(), sides.is_front(at)});
    }
    const std::vector<SideOfPart> around = sides_around(near, after.parts);
    found = body.contacts_with(KeptSource(surface, around), ab, settings);
    const auto back = found.empty() && !before.is_empty() ? way_back(touched, sides, body, ab) : std::nullopt;
    if (back) {
      found.push_back(*back);
    }
    if (found.empty() && before.is_empty()) {
      after = {};
    } else {
      after.normal =
          found.empty() ? before.normal : std::ranges::min_element(found, {}, &ContactPoint::distance)->normal;
    }
  });
  return found.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace abut
