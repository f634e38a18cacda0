// SPDX-License-Identifier: Apache-2.0
// A solid that is given by its signed distance on a regular grid, negative inside. Sample (i, j, k) lies at
// origin + (i * spacing_x, j * spacing_y, k * spacing_z). Values between samples are tri-linear, or tri-quadratic: then
// value and gradient are continuous. The solid is where the value is not positive. Inside out it is a container: all
// that is not in there.
//
// A solid that reaches the border of the grid ends there: no sample is deeper than it is far from the border.
export module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.distance_field.lattice;
import abut.shapes.distance_field.ways;
import abut.trees.samples.sparse_blocks;

export namespace abut {

class DistanceField {
 public:
  static constexpr std::string_view name = "distance_field";
  static constexpr std::array<std::string_view, 14> parameter_names{
      "columns",  "rows",     "layers",        "spacing_x",     "spacing_y",       "spacing_z",    "origin_x",
      "origin_y", "origin_z", "is_inside_out", "interpolation", "lattice_columns", "lattice_rows", "lattice_layers"};

  // Without indices: one value for each sample, along X first, then Y. With indices: the numbers of the blocks of
  // 8 x 8 x 8 cells that hold samples, in rising order. The values then are those at the corners of all blocks, and
  // 9 x 9 x 9 for each block that holds samples; where values are tri-quadratic, 11 x 11 x 11. The points of a
  // lattice follow, three numbers each. The last four parameters, or the last three, may be missing.
  [[nodiscard]] static Result<DistanceField> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                  std::span<const std::uint32_t> indices);
  // From samples that are there already. No solid is in there that reaches the border.
  [[nodiscard]] static Result<DistanceField> make(std::span<const Real> parameters, SparseBlocks blocks);
  [[nodiscard]] std::vector<Real> parameters() const;
  [[nodiscard]] Buffers buffers() const;
  [[nodiscard]] static std::vector<DistanceField> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const {
    return is_inside_out() ? Aabb::everything() : transformed(data_->solid, pose);
  }
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;
  [[nodiscard]] Triangles triangles() const;

  // Outside of the grid: how far a point is away at least from a solid that lies in the grid. Where a lattice bends the
  // field, it is the value at the point that came here.
  [[nodiscard]] inline FieldValue value_at(const Vec3& point) const {
    return data_->lattice ? bent_value_at(point) : value_at_rest(point);
  }
  [[nodiscard]] inline Real least_within(Real value, Real radius) const {
    return value - data_->steepest * radius - data_->slack;
  }
  [[nodiscard]] Real least_way(Real value) const {
    return data_->least_stretch * data_->ways.least(data_->is_inside_out ? -value : value, data_->slack);
  }
  [[nodiscard]] inline Real finest() const {
    const Vec3& cell = data_->spacing;
    return data_->least_stretch * std::min(cell.x, std::min(cell.y, cell.z));
  }
  [[nodiscard]] inline Real surface_error() const { return data_->most_stretch * norm(data_->spacing); }
  [[nodiscard]] const SurfacePoints& surface() const [[clang::lifetimebound]] {
    return data_->surface.get([this] { return make_surface(); });
  }
  [[nodiscard]] inline const Aabb& solid_box() const [[clang::lifetimebound]] { return data_->solid; }
  [[nodiscard]] inline bool is_inside_out() const { return data_->is_inside_out; }

  // Other values. O(values that change + blocks of the field).
  [[nodiscard]] Fault check(const FieldEdit& edit) const;
  void own() { static_cast<void>(data_.own()); }
  [[nodiscard]] Aabb apply(const FieldEdit& edit);
  // A lattice over the grid, or none. O(points + blocks of the field).
  [[nodiscard]] Fault check(const LatticeEdit& edit) const;
  [[nodiscard]] Aabb apply(const LatticeEdit& edit);
  // Of samples that are distances: how far values may be off, in blocks that hold samples and in others.
  [[nodiscard]] Real near_error() const;
  [[nodiscard]] Real far_error() const;
  [[nodiscard]] bool is_smooth() const { return data_->is_smooth; }
  // By which a lattice makes ways longer, at least and at most.
  [[nodiscard]] Real least_stretch() const { return data_->least_stretch; }
  [[nodiscard]] Real most_stretch() const { return data_->most_stretch; }

  // How many of its blocks hold samples.
  [[nodiscard]] std::size_t held_blocks() const { return data_->blocks.held_count(); }
  [[nodiscard]] std::size_t all_blocks() const { return data_->blocks.blocks().size(); }

