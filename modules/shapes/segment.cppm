// A segment along local Z, centred: a capsule without a radius.
module;
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.segment;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Segment {
 public:
  static constexpr std::string_view name = "segment";
  static constexpr std::array<std::string_view, 1> parameter_names{"half_length"};
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 1;

  [[nodiscard]] static Result<Segment> make(std::span<const Real> parameters, std::span<const Real> reals,
                                            std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 1)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    if (Fault fault = check_not_negative("half_length", parameters[0])) {
      return *fault;
    }
    return Segment(parameters[0]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {half_length_}; }
  [[nodiscard]] static std::vector<Segment> samples() { return {Segment(1), Segment(0), Segment(1e-3), Segment(40)}; }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    return Aabb::around(pose.position, half_length_ * absolute(pose.rotation.z));
  }
  [[nodiscard]] inline Vec3 half() const { return {0, 0, half_length_}; }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return half_length_; }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const bool upper = direction.z >= 0;
    return {{0, 0, upper ? half_length_ : -half_length_}, upper ? 1u : 0u};
  }
  [[nodiscard]] inline Real reach(const Vec3& direction) const { return half_length_ * std::fabs(direction.z); }
  [[nodiscard]] inline PlacedSegment placed(const Pose& pose) const { return {pose.position, half_length_ * pose.rotation.z}; }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, -half_length_}, 0, 0});
    if (half_length_ > 0) {
      face.vertices.push_back({{0, 0, half_length_}, 1, 0});
    }
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const {
    return {half_length_ > 0 ? FeatureKind::edge : FeatureKind::vertex, 0};
  }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 1> edge_directions() const { return {Vec3{0, 0, 1}}; }

  // No ray meets a segment, but for rounding.
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3&, const UnitVec3&, Real) const { return std::nullopt; }

 private:
  explicit Segment(Real half_length) : half_length_(half_length) {}
  Real half_length_;
};
static_assert(Shape<Segment> && Placeable<Segment> && SegmentCored<Segment> && FewFaced<Segment>);

}  // namespace abut
