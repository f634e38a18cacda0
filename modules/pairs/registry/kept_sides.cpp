// SPDX-License-Identifier: Apache-2.0
module abut.pairs.registry.kept_sides;
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
import abut.pairs.registry.seams;

namespace abut {
namespace {

template <class Ask>
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

bool is_solid(const AnyShape& surface) {
  bool is = false;
  ask_surface(surface, [&]<class S>(const S& its) {
    if constexpr (Enclosing<S>) {
      is = its.is_solid();
    }
  });
  return is;
}

// In order of their numbers.
std::vector<Triangle> triangles_in(const AnyShape& surface, const Aabb& box) {
  std::vector<Triangle> found;
  ask_surface(surface, [&]<class S>(const S& its) {
    Aabb query = box;
    its.visit_parts(query, [&](const typename S::Part& part, std::uint32_t) { found.push_back(part); });
  });
  std::ranges::sort(found, {}, &Triangle::index);
  return found;
}

std::vector<TouchedPart> touched_parts(const AnyShape& surface, const AnyShape& body, const Pose& ab,
                                       const QuerySettings& settings) {
  std::vector<TouchedPart> touched;
  ask_convex(body, [&](const auto& core) {
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

// Where a convex shape begins along a direction.
Real lowest_along(const AnyShape& body, const Pose& pose, const Vec3& direction) {
  Real lowest = 0;
  ask_convex(body, [&](const auto& core) {
    lowest = dot(direction, placed_support(core, place(core, pose), -direction).point) - core.radius();
  });
  return lowest;
}

Real noise_of_body(const AnyShape& body, const Pose& pose) {
  Real size = 0;
  ask_convex(body, [&](const auto& core) {
    size = largest_magnitude(placed_centre(core, pose)) + core.extent() + core.radius();
  });
  return noise_of(size);
}

// What an algorithm does not answer, the default one does.
void add_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                  const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  if (contacts_of_pair(a, b, pose_a, pose_b, settings, out) != Outcome::ok) {
    out.resize(first, ContactPoint{});
    static_cast<void>(contacts_of_pair(a, b, pose_a, pose_b, {.margin = settings.margin}, out));
  }
}

// In the frame of the surface, which is side a.
Manifold contacts_of(const AnyShape& surface, const AnyShape& body, const Pose& ab, const QuerySettings& settings) {
  Manifold found;
  add_contacts(surface, body, Pose::identity(), ab, settings, found);
  return found;
}

// The contacts where the body has just come back, carried to where it is.
void add_way_back(const AnyShape& surface, const AnyShape& body, const Pose& ab, const QuerySettings& settings,
                  const WayBack& way, const Triangle& triangle, Manifold& out) {
  // Leaning further, contacts are those of another way.
  constexpr Real same_way = 0.9;
  const std::size_t first = out.size();
  const Vec3 shift = way.depth * way.normal;
  QuerySettings further = settings;
  further.margin += std::max(way.depth, Real{0});
  for (ContactPoint contact : contacts_of(surface, body, {ab.rotation, ab.position + shift}, further)) {
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
  ask_convex(body, [&](const auto& core) {
    const Vec3 point = placed_support(core, place(core, ab), -way.normal).point - core.radius() * way.normal;
    const Feature face{FeatureKind::face, triangle.index()}, other{FeatureKind::face, 0};
    out.push_back({point + way.depth * way.normal, point, way.normal, -way.depth, face, other,
                   contact_id_of_part(contact_id(face, other), triangle.index())});
  });
}

bool is_surface_and_body(std::size_t surface, std::size_t body) {
  static constexpr auto are = []<class... S>(const std::variant<S...>*) {
    return std::pair(std::array<bool, sizeof...(S)>{Surface<S>...}, std::array<bool, sizeof...(S)>{Convex<S>...});
  }(static_cast<const AnyShape::Variant*>(nullptr));
  const PairKernels<AnyShape>& kernels = pair_kernels(std::min(surface, body), std::max(surface, body));
  return are.first[surface] && are.second[body] && kernels.route == Route::parts;
}

// Of one surface and one body that is placed by `ab` in its frame. None where the contacts without a memory stand.
std::optional<Manifold> contacts_of_passed(const AnyShape& surface, const AnyShape& body, const Pose& ab,
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
  const Manifold plain = contacts_of(surface, body, ab, settings);
  const SidesOfParts sides = sides_of(touched, plain, before, [&](std::uint32_t part) {
    std::optional<TriangleCorners> corners;
    ask_surface(surface, [&](const auto& its) {
      if (part < its.triangle_count()) {
        corners = its.corners(part);
      }
    });
    return corners;
  });

  std::vector<ContactPoint> staying;
  std::vector<std::size_t> passed;
  for (const ContactPoint& contact : plain) {
    const auto at = find_part(touched, contact.feature_a.index);
    const Vec3 face = at ? touched[*at].triangle.normal() : Vec3{0, 0, 0};
    const Real along = dot(contact.normal, face) * (at && sides.is_front(*at) ? 1 : -1);
    if (!at || touched[*at].triangle.is_one_sided() || is_on_side(contact, along, before)) {
      staying.push_back(contact);
    } else {
      passed.push_back(*at);
    }
  }
  // A triangle that stops from its front only has no contact with what has passed it.
  for (std::size_t at = 0; at < touched.size() && !before.is_empty(); ++at) {
    const Triangle& triangle = touched[at].triangle;
    const Real along = dot(touched[at].normal, triangle.normal());
    if (triangle.is_one_sided() && sides.is_front(at) && along < 0 && is_of_face(along)) {
      passed.push_back(at);
    }
  }
  std::ranges::sort(passed);
  passed.erase(std::unique(passed.begin(), passed.end()), passed.end());

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

std::pair<std::uint32_t, std::uint32_t> children_of(const SidesOfChildren& its) { return {its.child_a, its.child_b}; }

const SideMemory& memory_of(std::span<const SidesOfChildren> memories, std::uint32_t child_a, std::uint32_t child_b) {
  static const SideMemory none;
  const auto at = std::lower_bound(memories.begin(), memories.end(), std::pair(child_a, child_b),
                                   [](const SidesOfChildren& its, const auto& key) { return children_of(its) < key; });
  return at != memories.end() && children_of(*at) == std::pair(child_a, child_b) ? at->memory : none;
}

const AnyShape* child_of(const AnyShape& shape, std::uint32_t child) {
  return std::visit(
      [&]<class S>(const S& s) -> const AnyShape* {
        if constexpr (Assembly<S>) {
          return child < s.children().size() ? &*s.children()[child].shape : nullptr;
        } else {
          return child == 0 ? &shape : nullptr;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

bool may_be_of(const SideMemory& memory, const AnyShape& surface) {
  std::size_t count = 0;
  ask_surface(surface, [&](const auto& its) { count = its.triangle_count(); });
  const auto is_right = [&](const SideOfPart& its) { return its.part < count; };
  return std::ranges::all_of(memory.parts, is_right) && is_finite(memory.normal);
}

}  // namespace

bool may_keep_side(std::size_t a, std::size_t b) {
  static constexpr auto are = []<class... S>(const std::variant<S...>*) {
    return std::pair(std::array<bool, sizeof...(S)>{Assembly<S>...},
                     std::array<bool, sizeof...(S)>{Assembly<S> || Surface<S> || Convex<S>...});
  }(static_cast<const AnyShape::Variant*>(nullptr));
  return is_surface_and_body(a, b) || is_surface_and_body(b, a) ||
         ((are.first[a] || are.first[b]) && are.second[a] && are.second[b]);
}

bool may_be_of(std::span<const SidesOfChildren> memories, const AnyShape& a, const AnyShape& b) {
  const auto is_right = [&](const SidesOfChildren& its) {
    const AnyShape *const of_a = child_of(a, its.child_a), *const of_b = child_of(b, its.child_b);
    return of_a != nullptr && of_b != nullptr &&
           ((is_surface_and_body(of_a->index(), of_b->index()) && may_be_of(its.memory, *of_a)) ||
            (is_surface_and_body(of_b->index(), of_a->index()) && may_be_of(its.memory, *of_b)));
  };
  bool are_right = std::ranges::all_of(memories, is_right);
  for (std::size_t i = 1; i < memories.size(); ++i) {
    are_right = are_right && children_of(memories[i - 1]) < children_of(memories[i]);
  }
  return are_right;
}

bool contacts_on_side(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                      KeptSide& side, Manifold& out) {
  side.after.clear();
  if (a.has_holes() || b.has_holes()) {
    return false;
  }
  struct Passed {
    std::uint32_t child_a, child_b;
    Manifold contacts;
  };
  std::vector<Passed> passed;
  const Real reach = settings.margin;
  visit_pairs_of_children(
      a, b, ab, reach,
      [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t child_a, const AnyShape& of_b, const Pose& pose_b,
          std::uint32_t child_b) {
        const bool is_surface_a = is_surface_and_body(of_a.index(), of_b.index());
        if (!is_surface_a && !is_surface_and_body(of_b.index(), of_a.index())) {
          return;
        }
        const AnyShape &surface = is_surface_a ? of_a : of_b, &body = is_surface_a ? of_b : of_a;
        const Pose &placed = is_surface_a ? pose_a : pose_b, &of_body = is_surface_a ? pose_b : pose_a;
        SideMemory after;
        std::optional<Manifold> found = contacts_of_passed(surface, body, relative(placed, of_body), settings,
                                                           memory_of(side.before, child_a, child_b), after);
        if (!after.is_empty()) {
          side.after.push_back({child_a, child_b, std::move(after)});
        }
        if (found) {
          for (ContactPoint& contact : *found) {
            move_by(contact, placed, !is_surface_a);
          }
          passed.push_back({child_a, child_b, std::move(*found)});
        }
      });
  std::ranges::sort(side.after, {}, children_of);
  if (passed.empty()) {
    return false;
  }
  const std::size_t first = out.size();
  if (!is_assembly(a) && !is_assembly(b)) {
    out.insert(out.end(), passed[0].contacts.begin(), passed[0].contacts.end());
    return true;
  }
  // Those of children that have passed nothing are as without a memory.
  std::size_t next = 0;
  visit_pairs_of_children(
      a, b, ab, reach,
      [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t child_a, const AnyShape& of_b, const Pose& pose_b,
          std::uint32_t child_b) {
        const std::size_t begin = out.size();
        if (next < passed.size() && passed[next].child_a == child_a && passed[next].child_b == child_b) {
          out.insert(out.end(), passed[next].contacts.begin(), passed[next].contacts.end());
          ++next;
        } else {
          add_contacts(of_a, of_b, pose_a, pose_b, settings, out);
        }
        name_children(a, b, child_a, child_b, begin, out);
      });
  settle_seams(a, Pose::identity(), false, b, first, out);
  settle_seams(b, ab, true, a, first, out);
  return true;
}

}  // namespace abut
