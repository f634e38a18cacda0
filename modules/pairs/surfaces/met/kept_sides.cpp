// SPDX-License-Identifier: Apache-2.0
module abut.pairs.surfaces.kept_sides;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.warm.side_memory;
import abut.pairs.registry;
import abut.pairs.composites.children;
import abut.pairs.surfaces.met.passed_surface;
import abut.pairs.composites.seams;

namespace abut {
namespace {

// What an algorithm does not answer, the default one does.
void add_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                  const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  if (contacts_of_pair(a, b, pose_a, pose_b, settings, out) != Outcome::ok) {
    out.resize(first, ContactPoint{});
    static_cast<void>(contacts_of_pair(a, b, pose_a, pose_b, {.margin = settings.margin}, out));
  }
}

template <class Ask>
void ask_many(const AnyShape& shape, Ask&& ask) {
  std::visit(
      [&]<class S>(const S& many) {
        if constexpr (Scattered<S>) {
          ask(many);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// Of which kinds surfaces, bodies and many solids are, by their places in the registry.
struct Kinds {
  std::array<bool, std::variant_size_v<AnyShape::Variant>> surface, convex, scattered, assembly;
};
constexpr Kinds kinds = []<class... S>(const std::variant<S...>*) {
  return Kinds{{Surface<S>...}, {Convex<S>...}, {Scattered<S>...}, {Assembly<S>...}};
}(static_cast<const AnyShape::Variant*>(nullptr));

bool is_surface_and_body(std::size_t surface, std::size_t body) {
  return kinds.surface[surface] && kinds.convex[body] &&
         pair_kernels(std::min(surface, body), std::max(surface, body)).route == Route::parts;
}
bool is_surface_and_many(std::size_t surface, std::size_t many) {
  return kinds.surface[surface] && kinds.scattered[many];
}

std::pair<std::uint32_t, std::uint32_t> children_of(const SidesOfChildren& its) { return {its.child_a, its.child_b}; }

const SideMemory& memory_of(std::span<const SidesOfChildren> memories, std::uint32_t child_a, std::uint32_t child_b) {
  static const SideMemory none;
  const auto at = std::lower_bound(memories.begin(), memories.end(), std::pair(child_a, child_b),
                                   [](const SidesOfChildren& its, const auto& key) { return children_of(its) < key; });
  return at != memories.end() && children_of(*at) == std::pair(child_a, child_b) ? at->memory : none;
}

// A particle is a child of its shape.
const AnyShape* child_of(const AnyShape& shape, std::uint32_t child) {
  return std::visit(
      [&]<class S>(const S& s) -> const AnyShape* {
        if constexpr (Assembly<S>) {
          return child < s.children().size() ? &*s.children()[child].shape : nullptr;
        } else if constexpr (Scattered<S>) {
          return child < s.particle_count() ? &shape : nullptr;
        } else {
          return child == 0 ? &shape : nullptr;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

bool may_be_of(const SideMemory& memory, const AnyShape& surface) {
  std::size_t count = 0;
  with_surface(surface, [&](const auto& its) { count = its.triangle_count(); });
  const auto is_right = [&](const SideOfPart& its) { return its.part < count; };
  return std::ranges::all_of(memory.parts, is_right) && is_finite(memory.normal);
}

}  // namespace

bool may_keep_side(std::size_t a, std::size_t b) {
  const auto may_be_child = [](std::size_t kind) {
    return kinds.assembly[kind] || kinds.surface[kind] || kinds.convex[kind];
  };
  return is_surface_and_body(a, b) || is_surface_and_body(b, a) || is_surface_and_many(a, b) ||
         is_surface_and_many(b, a) || ((kinds.assembly[a] || kinds.assembly[b]) && may_be_child(a) && may_be_child(b));
}

bool may_be_of(std::span<const SidesOfChildren> memories, const AnyShape& a, const AnyShape& b) {
  const bool are_lone = !is_assembly(a) && !is_assembly(b);
  const auto may_touch = [&](std::size_t surface, std::size_t body) {
    return is_surface_and_body(surface, body) || (are_lone && is_surface_and_many(surface, body));
  };
  const auto is_right = [&](const SidesOfChildren& its) {
    const AnyShape *const of_a = child_of(a, its.child_a), *const of_b = child_of(b, its.child_b);
    return of_a != nullptr && of_b != nullptr &&
           ((may_touch(of_a->index(), of_b->index()) && may_be_of(its.memory, *of_a)) ||
            (may_touch(of_b->index(), of_a->index()) && may_be_of(its.memory, *of_b)));
  };
  bool are_right = std::ranges::all_of(memories, is_right);
  for (std::size_t i = 1; i < memories.size(); ++i) {
    are_right = are_right && children_of(memories[i - 1]) < children_of(memories[i]);
  }
  return are_right;
}

namespace {

// Of many solids, each of which may touch a surface. `is_surface_a`: the surface is side a.
bool contacts_of_many(const AnyShape& surface, const AnyShape& all, const Pose& placed, const Pose& of_all,
                      bool is_surface_a, const QuerySettings& settings, KeptSide& side, Manifold& out) {
  std::vector<std::uint32_t> passed;
  Manifold of_touching;
  ask_many(all, [&]<class S>(const S& many) {
    Aabb near = box_of(surface, relative(of_all, placed)).inflated(std::max(settings.margin, Real{0}));
    many.visit_places(near, [&](const Vec3& place, std::uint32_t index) {
      const std::uint32_t child_a = is_surface_a ? 0 : index, child_b = is_surface_a ? index : 0;
      SideMemory after;
      const Pose of_one{of_all.rotation, of_all * place};
      std::optional<Manifold> found =
          contacts_of_passed(surface, OneOfMany<typename S::Part>{many.part(index)}, relative(placed, of_one), settings,
                             memory_of(side.before, child_a, child_b), after);
      if (!after.is_empty()) {
        side.after.push_back({child_a, child_b, std::move(after)});
      }
      if (!found) {
        return;
      }
      passed.push_back(index);
      for (ContactPoint& contact : *found) {
        move_by(contact, Pose::identity(), true);
        name_particle_a(contact, index);
        move_by(contact, placed, is_surface_a);
        of_touching.push_back(contact);
      }
    });
  });
  std::ranges::sort(side.after, {}, children_of);
  if (passed.empty()) {
    return false;
  }
  std::ranges::sort(passed);
  // Those that touch nothing are as without a memory.
  Manifold plain;
  add_contacts(surface, all, placed, of_all, settings, plain);
  for (ContactPoint& contact : plain) {
    if (!std::ranges::binary_search(passed, contact.child_b)) {
      move_by(contact, Pose::identity(), !is_surface_a);
      out.push_back(contact);
    }
  }
  out.insert(out.end(), of_touching.begin(), of_touching.end());
  return true;
}

// Of a surface and a convex body, or of such children of composites.
bool contacts_of_bodies(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                        KeptSide& side, Manifold& out) {
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
        std::optional<Manifold> found = contacts_of_passed(surface, LoneBody{body}, relative(placed, of_body), settings,
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
  // Other children are as without a memory.
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
        name_children(a, b, child_a, child_b, std::span(out).subspan(begin));
      });
  const PlacedSide of_a{a, Pose::identity(), false}, of_b{b, ab, true};
  settle_seams(of_a, of_b, settings, first, out);
  settle_seams(of_b, of_a, settings, first, out);
  return true;
}

}  // namespace

bool contacts_on_side(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                      KeptSide& side, Manifold& out) {
  side.after.clear();
  if (a.has_holes() || b.has_holes()) {
    return false;
  }
  if (is_surface_and_many(a.index(), b.index())) {
    return contacts_of_many(a, b, Pose::identity(), ab, true, settings, side, out);
  }
  if (is_surface_and_many(b.index(), a.index())) {
    return contacts_of_many(b, a, ab, Pose::identity(), false, settings, side, out);
  }
  return contacts_of_bodies(a, b, ab, settings, side, out);
}

}  // namespace abut
