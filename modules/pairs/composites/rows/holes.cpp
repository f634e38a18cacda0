// SPDX-License-Identifier: Apache-2.0
// Composites with holes: what the holes take of the contacts with another shape, and what they add.
module abut.pairs.registry;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.walls.cut;
import abut.narrow.walls.through_wall;
import abut.pairs.rows.by_route;

namespace abut {
namespace {

// Asks a shape that is a hole; others have no cavity to ask about.
template <class Answer, class Ask>
Answer ask_hole(const AnyShape& hole, Answer of_others, Ask&& ask) {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Hole<S>) {
          return Answer(ask(shape));
        } else {
          return of_others;
        }
      },
      hole);
}

// A triangle, a segment or a point.
template <class B>
bool is_flat(const B& core) {
  if constexpr (Convex<B>) {
    if constexpr (!Curved<B>) {
      return core.radius() == 0 && core.corner_count() <= 3;
    }
  }
  return false;
}

// Whether a triangle, a segment or a point comes through a wall of a hole, in whose frame it is placed. Nothing where
// the core is none of these.
template <class B>
std::optional<bool> core_comes_through(const AnyShape& hole, const B& core, const Pose& placed, std::uint32_t face,
                                       Real noise) {
  if constexpr (Convex<B>) {
    if constexpr (!Curved<B>) {
      if (is_flat(core)) {
        std::array<Vec3, 3> corners{};
        const std::uint32_t count = core.corner_count();
        for (std::uint32_t i = 0; i < count; ++i) {
          corners.at(i) = placed * core.corner(i);
        }
        return ask_hole(hole, false, [&](const auto& cavity) {
          return comes_through({cavity.flat_walls(), cavity.round_wall()}, face, std::span(corners).first(count),
                               noise);
        });
      }
    }
  }
  return std::nullopt;
}

// A shape that a composite with holes meets.
struct LoneShape {
  AnyShape shape;

  [[nodiscard]] Aabb aabb(const Pose& pose) const {
    return std::visit([&](const auto& s) { return s.aabb(pose); }, shape);
  }
  [[nodiscard]] std::optional<Distance> distance_to(const Vec3& point) const { return shape.distance_to(point); }
  [[nodiscard]] bool is_sheet() const {
    return std::visit(
        []<class S>(const S& s) {
          if constexpr (Enclosing<S>) {
            return !s.is_solid();
          } else {
            return Surface<S> || is_flat(core_of(s));
          }
        },
        shape);
  }
  [[nodiscard]] std::optional<bool> comes_through(const AnyShape& hole, const Pose& placed, std::uint32_t face,
                                                  Real noise) const {
    return std::visit([&](const auto& s) { return core_comes_through(hole, core_of(s), placed, face, noise); }, shape);
  }
  // A hole by itself against what is in it.
  [[nodiscard]] Outcome contacts_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Manifold& found) const {
    const bool comes_first = shape.index() < hole.index();
    const AnyShape &one = comes_first ? shape : hole, &two = comes_first ? hole : shape;
    return pair_kernels(one.index(), two.index())
        .contacts(one, two, comes_first ? pose : placed, comes_first ? placed : pose, comes_first, settings, found);
  }
  // A child by itself: a hole, or a solid as it would be without holes.
  [[nodiscard]] Outcome distance_from(const AnyShape& child, const Pose& placed, const Pose& pose,
                                      const QuerySettings& settings, Distance& found) const {
    const bool comes_first = shape.index() < child.index();
    const AnyShape &one = comes_first ? shape : child, &two = comes_first ? child : shape;
    return pair_kernels(one.index(), two.index())
        .distance(one, two, comes_first ? pose : placed, comes_first ? placed : pose, comes_first, settings, found);
  }
};

// One of many solids of one kind or of the triangles of a surface, which is no shape of the table.
template <class Part>
struct LonePart {
  Part part;

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return part.aabb(pose); }
  [[nodiscard]] std::optional<Distance> distance_to(const Vec3& point) const {
    Distance found{};
    const Pose placed{Rotation::identity(), point};
    return distance_by_route(core_of(part), PointCore(0), placed, {}, found) == Outcome::ok ? std::optional(found)
                                                                                            : std::nullopt;
  }
  [[nodiscard]] bool is_sheet() const { return is_flat(core_of(part)); }
  [[nodiscard]] std::optional<bool> comes_through(const AnyShape& hole, const Pose& placed, std::uint32_t face,
                                                  Real noise) const {
    return core_comes_through(hole, core_of(part), placed, face, noise);
  }
  [[nodiscard]] Outcome contacts_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Manifold& found) const {
    const Outcome outcome = ask_hole(hole, Outcome::unsupported, [&](const auto& cavity) {
      return contacts_by_route(cavity, core_of(part), relative(placed, pose), settings, found);
    });
    for (ContactPoint& contact : found) {
      move_by(contact, placed);
    }
    return outcome;
  }
  [[nodiscard]] Outcome distance_from(const AnyShape& child, const Pose& placed, const Pose& pose,
                                      const QuerySettings& settings, Distance& found) const {
    const auto ask = [&]<class S>(const S& shape) {
      if constexpr (Hole<S> || Convex<S> || HalfSpace<S>) {
        return distance_by_route(core_of(shape), core_of(part), relative(placed, pose), settings, found);
      } else {
        return Outcome::unsupported;
      }
    };
    const Outcome outcome = std::visit(ask, static_cast<const AnyShape::Variant&>(child));
    move_by(found, placed);
    return outcome;
  }
};

