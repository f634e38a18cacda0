// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <vector>

module abut.picking;
import :entry;
import :hit;
import :tracer;
import :vector;

namespace abut::picking {

void merge_crossings(std::vector<AllHits::Crossing>& crossings, const abut_vec3& direction,
                     std::vector<abut_pick>& out) {
  // Of crossings in one place, as of a box without thickness, the one that enters comes first.
  const auto enters = [&](const AllHits::Crossing& its) { return dot(its.pick.normal, direction) < 0; };
  std::ranges::sort(crossings, [&](const AllHits::Crossing& a, const AllHits::Crossing& b) {
    if (a.pick.distance != b.pick.distance) return a.pick.distance < b.pick.distance;
    if (a.pick.geometry.slot != b.pick.geometry.slot) return a.pick.geometry.slot < b.pick.geometry.slot;
    if (enters(a) != enters(b)) return enters(a);
    if (a.pick.child != b.pick.child) return a.pick.child < b.pick.child;
    return a.pick.feature.index < b.pick.feature.index;
  });
  out.clear();
  for (const AllHits::Crossing& crossing : crossings) {
    if (crossing.blur < 0) {
      out.push_back(crossing.pick);
      continue;
    }
    // The last crossing of the same geometry decides: a surface is not entered twice in a row there.
    const auto last = std::find_if(out.rbegin(), out.rend(), [&](const abut_pick& pick) {
      return pick.geometry.slot == crossing.pick.geometry.slot;
    });
    const bool repeats = last != out.rend() && (dot(last->normal, direction) < 0) == enters(crossing) &&
                         crossing.pick.distance - last->distance <= crossing.blur;
    if (!repeats) out.push_back(crossing.pick);
  }
}

}  // namespace abut::picking
