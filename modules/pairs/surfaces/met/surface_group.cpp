// SPDX-License-Identifier: Apache-2.0
module abut.pairs.surfaces.surface_group;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.particles_on_surface;
import abut.narrow.surface.surfaces;
import abut.narrow.triangle.stopping_sides;
import abut.narrow.triangle.triangle_point;
import abut.narrow.surface.triangle_source;
import abut.pairs.composites.children;
import abut.pairs.registry;
import abut.pairs.surfaces.met.convex_on_source;

namespace abut {
namespace {

// A child, the numbers of whose triangles begin at `first`.
struct [[gsl::Pointer]] Member {
  const AnyShape* shape;
  Pose pose;
  std::uint32_t child, first;
};

template <class Ask>
auto ask_source(const Member& member, Ask&& ask) {
  std::optional<std::invoke_result_t<Ask, const TriangleSource&>> answer;
  with_surface(*member.shape, [&]<class S>(const S& surface) { answer = ask(SourceOf<S>(surface)); });
  return *answer;
}

// Above the numbers of all triangles of a surface.
std::size_t part_end_of(const AnyShape& shape) {
  std::size_t end = 0;
  with_surface(shape, [&]<class S>(const S& surface) {
    if constexpr (requires { surface.part_end(); }) {
      end = surface.part_end();
    } else {
      end = surface.triangle_count();
    }
  });
  return end;
}

// All members stop alike.
class SurfaceGroup final : public TriangleSource {
 public:
  SurfaceGroup(std::span<const ChildPair> group, bool is_surface_a) {
    std::size_t first = 0;
    for (const ChildPair& pair : group) {
      const AnyShape& shape = is_surface_a ? *pair.a : *pair.b;
      members_.push_back({&shape, is_surface_a ? pair.pose_a : pair.pose_b, is_surface_a ? pair.child_a : pair.child_b,
                          static_cast<std::uint32_t>(first)});
      first += part_end_of(shape);
    }
  }

  // The child that a triangle is of.
  [[nodiscard]] std::uint32_t child_of(std::uint32_t number) const { return member_of(number).child; }

  Aabb box() const override {
    Aabb all = Aabb::empty();
    for (const Member& member : members_.span()) {
      all.include(box_of(*member.shape, member.pose));
    }
    return all;
  }
  bool is_placed() const override { return true; }
  void visit(const Aabb& box, const TakeFour& take) const override {
    bool goes_on = true;
    for (const Member& member : members_.span()) {
      if (!goes_on || !box_of(*member.shape, member.pose).overlaps(box)) {
        continue;
      }
      const Aabb turned = transformed(box, member.pose.inverse());
      const Real noise = noise_of(largest_magnitude(maximum(absolute(turned.low), absolute(turned.high))) +
                                  largest_magnitude(member.pose.position));
      ask_source(member, [&](const TriangleSource& source) {
        source.visit(turned.inflated(noise), [&](const FourTriangles& local, std::uint64_t present) {
          FourTriangles four = placed(local, member.pose);
          for (std::uint32_t& number : four.numbers) {
            number += member.first;
          }
          present &= four.overlapping(box);
          goes_on = present == 0 || take(four, present);
          return goes_on;
        });
        return true;
      });
    }
  }
  Triangle part(std::uint32_t number) const override { return part_of(member_of(number), number); }
  std::uint32_t number_in_shape(std::uint32_t number) const override { return number - member_of(number).first; }
  Triangle part_near(const Vec3& point) const override {
    std::optional<Triangle> nearest;
    Real least = infinity;
    for (const Member& member : members_.span()) {
      const Triangle found =
          ask_source(member, [&](const TriangleSource& source) { return source.part_near(member.pose.undo(point)); });
      const Triangle part = part_of(member, found.index() + member.first);
      const Real square = squared_norm(nearest_on(part.corners(), point) - point);
      if (!nearest || square < least) {
        nearest = part;
        least = square;
      }
    }
    return *nearest;
  }
  std::uint64_t one_sided(const FourTriangles& four) const override {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < 4 && sides() != StoppingSides::both; ++lane) {
      bits |= std::uint64_t{part(four.numbers[lane]).is_one_sided() ? 1u : 0u} << lane;
    }
    return bits;
  }
  std::uint64_t holding(const FourTriangles&) const override { return sides() == StoppingSides::solid ? 15 : 0; }
  StoppingSides sides() const override { return *sides_of_surface(*members_[0].shape); }
  bool is_terrain() const override { return false; }
  bool contains(const Vec3& point) const override {
    return std::ranges::any_of(members_.span(), [&](const Member& member) {
      return ask_source(member, [&](const TriangleSource& source) { return source.contains(member.pose.undo(point)); });
    });
  }
  std::optional<WayToSurface> way_to_surface(const Vec3& from, const Vec3& direction) const override {
    std::optional<WayToSurface> shortest;
    for (const Member& member : members_.span()) {
      auto way = ask_source(member, [&](const TriangleSource& source) {
        return source.way_to_surface(member.pose.undo(from), member.pose.rotation.undo(direction));
      });
      if (way && (!shortest || way->length < shortest->length)) {
        shortest = WayToSurface{way->length, member.pose.rotation * way->normal, way->part + member.first};
      }
    }
    return shortest;
  }
  PointOnSurface nearest(const Vec3& point) const override {
    PointOnSurface best{point, infinity, no_index};
    for (const Member& member : members_.span()) {
      const PointOnSurface found =
          ask_source(member, [&](const TriangleSource& source) { return source.nearest(member.pose.undo(point)); });
      if (found.distance < best.distance) {
        best = {member.pose * found.point, found.distance, found.part + member.first};
      }
    }
    return best;
  }
  bool is_crest(std::uint32_t number, unsigned corners, const Vec3& direction, Real height) const override {
    const Member& member = member_of(number);
    return ask_source(member, [&](const TriangleSource& source) {
      return source.is_crest(number - member.first, corners, member.pose.rotation.undo(direction), height);
    });
  }