 private:
  struct Data {
    SparseBlocks blocks;
    Vec3 spacing, inverse, origin;
    Vec3 last;  // sample, in cells
    bool is_inside_out, is_smooth;
    Real steepest = 1;  // no gradient is longer
    Real slack = 0;     // what blocks without samples may be off
    DistanceFieldWays ways{};
    Aabb solid = Aabb::empty();
    std::optional<FieldLattice> lattice{};
    Real least_stretch = 1, most_stretch = 1;
    Real rim = infinity;  // with a lattice: the least value where blocks without samples begin
    Lazy<SurfacePoints> surface{};
  };
  // A cell that the surface goes through.
  struct SurfaceCell {
    GridPlace place;
    CellCorners corners;
  };

  explicit DistanceField(Data data) : data_(std::move(data)) {}
  [[nodiscard]] static Data data_of(std::span<const Real> parameters, SparseBlocks blocks);
  [[nodiscard]] static Result<DistanceField> measured(Data data);
  // What follows from the samples of a box.
  static void measure(Data& data, const GridBox& changed);
  static void measure_solid(Data& data);
  // Nothing where the lattice changes nothing.
  [[nodiscard]] static Result<std::optional<FieldLattice>> lattice_over(const Data& data, const GridPlace& counts,
                                                                        std::span<const Real> xyz);
  static void bend(Data& data, std::optional<FieldLattice> lattice);
  [[nodiscard]] static Aabb solid_in_cells(const Data& data, std::uint32_t number);
  [[nodiscard]] static Aabb smooth_solid_in_cells(const Data& data, std::uint32_t number);
  [[nodiscard]] static Real limited(const Data& data, const GridPlace& sample, Real value);
  // At a position in the grid, in cells; not turned inside out.
  [[nodiscard]] [[gnu::always_inline]] inline Interpolated interpolated(const Vec3& at) const {
    return data_->is_smooth ? data_->blocks.smooth_at(at) : data_->blocks.at(at);
  }
  [[nodiscard]] inline FieldValue value_at_rest(const Vec3& point) const {
    const Data& field = *data_;
    const Vec3 p = point - field.origin;
    const Vec3 at{p.x * field.inverse.x, p.y * field.inverse.y, p.z * field.inverse.z};
    const auto clamped = [](Real value, Real most) { return value > 0 ? (value < most ? value : most) : 0; };
    const Vec3 in_grid{clamped(at.x, field.last.x), clamped(at.y, field.last.y), clamped(at.z, field.last.z)};
    const Interpolated found = interpolated(in_grid);
    FieldValue out{found.value,
                   {found.slope.x * field.inverse.x, found.slope.y * field.inverse.y, found.slope.z * field.inverse.z}};
    if (!(at == in_grid)) [[unlikely]] {
      out = beyond(p, in_grid, out);
    }
    return field.is_inside_out ? FieldValue{-out.value, -out.gradient} : out;
  }
  [[nodiscard]] FieldValue bent_value_at(const Vec3& point) const;
  [[nodiscard]] FieldValue beyond(const Vec3& p, const Vec3& in_grid, const FieldValue& on_border) const;
  [[nodiscard]] SurfacePoints make_surface() const;
  void bend_points(SurfacePoints& points) const;
  [[nodiscard]] std::optional<RayHit> cast_bent_ray(const Vec3& origin, const UnitVec3& direction,
                                                    Real max_distance) const;
  [[nodiscard]] Vec3 point_in(const SurfaceCell& cell) const;
  [[nodiscard]] Vec3 placed(const Vec3& at) const;
  // Where values are tri-quadratic.
  [[nodiscard]] std::vector<float> corner_values(const GridBox& cells) const;
  [[nodiscard]] float corner_value(const GridPlace& sample) const;
  [[nodiscard]] std::optional<Real> smooth_zero(const SparseBlocks::Block& block, const GridPlace& in_block,
                                                const GridPlace& cell, const Vec3& from, const Vec3& to,
                                                Real& sign_before) const;
  [[nodiscard]] Vec3 smooth_point_in(const SurfaceCell& cell) const;
  [[nodiscard]] Vec3 zero_between(const Vec3& inside, const Vec3& outside) const;
  [[nodiscard]] bool add_uncrossed(const SparseBlocks::Block& block, const GridPlace& in_block, const GridPlace& place,
                                   SurfacePoints& out) const;
  [[nodiscard]] std::uint32_t cell_number(const GridPlace& place) const;

  Frozen<Data> data_;
};
static_assert(Shape<DistanceField> && SampledSolid<DistanceField> && Triangulated<DistanceField> &&
              Editable<DistanceField, FieldEdit> && Editable<DistanceField, LatticeEdit>);

}  // namespace abut
