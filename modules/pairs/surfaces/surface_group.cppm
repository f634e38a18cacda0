// SPDX-License-Identifier: Apache-2.0
// Surfaces that are children of one composite are one surface to a convex shape: where two of them meet, a way out of
// one may lead into the other.
export module abut.pairs.surfaces.surface_group;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.triangle.stopping_sides;
import abut.pairs.shape_handle;

export namespace abut {

// A pair of children, placed in one frame. A shape that is no composite is its only child.
struct [[gsl::Pointer]] ChildPair {
  const AnyShape *a, *b;
  Pose pose_a, pose_b;
  std::uint32_t child_a, child_b;
};

using ChildPairs = SmallVector<ChildPair, 16>;

// What stops of a shape that is a surface.
[[nodiscard]] std::optional<StoppingSides> sides_of_surface(const AnyShape& shape);

// The surface of a pair and those beside it, each as a pair with the convex shape. All are children of one composite
// and stop alike, and a way out may meet them. Empty where the pair has no surface in a composite. `a`, `b`: the whole
// shapes, b placed by `ab`.
[[nodiscard]] ChildPairs group_of(const AnyShape& a, const AnyShape& b, const Pose& ab, const ChildPair& pair,
                                  bool is_surface_a);

// Parts pairs of two shapes into those of one convex shape and surfaces that are a group, and all others. Calls
// take_group(pairs, is_surface_a) and take(pair), in the order of the first ones, and uses up the pairs.
template <class Take, class TakeGroup>
void in_surface_groups(const AnyShape& a, const AnyShape& b, const Pose& ab, std::span<ChildPair> pairs, Take&& take,
                       TakeGroup&& take_group) {
  for (std::size_t first = 0; first < pairs.size(); ++first) {
    const ChildPair pair = pairs[first];
    if (pair.a == nullptr) {
      continue;
    }
    const bool is_surface_a = sides_of_surface(*pair.a).has_value();
    const ChildPairs group = group_of(a, b, ab, pair, is_surface_a);
    if (group.size() < 2) {
      take(pair);
      continue;
    }
    for (ChildPair& other : pairs.subspan(first)) {
      const bool is_member = std::ranges::any_of(group.span(), [&](const ChildPair& its) {
        return its.child_a == other.child_a && its.child_b == other.child_b;
      });
      other.a = is_member ? nullptr : other.a;
    }
    take_group(group.span(), is_surface_a);
  }
}

// Whether groups have answers under these settings. Then they are asked for.
[[nodiscard]] bool may_group(const QuerySettings& settings);
// The contacts of a group, with the numbers of the children of the composite, in the frame of the pairs.
void contacts_of_group(std::span<const ChildPair> group, bool is_surface_a, const QuerySettings& settings,
                       Manifold& out);
// The depth of a group. False where nothing is overlapped.
[[nodiscard]] bool depth_of_group(std::span<const ChildPair> group, bool is_surface_a, const QuerySettings& settings,
                                  Distance& out);
// The depth of all convex children and particles of a shape near surfaces of another one, which move out of these
// together. b is placed by `ab`, and `depth` is that of the deepest pair of children. False where fewer than two take
// part, or none is met.
[[nodiscard]] bool depth_of_children(const AnyShape& a, const AnyShape& b, const Pose& ab, bool is_surface_a,
                                     Real depth, const QuerySettings& settings, Distance& out);

}  // namespace abut
