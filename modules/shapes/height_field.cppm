// SPDX-License-Identifier: Apache-2.0
// Terrain over a regular grid: sample (i, j) is the point (i * spacing_x, j * spacing_y, height).
// Each cell holds two triangles, split from (i, j) to (i + 1, j + 1). One-sided: the front is +Z.
// Cells under a box are found by division.
export module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.range_pyramid;

export namespace abut {

class HeightField {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "height_field";
  static constexpr std::array<std::string_view, 4> parameter_names{"columns", "rows", "spacing_x", "spacing_y"};
  static constexpr bool is_terrain = true;

  [[nodiscard]] static Result<HeightField> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const {
    const Data& field = *data_;
    return {static_cast<Real>(field.columns), static_cast<Real>(field.rows), field.spacing_x, field.spacing_y};
  }
  [[nodiscard]] Buffers buffers() const { return {data_->heights, {}}; }
  [[nodiscard]] static std::vector<HeightField> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return transformed(data_->box, pose); }

  // Triangle 2 c is the one below the diagonal of cell c, 2 c + 1 the one above; cells run along X first.
  [[nodiscard]] inline Triangle part(std::uint32_t index) const {
    const Data& field = *data_;
    const std::uint32_t cell = index / 2, i = cell % (field.columns - 1), j = cell / (field.columns - 1);
    return {corners(i, j, index % 2 != 0), index, true};
  }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    const Data& field = *data_;
    if (!box.overlaps(field.box)) {
      return;
    }
    const std::uint32_t i0 = cell_before(box.low.x / field.spacing_x, field.columns),
                        i1 = cell_at(box.high.x / field.spacing_x, field.columns);
    const std::uint32_t j0 = cell_before(box.low.y / field.spacing_y, field.rows),
                        j1 = cell_at(box.high.y / field.spacing_y, field.rows);
    for (std::uint32_t j = j0; j <= j1; ++j) {
      for (std::uint32_t i = i0; i <= i1; ++i) {
        const Vec3 a = point(i, j), b = point(i + 1, j), c = point(i, j + 1), d = point(i + 1, j + 1);
        if (std::max(std::max(a.z, b.z), std::max(c.z, d.z)) < box.low.z ||
            std::min(std::min(a.z, b.z), std::min(c.z, d.z)) > box.high.z) {
          continue;
        }
        const std::uint32_t cell = j * (field.columns - 1) + i;
        for (const bool is_upper : {false, true}) {
          const TriangleCorners of_part{a, is_upper ? d : b, is_upper ? c : d};
          if (box_around(of_part).overlaps(box) && is_wanted(of_part)) {
            const std::uint32_t index = 2 * cell + (is_upper ? 1 : 0);
            visit(Triangle(of_part, index, true), index);
          }
        }
      }
    }
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
  }
  [[nodiscard]] Triangle part_near(const Vec3& p) const {
    const Data& field = *data_;
    const std::uint32_t i = cell_at(p.x / field.spacing_x, field.columns),
                        j = cell_at(p.y / field.spacing_y, field.rows);
    return part(2 * (j * (field.columns - 1) + i));
  }

  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;
  [[nodiscard]] Triangles triangles() const;

  // Other heights. O(heights that change + log(all heights)).
  [[nodiscard]] Fault check(const HeightEdit& edit) const;
  void own() { static_cast<void>(data_.own()); }
  [[nodiscard]] Aabb apply(const HeightEdit& edit);

 private:
  struct Data {
    std::uint32_t columns, rows;
    Real spacing_x, spacing_y;
    std::vector<Real> heights;
    RangePyramid ranges;  // of the heights
    Aabb box;
  };

  explicit HeightField(Data data) : data_(std::move(data)) {}
  [[nodiscard]] inline Real height(std::uint32_t i, std::uint32_t j) const {
    return data_->heights[std::size_t{j} * data_->columns + i];
  }
  [[nodiscard]] inline Vec3 point(std::uint32_t i, std::uint32_t j) const {
    return {i * data_->spacing_x, j * data_->spacing_y, height(i, j)};
  }
  // Of a triangle of a cell.
  [[nodiscard]] inline TriangleCorners corners(std::uint32_t i, std::uint32_t j, bool is_upper) const {
    return {point(i, j), is_upper ? point(i + 1, j + 1) : point(i + 1, j),
            is_upper ? point(i, j + 1) : point(i + 1, j + 1)};
  }
  [[nodiscard]] static inline std::uint32_t cell_at(Real position, std::uint32_t samples) {
    const Real last = samples - 2;
    return position > 0 ? static_cast<std::uint32_t>(std::min(position, last)) : 0;
  }
  // The first cell that touches a position: on a line of the grid the one before it.
  [[nodiscard]] static inline std::uint32_t cell_before(Real position, std::uint32_t samples) {
    const std::uint32_t cell = cell_at(position, samples);
    return cell > 0 && static_cast<Real>(cell) >= position ? cell - 1 : cell;
  }
  Frozen<Data> data_;
};
static_assert(Shape<HeightField> && Surface<HeightField> && Triangulated<HeightField> && Terrain<HeightField> &&
              Editable<HeightField, HeightEdit>);

}  // namespace abut
