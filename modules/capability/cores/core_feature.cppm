// SPDX-License-Identifier: Apache-2.0
// The features of cores by the numbers that searches know them by, and which cores have such numbers.
export module abut.capability.cores.core_feature;
import abut.capability.concepts;
import abut.capability.cores.rim;
import abut.core.standard;
import abut.math;

export namespace abut {

// What of a core a normal belongs to, by the number that searches know it by:
// - a face of a box, a triangle or a round core: twice its axis, one more on the positive side;
// - an edge of a box, the segment and the side of a round core: the axis along it;
// - an edge of a triangle: the corner where it starts;
// - a face or an edge of a hull: its place in the hull's own lists.
struct CoreFeature {
  enum class Kind : std::uint8_t { none, edge, face };
  Kind kind;
  bool is_backward;  // an edge: the normal is across it as it leads from its end to its start
  std::uint16_t index;

  friend constexpr bool operator==(const CoreFeature&, const CoreFeature&) = default;
};
[[nodiscard]] inline CoreFeature core_face(std::size_t index) {
  return {CoreFeature::Kind::face, false, static_cast<std::uint16_t>(index)};
}
[[nodiscard]] inline CoreFeature core_edge(std::size_t index) {
  return {CoreFeature::Kind::edge, false, static_cast<std::uint16_t>(index)};
}

// The features that a normal follows from: a face of one core, or an edge of each. Neither where a search cannot say.
struct CoreFeatures {
  CoreFeature a, b;

  [[nodiscard]] inline bool are_edges() const { return a.kind == b.kind && a.kind == CoreFeature::Kind::edge; }
  [[nodiscard]] inline bool are_known() const { return a.kind != b.kind || are_edges(); }
  friend constexpr bool operator==(const CoreFeatures&, const CoreFeatures&) = default;
};

// A core that is a triangle.
template <class S>
concept Triangular = requires(const S& shape) {
  { shape.corners() } -> std::convertible_to<std::array<Vec3, 3>>;
};

}  // namespace abut
