// SPDX-License-Identifier: Apache-2.0
module abut.proximity.search;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.proximity.body;
import abut.trees.elements.element_tree;

namespace abut {

void ElementSearch::begin(ElementBody& a, ElementBody& b, Real reach, const Workers& workers) {
  constexpr std::size_t least_pairs = 1024, most_tasks = 256;
  Aabb box = a.box();
  box.include(b.box());
  const Vec3 origin = origin_for(box);
  const Real half = 0.5 * reach;
  a.fit(origin, half, workers);
  b.fit(origin, half, workers);
  pairs_.cut(a.tree(), b.tree(), least_pairs);
  cuts_ = Cuts(pairs_.list().size(), std::min(pairs_.list().size(), most_tasks));
}

}  // namespace abut