// The child or particle of the other shape that a contact is of, and the triangle of a surface.
using PartNumber = std::pair<std::uint32_t, std::uint32_t>;

PartNumber part_of(const ContactPoint& contact) {
  return {contact.child_b, contact.feature_b.kind == FeatureKind::face ? contact.feature_b.index : no_index};
}

}  // namespace

// Children of the other shape are judged one by one, and so is each of many solids and each triangle of a surface.
void carve(const AnyShape& composite, const Pose& pose, const AnyShape& other, const Pose& other_pose,
           const QuerySettings& settings, std::span<const ContactPoint> contacts, std::vector<bool>& is_cut,
           Manifold& added) {
  // The contacts by the part that they are of: its number, and the place of the contact.
  std::vector<std::pair<PartNumber, std::size_t>> places;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    places.push_back({part_of(contacts[i]), i});
  }
  std::ranges::sort(places);
  // Of the parts from `first` to `last`, which are one shape. `seeds`: takes the places that lead to rims, of a part of
  // a surface.
  const auto carve_one = [&]<class S, class One>(const S& shape, const One& one, const Pose& one_pose,
                                                 const PartNumber& first, const PartNumber& last,
                                                 std::vector<RimSeed>* seeds) {
    Manifold own;
    auto next = std::lower_bound(places.begin(), places.end(), std::pair{first, std::size_t{0}});
    for (; next != places.end() && next->first <= last; ++next) {
      own.push_back(contacts[next->second]);
      own.back().id = next->second;  // tells which of them are left
      is_cut[next->second] = true;
    }
    Carver<S, One> carver(shape, pose, one, one_pose);
    if (seeds) {
      carver.carve_walls(settings, own, added);
      seeds->insert(seeds->end(), carver.seeds().begin(), carver.seeds().end());
    } else {
      carver.carve(settings, own, added);
    }
    for (const ContactPoint& contact : own) {
      is_cut[contact.id] = false;
    }
  };
  const auto name_parts = [&](std::size_t first, std::uint32_t number) {
    for (ContactPoint& contact : std::span(added).subspan(first)) {
      contact.child_b = number;
      contact.id = contact_id_of_part(contact.id, number);
    }
  };
  // Of a surface, what is no contact of a triangle is one of the whole.
  const auto carve_triangles = [&]<class S, class O>(const S& shape, const O& surface, const AnyShape& whole,
                                                     const Pose& placed, std::uint32_t number) {
    Aabb near = shape.aabb(relative(placed, pose)).inflated(std::max(settings.margin, Real{0}));
    std::vector<std::uint32_t> triangles;
    surface.visit_parts(near, [&](const Triangle&, std::uint32_t index) { triangles.push_back(index); });
    std::ranges::sort(triangles);
    std::vector<RimSeed> seeds;
    for (const std::uint32_t index : triangles) {
      const std::size_t first = added.size();
      carve_one(shape, LonePart<Triangle>{surface.part(index)}, placed, {number, index}, {number, index}, &seeds);
      for (ContactPoint& contact : std::span(added).subspan(first)) {
        contact.feature_b = {FeatureKind::face, index};
        contact.id = contact_id_of_part(contact.id, index);
      }
    }
    auto next = std::lower_bound(places.begin(), places.end(), std::pair{PartNumber{number, no_index}, std::size_t{0}});
    for (; next != places.end() && next->first == PartNumber{number, no_index}; ++next) {
      is_cut[next->second] = is_in_hole(shape, pose, contacts[next->second]);
    }
    Carver<S, LoneShape>(shape, pose, LoneShape{whole}, placed).add_rims_from(seeds, settings, added);
  };
  const auto carve_shape = [&]<class S>(const S& shape, const AnyShape& whole, const Pose& placed, std::uint32_t first,
                                        std::uint32_t last) {
    const auto carve_it = [&]<class O>(const O& one) {
      if constexpr (Surface<O>) {
        carve_triangles(shape, one, whole, placed, first);
      } else {
        carve_one(shape, LoneShape{whole}, placed, {first, 0}, {last, no_index}, nullptr);
      }
    };
    std::visit(carve_it, whole);
  };
  const auto carve_all = [&]<class S, class O>(const S& shape, const O& many) {
    Aabb near = shape.aabb(relative(other_pose, pose)).inflated(std::max(settings.margin, Real{0}));
    if constexpr (Assembly<O>) {
      many.visit_children(near, [&](std::uint32_t number) {
        const std::size_t first = added.size();
        const auto& child = many.children()[number];
        carve_shape(shape, *child.shape, other_pose * child.pose, number, number);
        name_parts(first, number);
      });
    } else if constexpr (Scattered<O>) {
      many.visit_places(near, [&](const Vec3& place, std::uint32_t index) {
        const std::size_t first = added.size();
        carve_one(shape, LonePart<typename O::Part>{many.part(index)}, {other_pose.rotation, other_pose * place},
                  {index, 0}, {index, no_index}, nullptr);
        name_parts(first, index);
      });
    } else {
      carve_shape(shape, other, other_pose, 0, no_index);
    }
  };
  // One visit within the other: a visit of both at once makes a function for each pair of kinds.
  std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Assembly<S>) {
          std::visit([&](const auto& many) { carve_all(shape, many); }, other);
        }
      },
      composite);
}

}  // namespace abut
