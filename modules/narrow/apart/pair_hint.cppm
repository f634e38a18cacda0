// SPDX-License-Identifier: Apache-2.0
// What a query leaves of a pair of shapes for the next one of the same pair: where to begin. It proves nothing. Every
// answer is proven at the poses of its own query. Bits of another pair, or any other bits, are as good as none.
export module abut.narrow.apart.pair_hint;
import abut.capability.cores.core_feature;
import abut.core.standard;

export namespace abut {

// All zero it says nothing.
struct alignas(8) PairHint {
  std::array<std::uint32_t, 3> vertices_a, vertices_b;  // of the cores: their differences span the nearest point
  std::uint32_t vertex_count;                           // 1 to 3; else the vertices say nothing
  std::uint32_t is_from_b;                              // whether a here was the second shape of the call
  std::uint32_t is_overlapping;                         // whether the cores overlapped, so that vertices do not help
  std::uint32_t has_contacts;                           // whether the last query for contacts found any
  std::array<std::uint32_t, 2> features;                // packed: those of the normal of these contacts
  std::array<std::uint32_t, 4> reserved;
};
static_assert(sizeof(PairHint) == 64 && std::is_trivially_copyable_v<PairHint>);

// The same for the shapes in the other order.
inline void swap_sides(PairHint& hint) {
  std::swap(hint.vertices_a, hint.vertices_b);
  hint.is_from_b = hint.is_from_b == 0 ? 1 : 0;
  hint.features = {};  // edges are directed for one order only
}

// A feature in 32 bits. Any bits make a feature, although no core may have it.
[[nodiscard]] inline std::uint32_t packed(const CoreFeature& feature) {
  return static_cast<std::uint32_t>(feature.kind) << 24 | (feature.is_backward ? 1u << 16 : 0u) | feature.index;
}
[[nodiscard]] inline CoreFeature unpacked(std::uint32_t bits) {
  return {static_cast<CoreFeature::Kind>(bits >> 24), (bits >> 16 & 1) != 0, static_cast<std::uint16_t>(bits)};
}

}  // namespace abut
