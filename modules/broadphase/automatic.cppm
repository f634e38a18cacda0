// SPDX-License-Identifier: Apache-2.0
// Which broad phase suits the boxes of a scene.
export module abut.broadphase.automatic;
import abut.core.standard;

export namespace abut {

enum class BroadphaseKind : std::uint32_t { automatic = 0, brute = 1, tree = 2, sweep_and_prune = 3, hash_grid = 4 };

[[nodiscard]] std::string_view name_of(BroadphaseKind kind);

// What is known of the boxes.
struct BroadphaseCounts {
  std::size_t present = 0;  // hidden ones too
  std::size_t moving = 0;   // of those, not still
};

enum class BroadphaseReason : std::uint8_t { few_boxes, trying_all_costs_less, following_costs_less };
[[nodiscard]] std::string_view text_of(BroadphaseReason reason);

struct BroadphaseChoice {
  BroadphaseKind kind = BroadphaseKind::automatic;
  BroadphaseReason reason = BroadphaseReason::few_boxes;
};

// `before` is the kind in use, or automatic. Near a border it stays, so that a scene there does not go back and forth.
[[nodiscard]] BroadphaseChoice choose_broadphase(const BroadphaseCounts& counts, BroadphaseKind before);

}  // namespace abut
