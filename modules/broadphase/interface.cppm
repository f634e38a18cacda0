// SPDX-License-Identifier: Apache-2.0
// What every broad phase can do.
export module abut.broadphase.interface;
import abut.broadphase.brute;
import abut.broadphase.hash_grid;
import abut.broadphase.proxy;
import abut.broadphase.sweep_and_prune;
import abut.broadphase.tree;
import abut.core.standard;
import abut.core.workers;
import abut.math;

export namespace abut {

// Boxes have numbers of the caller: small, each in use once. The time of a call depends on the boxes that are there,
// not on their numbers. Sides may be infinite but not NaN; low sides are below infinity, high ones above minus
// infinity.
template <class T>
concept BroadPhase = std::default_initializable<T> && std::movable<T> &&
                     requires(T broad_phase, const T& constant, std::uint32_t proxy, const CompactAabb& box,
                              Mobility mobility, std::uint32_t group, const Workers& workers,
                              std::span<const std::uint32_t> proxies, std::span<const CompactAabb> boxes_by_proxy,
                              std::vector<ProxyPair>& pairs, void (*visit_proxy)(std::uint32_t), const Vec3& vector,
                              Real most, Real (*visit_met)(std::uint32_t, Real)) {
                       broad_phase.insert(proxy, box, mobility, group);
                       broad_phase.erase(proxy);
                       broad_phase.update(proxy, box);  // not while it is hidden
                       // Each of these numbers once. The same as one by one.
                       broad_phase.update_all(workers, proxies, boxes_by_proxy);
                       // A hidden box is in no pair and no query until it is shown again, which costs next to nothing
                       // near where it was.
                       broad_phase.hide(proxy);
                       broad_phase.show(proxy, box);

                       // All pairs of overlapping boxes, touching included, by (low, high); never of one group, never
                       // of two still boxes. The same for any number of threads.
                       broad_phase.find_pairs(pairs);
                       broad_phase.find_pairs(workers, pairs);

                       // These may run at once on several threads.
                       // Calls visit_proxy(proxy) for all boxes that overlap.
                       constant.visit(box, visit_proxy);
                       // Calls visit_met(proxy, entry) for the boxes that are met by one with this centre and these
                       // half extents, displaced by t times a displacement, for some t from 0 to `most`, which may be
                       // infinite. The first such t is not below `entry`. It returns up to which t it wants more.
                       constant.sweep(vector, vector, vector, most, visit_met);

                       { constant.size() } -> std::same_as<std::size_t>;
                       { constant.hidden() } -> std::same_as<std::size_t>;
                       { constant.bytes() } -> std::same_as<std::size_t>;
                     };

static_assert(BroadPhase<Brute> && BroadPhase<SweepAndPrune> && BroadPhase<Tree> && BroadPhase<Grid>);

using AnyBroadPhase = std::variant<Brute, SweepAndPrune, Tree, Grid>;

}  // namespace abut
