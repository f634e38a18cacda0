// SPDX-License-Identifier: Apache-2.0
module abut.broadphase.automatic;
import abut.core.standard;

namespace abut {
namespace {

// Where brute force and the tree took the same time when measured (docs/broadphases.md): brute force looks at all
// pairs, eight at once, whatever moves; a step of the tree costs as much for each moving box as brute force for about
// so many pairs.
constexpr std::size_t pairs_of_moving = 200;

// So few boxes never make the difference worth a change.
constexpr std::size_t few = 32;

// The present kind stays until the other one is better by this factor.
constexpr std::size_t reluctance = 2;

}  // namespace

std::string_view name_of(BroadphaseKind kind) {
  switch (kind) {
    case BroadphaseKind::automatic: return "automatic";
    case BroadphaseKind::brute: return "brute force";
    case BroadphaseKind::tree: return "tree";
    case BroadphaseKind::sweep_and_prune: return "sweep and prune";
    case BroadphaseKind::hash_grid: return "hash grid";
  }
  return "unknown";
}

std::string_view text_of(BroadphaseReason reason) {
  switch (reason) {
    case BroadphaseReason::few_boxes: return "few boxes";
    case BroadphaseReason::trying_all_costs_less: return "trying all pairs costs less than following what moves";
    case BroadphaseReason::following_costs_less: return "following what moves costs less than trying all pairs";
  }
  return "unknown";
}

BroadphaseChoice choose_broadphase(const BroadphaseCounts& counts, BroadphaseKind before) {
  if (counts.present <= few || (before == BroadphaseKind::brute && counts.present <= reluctance * few)) {
    return {BroadphaseKind::brute, BroadphaseReason::few_boxes};
  }
  // No overflow: beyond this there is no question.
  constexpr std::size_t many = 4096;
  const std::size_t pairs = counts.present < many ? counts.present * counts.present : many * counts.present;
  const std::size_t scale = before == BroadphaseKind::brute ? reluctance : 1;
  const std::size_t divisor = before == BroadphaseKind::tree ? reluctance : 1;
  if (counts.present < many && divisor * pairs < scale * pairs_of_moving * counts.moving) {
    return {BroadphaseKind::brute, BroadphaseReason::trying_all_costs_less};
  }
  return {BroadphaseKind::tree, BroadphaseReason::following_costs_less};
}

}  // namespace abut
