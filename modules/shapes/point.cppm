// A point: the origin of its own frame.
module;
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.point;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Point {
 public:
  static constexpr std::string_view name = "point";
  static constexpr std::array<std::string_view, 0> parameter_names{};
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 0;

  [[nodiscard]] static Result<Point> make(std::span<const Real> parameters, std::span<const Real> reals,
                                          std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 0)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    return Point();
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {}; }
  [[nodiscard]] static std::vector<Point> samples() { return {Point()}; }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const { return {pose.position, pose.position}; }
  [[nodiscard]] inline Vec3 half() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return 0; }
  [[nodiscard]] inline SupportPoint support(const Vec3&) const { return {{0, 0, 0}, 0}; }
  [[nodiscard]] inline Real reach(const Vec3&) const { return 0; }
  [[nodiscard]] inline PlacedPoint placed(const Pose& pose) const { return {pose.position}; }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, 0}, 0, 0});
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const { return {FeatureKind::vertex, 0}; }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 0> edge_directions() const { return {}; }

  // No ray meets a point, but for rounding.
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3&, const UnitVec3&, Real) const { return std::nullopt; }
};
static_assert(Shape<Point> && Placeable<Point> && PointCored<Point> && FewFaced<Point>);

}  // namespace abut