 private:
  [[nodiscard]] const Member& member_of(std::uint32_t number) const [[clang::lifetimebound]] {
    const std::span<const Member> all = members_.span();
    const auto after = std::lower_bound(all.begin(), all.end(), number,
                                        [](const Member& member, std::uint32_t its) { return member.first <= its; });
    return *(after - 1);
  }
  [[nodiscard]] static Triangle part_of(const Member& member, std::uint32_t number) {
    const Triangle local =
        ask_source(member, [&](const TriangleSource& source) { return source.part(number - member.first); });
    const auto& [a, b, c] = local.corners();
    return {{member.pose * a, member.pose * b, member.pose * c}, number, local.is_one_sided()};
  }

  SmallVector<Member, 8> members_;
};

// What of a child may leave together with others.
void add_bodies(const AnyShape& child, const Pose& pose, const TriangleSource& surface, Real reach,
                const QuerySettings& settings, BodiesOnSurface& bodies) {
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Scattered<S>) {
          add_near_particles(s, pose, surface, reach, settings, bodies);
        } else if constexpr (Convex<S>) {
          bodies.push_back(body_on_source(surface, child, pose, settings));
        }
      },
      static_cast<const AnyShape::Variant&>(child));
}

const AnyShape& body_of(const ChildPair& pair, bool is_surface_a) { return is_surface_a ? *pair.b : *pair.a; }
const Pose& pose_of_body(const ChildPair& pair, bool is_surface_a) { return is_surface_a ? pair.pose_b : pair.pose_a; }

}  // namespace

std::optional<StoppingSides> sides_of_surface(const AnyShape& shape) {
  std::optional<StoppingSides> sides;
  with_surface(shape, [&](const auto& surface) { sides = stopping_sides(surface); });
  return sides;
}

