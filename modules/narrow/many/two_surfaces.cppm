// SPDX-License-Identifier: Apache-2.0
// Two surfaces: the triangles that are near each other, which both trees find together.
export module abut.narrow.many.two_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.many.fronts_ahead;
import abut.narrow.many.nearest_of_parts;
import abut.narrow.many.parts_met;
import abut.narrow.many.passing_boxes;
import abut.narrow.many.quick_axes;
import abut.narrow.many.solid_contacts;
import abut.narrow.many.solid_depth;
import abut.narrow.many.solid_pair_depth;
import abut.narrow.many.surface_contacts;
export import abut.narrow.many.surfaces;
import abut.narrow.many.two_parts;

export namespace abut {

// Nothing where no side is a solid, or where nothing is inside.
template <Surface A, Surface B>
[[nodiscard]] std::optional<SolidDepth> depth_of_solids(const A& a, const B& b, const Pose& ab,
                                                        const QuerySettings& settings) {
  if constexpr (Enclosing<A> && Enclosing<B>) {
    if (a.is_solid() || b.is_solid()) {
      return solid_pair_depth(a, b, ab, settings);
    }
  }
  return std::nullopt;
}

// What two surfaces may meet of each other on a way of the second one.
template <Surface A, Surface B>
class PairsOnTheWay {
 public:
  PairsOnTheWay(const A& a, const B& b, const Pose& ab) : a_(a), b_(b), ab_(ab), boxes_(ab.rotation) {}

  // A bit for each pair.
  [[nodiscard]] std::uint64_t meets(const FourParts<Triangle>& parts, const PartingWay& way) const {
    const Vec3 along = way.depth * way.direction;
    const std::uint64_t near = QuickAxes<Triangle>::near_on_way(parts.triangles, parts.placed.of, along, 0);
    return near == 0 ? 0 : near & boxes_.meet(parts.triangles, parts.placed.of, along, 0);
  }
  // Whether either may run into a front of the other on a way.
  [[nodiscard]] bool meets_front(const PartingWay& way, Real slack) const {
    const Vec3 back = -ab_.rotation.undo(way.direction);
    const auto in_way = [&](const auto& surface, const Pose& pose, const Vec3& direction) {
      return surface.aabb(pose).swept({0, 0, 0}, way.depth * direction).inflated(slack);
    };
    return has_front_against(b_, in_way(a_, ab_.inverse(), back), back) ||
           has_front_against(a_, in_way(b_, ab_, way.direction), way.direction);
  }
  // Calls visit(part of a, part of b, where they meet, where they part) for what may meet on a stretch of a way. What
  // parts no later than `least` is passed over.
  template <class Visitor>
  void visit(const Stretch& on, Real least, Real slack, const Visitor& visit) const {
    const Real length = on.end - on.begin;
    const Vec3 along = length * on.direction;
    const Columns direction = Columns::all(on.direction);
    const Pose begin{ab_.rotation, ab_.position + on.begin * on.direction};
    // What was asked for last.
    Lanes share{}, leave{};
    std::array<std::uint32_t, 4> numbers{};
    const auto near = [&](const FourTriangles& parts, const FourTriangles& placed) -> std::uint64_t {
      const Lanes high = maximum(maximum(dot(direction, parts.a), dot(direction, parts.b)), dot(direction, parts.c)),
                  low = minimum(minimum(dot(direction, placed.a), dot(direction, placed.b)), dot(direction, placed.c));
      leave = on.begin + (high - low);
      std::uint64_t found = bits_of(leave > all_lanes(least));
      found = found == 0 ? 0 : found & QuickAxes<Triangle>::near_on_way(parts, placed, along, slack);
      if (found != 0) {
        share = boxes_.enter(parts, placed, along, slack);
        numbers = parts.numbers;
        found &= bits_of(share <= all_lanes(1));
      }
      return found;
    };
    const auto visit_near = [&](const Triangle& part, const Triangle& other) {
      const auto lane = static_cast<std::size_t>(std::ranges::find(numbers, part.index()) - numbers.begin());
      visit(part, other, on.begin + share[lane] * length, leave[lane]);
    };
    bool are_visited = false;
    if constexpr (Terrain<B> && !Terrain<A>) {
      are_visited = visit_parts_on(a_, b_, begin, along, slack, near, visit_near);
    }
    if (!are_visited) {
      visit_two_parts_on_way(a_, b_, begin, on.direction, length, slack, near, visit_near);
    }
  }

