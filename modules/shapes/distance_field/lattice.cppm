// SPDX-License-Identifier: Apache-2.0
// A lattice of points that bends the space of a field (Sederberg and Parry, "Free-form deformation of solid geometric
// models", 1986). At rest the points lie evenly in a box. Space between eight of them goes where they go, tri-linearly.
// Beyond the box it goes on straight, as all of the lattice does on average.
//
// Ways between two points become longer or shorter by bounded factors. With A for the average, the slope of space times
// the inverse of A is a mean of matrices made of edges. Where the symmetric part of all these is positive, bent space
// folds nowhere, and every place is that of one point at rest (Minty, 1962).
export module abut.shapes.distance_field.lattice;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.samples.sparse_blocks;

export namespace abut {

// By its columns.
struct LinearMap {
  Vec3 x, y, z;

  [[nodiscard]] inline Vec3 operator*(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
  // The transposed map.
  [[nodiscard]] inline Vec3 transposed(const Vec3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  [[nodiscard]] inline Real determinant() const { return dot(x, cross(y, z)); }
  [[nodiscard]] LinearMap inverse() const;
};

class FieldLattice {
 public:
  static constexpr std::uint32_t most_along = 64;

  // `counts`: of points along each axis, from 2 to most_along. `box`: of the lattice at rest. Points run along X first,
  // then Y.
  FieldLattice(const GridPlace& counts, const Aabb& box, std::vector<Vec3> points);

  [[nodiscard]] inline const GridPlace& counts() const [[clang::lifetimebound]] { return counts_; }
  [[nodiscard]] inline std::span<const Vec3> points() const [[clang::lifetimebound]] { return points_; }
  [[nodiscard]] bool is_at_rest() const;
  // Nothing may be asked of the others.
  [[nodiscard]] inline bool is_sound() const { return least_stretch_ > 0; }
  // A way at rest becomes longer by these factors at least and at most.
  [[nodiscard]] inline Real least_stretch() const { return least_stretch_; }
  [[nodiscard]] inline Real most_stretch() const { return most_stretch_; }

  struct Bent {
    Vec3 place;
    LinearMap slope;  // of the place by the point at rest
  };
  [[nodiscard]] Bent bent(const Vec3& at_rest) const;
  // Around all that a box at rest holds.
  [[nodiscard]] Aabb bent_box(const Aabb& at_rest) const;

  struct Unbent {
    Vec3 at_rest;
    LinearMap slope;
  };
  [[nodiscard]] Unbent unbent(const Vec3& place) const;

 private:
  [[nodiscard]] std::size_t number_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return (std::size_t{k} * counts_.y + j) * counts_.x + i;
  }
  [[nodiscard]] Vec3 at_rest(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  // Calls visit(axis, slope) for the edges of the lattice, or of the cell that begins at a point.
  template <class Visitor>
  void visit_edges(Visitor&& visit) const;
  void find_average();
  void find_stretches();

  GridPlace counts_;
  Aabb box_;
  Vec3 cell_;
  std::vector<Vec3> points_;
  Vec3 middle_{};         // of the points
  LinearMap average_{};   // slope of space
  LinearMap straight_{};  // back
  Real least_stretch_ = 0, most_stretch_ = 0, relaxed_ = 0;
};

}  // namespace abut