ChildPairs group_of(const AnyShape& a, const AnyShape& b, const Pose& ab, const ChildPair& pair, bool is_surface_a) {
  const AnyShape &composite = is_surface_a ? a : b, &surface = is_surface_a ? *pair.a : *pair.b,
                 &body = body_of(pair, is_surface_a);
  const auto sides = sides_of_surface(surface);
  ChildPairs group;
  if (!sides || !is_assembly(composite) || !is_convex(body)) {
    return group;
  }
  // A way out is mostly no longer than the body.
  const Pose pose = is_surface_a ? Pose::identity() : ab;
  const Aabb box = box_of(body, pose.inverse() * pose_of_body(pair, is_surface_a));
  visit_children(composite, pose, box.inflated(norm(box.high - box.low)),
                 [&](const AnyShape& child, const Pose& placed, std::uint32_t number) {
                   if (sides_of_surface(child) == sides) {
                     group.push_back(is_surface_a
                                         ? ChildPair{&child, pair.b, placed, pair.pose_b, number, pair.child_b}
                                         : ChildPair{pair.a, &child, pair.pose_a, placed, pair.child_a, number});
                   }
                 });
  std::ranges::sort(group.span(), {}, [](const ChildPair& its) { return std::pair(its.child_a, its.child_b); });
  return group;
}

bool may_group(const QuerySettings& settings) { return parts_support(settings.algorithm); }

void contacts_of_group(std::span<const ChildPair> group, bool is_surface_a, const QuerySettings& settings,
                       Manifold& out) {
  const SurfaceGroup surface(group, is_surface_a);
  const std::size_t first = out.size();
  contacts_on_source(surface, body_of(group[0], is_surface_a), pose_of_body(group[0], is_surface_a), settings, out);
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    const std::uint32_t number = contact.feature_a.index, child = surface.child_of(number);
    contact.feature_a.index = surface.number_in_shape(number);
    contact.child_a = child;
    if (!is_surface_a) {
      move_by(contact, Pose::identity(), true);
    }
  }
}

bool depth_of_group(std::span<const ChildPair> group, bool is_surface_a, const QuerySettings& settings, Distance& out) {
  const SurfaceGroup surface(group, is_surface_a);
  const Pose& pose = pose_of_body(group[0], is_surface_a);
  const bool is_overlapped = depth_on_source(surface, body_of(group[0], is_surface_a), pose, settings, out);
  if (is_overlapped && !is_surface_a) {
    move_by(out, Pose::identity(), true);
  }
  return is_overlapped;
}

bool depth_of_children(const AnyShape& a, const AnyShape& b, const Pose& ab, bool is_surface_a, Real depth,
                       const QuerySettings& settings, Distance& out) {
  const AnyShape &ground = is_surface_a ? a : b, &composite = is_surface_a ? b : a;
  const Pose ground_pose = is_surface_a ? Pose::identity() : ab, body_pose = is_surface_a ? ab : Pose::identity();
  if (!is_assembly(composite) && !is_scattered(composite)) {
    return false;
  }
  bool is_found = false;
  for (const StoppingSides sides : {StoppingSides::both, StoppingSides::front, StoppingSides::solid}) {
    const auto gather = [&](Real reach, auto&& take) {
      const Aabb around = box_of(composite, ground_pose.inverse() * body_pose).inflated(reach);
      ChildPairs surfaces;
      visit_children(ground, ground_pose, around, [&](const AnyShape& child, const Pose& pose, std::uint32_t number) {
        if (sides_of_surface(child) == sides) {
          surfaces.push_back(is_surface_a ? ChildPair{&child, &b, pose, ab, number, 0}
                                          : ChildPair{&a, &child, Pose::identity(), pose, 0, number});
        }
      });
      if (surfaces.empty()) {
        return false;
      }
      std::ranges::sort(surfaces.span(), {}, [](const ChildPair& its) { return std::pair(its.child_a, its.child_b); });
      const SurfaceGroup group(surfaces.span(), is_surface_a);
      BodiesOnSurface bodies;
      visit_children(composite, body_pose, transformed(group.box().inflated(reach), body_pose.inverse()),
                     [&](const AnyShape& child, const Pose& pose, std::uint32_t) {
                       add_bodies(child, pose, group, reach, settings, bodies);
                     });
      return take(bodies, surfaces.size() + bodies.size());
    };
    Distance found{};
    if (!depth_within_reach(depth, sides, gather, found)) {
      continue;
    }
    if (!is_surface_a) {
      move_by(found, Pose::identity(), true);
    }
    if (!is_found || found.distance < out.distance) {
      out = found;
    }
    is_found = true;
  }
  return is_found;
}

}  // namespace abut
