// SPDX-License-Identifier: Apache-2.0
// Composites with holes: what the holes take of the contacts with another shape, and what they add.
module abut.pairs.registry;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.cut;
import abut.pairs.rows.by_route;

namespace abut {
namespace {

// A shape that a composite with holes meets.
struct LoneShape {
  AnyShape shape;

  [[nodiscard]] Aabb aabb(const Pose& pose) const {
    return std::visit([&](const auto& s) { return s.aabb(pose); }, shape);
  }
  [[nodiscard]] std::optional<Distance> distance_to(const Vec3& point) const { return shape.distance_to(point); }
  // A hole by itself against what is in it.
  [[nodiscard]] Outcome contacts_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Manifold& found) const {
    const bool comes_first = shape.index() < hole.index();
    const AnyShape &one = comes_first ? shape : hole, &two = comes_first ? hole : shape;
    return pair_kernels(one.index(), two.index())
        .contacts(one, two, comes_first ? pose : placed, comes_first ? placed : pose, comes_first, settings, found);
  }
  [[nodiscard]] Outcome distance_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Distance& found) const {
    const bool comes_first = shape.index() < hole.index();
    const AnyShape &one = comes_first ? shape : hole, &two = comes_first ? hole : shape;
    return pair_kernels(one.index(), two.index())
        .distance(one, two, comes_first ? pose : placed, comes_first ? placed : pose, comes_first, settings, found);
  }
};

// Asks a shape that is a hole; others have no cavity to ask about.
template <class Ask>
Outcome ask_hole(const AnyShape& hole, Ask&& ask) {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Hole<S>) {
          return ask(shape);
        } else {
          return Outcome::unsupported;
        }
      },
      hole);
}

// One of many solids of one kind, which is no shape of the table.
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
  [[nodiscard]] Outcome contacts_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Manifold& found) const {
    const Outcome outcome = ask_hole(hole, [&](const auto& cavity) {
      return contacts_by_route(cavity, core_of(part), relative(placed, pose), settings, found);
    });
    for (ContactPoint& contact : found) {
      move_by(contact, placed);
    }
    return outcome;
  }
  [[nodiscard]] Outcome distance_in(const AnyShape& hole, const Pose& placed, const Pose& pose,
                                    const QuerySettings& settings, Distance& found) const {
    const Outcome outcome = ask_hole(hole, [&](const auto& cavity) {
      return distance_by_route(cavity, core_of(part), relative(placed, pose), settings, found);
    });
    move_by(found, placed);
    return outcome;
  }
};

}  // namespace

// Children of the other shape are judged one by one, and so is each of many solids.
void carve(const AnyShape& composite, const Pose& pose, const AnyShape& other, const Pose& other_pose,
           const QuerySettings& settings, std::span<const ContactPoint> contacts, std::vector<bool>& is_cut,
           Manifold& added) {
  // The contacts by the child or part that they are of: its number, and the place of the contact.
  std::vector<std::pair<std::uint32_t, std::size_t>> places;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    places.push_back({contacts[i].child_b, i});
  }
  std::ranges::sort(places);
  const auto carve_one = [&]<class S, class One>(const S& shape, const One& one, const Pose& one_pose,
                                                 std::optional<std::uint32_t> number) {
    Manifold own;
    auto next =
        number ? std::lower_bound(places.begin(), places.end(), std::pair{*number, std::size_t{0}}) : places.begin();
    for (; next != places.end() && (!number || next->first == *number); ++next) {
      own.push_back(contacts[next->second]);
      own.back().id = next->second;  // tells which of them are left
      is_cut[next->second] = true;
    }
    const std::size_t first = added.size();
    Carver<S, One>(shape, pose, one, one_pose).carve(settings, own, added);
    for (const ContactPoint& contact : own) {
      is_cut[contact.id] = false;
    }
    if (number) {
      for (ContactPoint& contact : std::span(added).subspan(first)) {
        contact.child_b = *number;
        contact.id = contact_id_of_part(contact.id, *number);
      }
    }
  };
  const auto carve_all = [&]<class S, class O>(const S& shape, const O& many) {
    Aabb near = shape.aabb(relative(other_pose, pose)).inflated(std::max(settings.margin, Real{0}));
    if constexpr (Assembly<O>) {
      many.visit_children(near, [&](std::uint32_t child) {
        carve_one(shape, LoneShape{*many.children()[child].shape}, other_pose * many.children()[child].pose, child);
      });
    } else if constexpr (Scattered<O>) {
      many.visit_places(near, [&](const Vec3& place, std::uint32_t index) {
        carve_one(shape, LonePart<typename O::Part>{many.part(index)}, {other_pose.rotation, other_pose * place},
                  index);
      });
    } else {
      carve_one(shape, LoneShape{other}, other_pose, std::nullopt);
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
