// SPDX-License-Identifier: Apache-2.0
// What trees over many items offer, whatever volumes they are made of: boxes along the axes, oriented boxes or balls.
// And what a volume offers to a tree.
export module abut.capability.parts.item_tree;
import abut.core.standard;
import abut.math;

export namespace abut {

struct AcceptsAnyItem {
  void operator()(std::uint32_t) const {}
};

// - visit_overlaps visits at least all items that overlap a box, which the visitor may shrink on the way.
// - visit_ray visits at least all items that a ray meets within a limit, which the visitor may lower; nearer nodes come
//   first.
// - visit_below visits at least all items that reach down to a height along a direction, which the visitor may lower;
//   lower nodes come first.
// - item_near gives some item close to a point. There has to be one.
// - settle makes volumes fit after items have changed, and is_worn tells whether a new tree would serve better.
template <class T>
concept ItemTree =
    requires(const T& tree, T& changing, const Aabb& query, const Vec3& v, Real& limit, AcceptsAnyItem visit) {
      tree.visit_overlaps(query, visit);
      tree.visit_ray(v, v, limit, visit);
      tree.visit_below(v, limit, visit);
      { tree.item_near(v) } -> std::same_as<std::uint32_t>;
      { tree.bytes() } -> std::same_as<std::size_t>;
      { changing.is_worn() } -> std::same_as<bool>;
      changing.make_room();
    };

// A volume around points, or around two others where another one was. Of none all answers are those of nothing.
template <class V>
concept BoundingVolume = std::default_initializable<V> &&
                         requires(const V& volume, std::span<const Vec3> points, const Aabb& box, const Vec3& v) {
                           { V::around(points) } -> std::same_as<V>;
                           { V::around(volume, volume, volume) } -> std::same_as<V>;
                           { volume.overlaps(box) } -> std::same_as<bool>;
                           { volume.lowest_along(v) } -> std::same_as<Real>;
                           { volume.entry_of(v, v) } -> std::same_as<Real>;
                           { volume.distance_to(v) } -> std::same_as<Real>;
                           { volume.surface() } -> std::same_as<Real>;
                           { volume.is_empty() } -> std::same_as<bool>;
                         };

}  // namespace abut