 private:
  const A& a_;
  const B& b_;
  const Pose& ab_;
  PassingBoxes boxes_;
};

template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const std::size_t first = out.size();
  SurfaceContacts<A, B> contacts(a, b, ab, settings, out);
  const Real reach = std::max(settings.margin, Real{0});
  const auto add = [&](const Triangle& part, const Triangle& other) {
    contacts.add(part, other, other.index());
    return reach;
  };
  bool are_visited = false;
  if constexpr (Terrain<B> && !Terrain<A>) {
    const auto near = [&](const FourTriangles& parts, const FourTriangles& placed) {
      return QuickAxes<Triangle>::near_on_way(parts, placed, {0, 0, 0}, reach);
    };
    are_visited = visit_parts_on(a, b, ab, {0, 0, 0}, reach, near, add);
  }
  if (!are_visited) {
    visit_two_parts(a, b, ab, reach, add);
  }
  contacts.finish(PairsOnTheWay(a, b, ab), [] {});
  settle_depth(depth_of_solids(a, b, ab, settings), first, settings.margin, out);
  return Outcome::ok;
}

// The gap between the planes across a normal that hold all of one surface and all of another. What lies too far behind
// its plane is not the nearest.
template <Surface A, Surface B>
class SlabBetween {
 public:
  SlabBetween(const A& a, const B& b, const Pose& ab) : a_(a), b_(b), ab_(ab) {}

  void turn(const Vec3& normal) {
    normal_ = normal;
    local_ = ab_.rotation.undo(normal);
    shift_ = dot(normal, ab_.position);
    high_a_ = -lowest_of(a_, -normal_);
    low_b_ = lowest_of(b_, local_) + shift_;
  }
  // No point of the other surface is nearer to the part.
  [[nodiscard]] Real gap_of(std::uint32_t part, bool is_of_b) const {
    return is_of_b ? least_along(b_.corners(part), local_) + shift_ - high_a_
                   : low_b_ + least_along(a_.corners(part), -normal_);
  }
  // No points of two parts are nearer to each other.
  [[nodiscard]] Real gap_of(const Triangle& part, const Triangle& other) const {
    return least_along(other.corners(), local_) + shift_ + least_along(part.corners(), -normal_);
  }

 private:
  const A& a_;
  const B& b_;
  const Pose& ab_;
  Vec3 normal_{0, 0, 0}, local_{0, 0, 0};
  Real shift_ = 0, high_a_ = infinity, low_b_ = -infinity;
};

// The nearest or deepest two triangles, each as a sheet.
template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  if (const auto depth = depth_of_solids(a, b, ab, settings)) {
    out = distance_of(*depth);
    return Outcome::ok;
  }
  out = no_distance();
  Triangle other = b.part_near(ab.undo(a.aabb(Pose::identity()).centre()));
  Triangle triangle = a.part_near(ab * other.centre());
  take_nearer(triangle, other, ab, settings, out);
  // What is as near as the nearest so far, within rounding, is passed over: of parallel surfaces, that would be all.
  const Real rounding = 4 * noise_of_two(a, b, ab);
  SlabBetween<A, B> slab(a, b, ab);
  const auto reach = [&] {
    return out.distance > rounding ? out.distance - rounding : std::max(out.distance, Real{0});
  };
  slab.turn(out.normal);
  const auto visit = [&](const Triangle& part, const Triangle& part_of_b) {
    if (slab.gap_of(part, part_of_b) <= reach() && take_nearer(part, part_of_b, ab, settings, out)) {
      triangle = part;
      other = part_of_b;
      slab.turn(out.normal);
    }
    return reach();
  };
  visit_two_parts(a, b, ab, reach(), visit,
                  [&](std::uint32_t part, bool is_of_b) { return slab.gap_of(part, is_of_b) <= reach(); });
  out.lower = out.distance > rounding ? std::min(out.lower, out.distance - rounding) : out.lower;
  const Real noise = noise_of(core_size(triangle, other, ab));
  if (out.distance < -noise) {
    Manifold contacts;
    static_cast<void>(surfaces_contacts(a, b, ab, without_margin(settings), contacts));
    take_depth_of(contacts, noise, out);
  }
  return Outcome::ok;
}

}  // namespace abut
