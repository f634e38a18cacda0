// Cores that several shapes are made of: a point and a segment along Z, both around the origin.
export module abut.shape.cores;
import abut.core.standard;
import abut.math;
import abut.shape.place;
import abut.shape.records;

export namespace abut {

class PointCore {
 public:
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 0;

  [[nodiscard]] inline Vec3 half() const { return {0, 0, 0}; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return 0; }
  [[nodiscard]] inline SupportPoint support(const Vec3&) const { return {{0, 0, 0}, 0}; }
  [[nodiscard]] inline Real reach(const Vec3&) const { return 0; }
  [[nodiscard]] inline std::uint32_t corner_count() const { return 1; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t) const { return {0, 0, 0}; }
  [[nodiscard]] inline PlacedPoint placed(const Pose& pose) const { return {pose.position}; }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, 0}, 0, 0});
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const { return {FeatureKind::vertex, 0}; }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 0> edge_directions() const { return {}; }
};

class SegmentCore {
 public:
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 1;

  [[nodiscard]] inline Vec3 half() const { return {0, 0, half_length_}; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return half_length_; }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const bool upper = direction.z >= 0;
    return {{0, 0, upper ? half_length_ : -half_length_}, upper ? 1u : 0u};
  }
  [[nodiscard]] inline Real reach(const Vec3& direction) const { return half_length_ * std::fabs(direction.z); }
  [[nodiscard]] inline std::uint32_t corner_count() const { return half_length_ > 0 ? 2 : 1; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t index) const { return {0, 0, index == 0 ? -half_length_ : half_length_}; }
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

 protected:
  inline explicit SegmentCore(Real half_length) : half_length_(half_length) {}
  [[nodiscard]] inline Real half_length() const { return half_length_; }

 private:
  Real half_length_;
};

}  // namespace abut
