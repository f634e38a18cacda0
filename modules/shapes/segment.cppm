// SPDX-License-Identifier: Apache-2.0
// A segment along local Z, centred: a capsule without a radius.
export module abut.shapes.segment;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Segment : public SegmentCore {
 public:
  static constexpr std::string_view name = "segment";
  static constexpr std::array<std::string_view, 1> parameter_names{"half_length"};

  [[nodiscard]] static Result<Segment> make(std::span<const Real> parameters, std::span<const Real> reals,
                                            std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    return Segment(parameters[0]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {half_length()}; }
  [[nodiscard]] static std::vector<Segment> samples() { return {Segment(1), Segment(0), Segment(1e-3), Segment(40)}; }

  // No ray meets a segment, but for rounding.
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3&, const UnitVec3&, Real) const { return std::nullopt; }

 private:
  explicit Segment(Real half_length) : SegmentCore(half_length, 0) {}
};
static_assert(Shape<Segment> && Placeable<Segment> && SegmentCored<Segment> && FewFaced<Segment>);

}  // namespace abut
