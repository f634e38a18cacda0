// SPDX-License-Identifier: Apache-2.0
// Terrain over a regular grid: sample (i, j) is the point (i * spacing_x, j * spacing_y, height).
// Each cell holds two triangles. One-sided: the front is +Z. A height that is NaN makes a hole: the triangles around it
// are missing. Cells under a box are found by division. By option what is below is inside, down to a floor: then walls
// and the floor close the surface (height_field_base.cpp).
//
// Holes are NaN instead of a list: comparisons with NaN are false, so rays, boxes and least heights skip holes without
// a test.
export module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.trees.volumes.box_heights;
import abut.trees.volumes.eight_boxes;
import abut.trees.grids.range_pyramid;
import abut.trees.volumes.ray_slabs;

export namespace abut {

class HeightField {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "height_field";
  static constexpr std::array<std::string_view, 6> parameter_names{"columns",   "rows",     "spacing_x",
                                                                   "spacing_y", "diagonal", "solid_below"};
  static constexpr bool is_terrain = true;

  [[nodiscard]] static Result<HeightField> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const {
    const Data& field = *data_;
    return {static_cast<Real>(field.columns),  static_cast<Real>(field.rows), field.spacing_x, field.spacing_y,
            static_cast<Real>(field.diagonal), field.is_solid ? 1.0 : 0.0};
  }
  [[nodiscard]] Buffers buffers() const { return {data_->heights, {}}; }
  [[nodiscard]] static std::vector<HeightField> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return transformed(data_->box, pose); }

  // Triangle 2 c is the one below the diagonal of cell c, 2 c + 1 the one above; cells run along X first. Those of
  // walls and floors come after all of the grid, or take the numbers of triangles that are missing.
  [[nodiscard]] inline TriangleCorners corners(std::uint32_t index) const {
    return data_->is_solid ? corners_in_solid(index) : corners_in_grid(index);
  }
  [[nodiscard]] inline Triangle part(std::uint32_t index) const { return {corners(index), index, true}; }
  [[nodiscard]] static inline bool has_fronts() { return true; }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    const Data& field = *data_;
    if (!box.overlaps(field.box)) {
      return;
    }
    const auto visit_row = [&](std::uint32_t i, std::uint32_t count, std::uint32_t j) {
      for (; count > 0; i += 4, count -= std::min(count, 4u)) {
        const FourCells cells = cells_from(i, std::min(count, 4u), j);
        const Heights heights = cells.heights();
        if (heights.high < box.low.z || heights.low > box.high.z) {
          continue;
        }
        for (const bool is_upper : {false, true}) {
          const FourTriangles triangles = cells.triangles(is_upper);
          std::uint64_t wanted =
              wanted_of(triangles, cells.are_there(is_upper) & triangles.overlapping(box), is_wanted);
          for (; wanted != 0; wanted &= wanted - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(wanted));
            visit(Triangle(triangles[lane], triangles.numbers[lane], true), triangles.numbers[lane]);
          }
        }
      }
    };
    field.ranges.visit_over(cells_under(box), box, visit_row);
    if (field.is_solid && reaches_base(box)) {
      const auto take = [&](const FourTriangles& triangles, std::uint64_t some) {
        std::uint64_t wanted = wanted_of(triangles, some & triangles.overlapping(box), is_wanted);
        for (; wanted != 0; wanted &= wanted - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(wanted));
          visit(Triangle(triangles[lane], triangles.numbers[lane], true), triangles.numbers[lane]);
        }
      };
      // What holds one reference is passed on without memory of its own.
      visit_base(box, [&take](const FourTriangles& triangles, std::uint64_t some) { take(triangles, some); });
    }
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
  }
  // Of the grid, with those that are missing.
  [[nodiscard]] std::size_t triangle_count() const {
    return 2 * (std::size_t{data_->columns} - 1) * (std::size_t{data_->rows} - 1);
  }
  // Above the numbers of all triangles, walls and floors included.
  [[nodiscard]] std::size_t part_end() const {
    const std::size_t border = 2 * (std::size_t{data_->columns} - 1 + std::size_t{data_->rows} - 1);
    return data_->is_solid ? 2 * triangle_count() + 2 * border : triangle_count();
  }
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const Data& field = *data_;
    const auto lowest_of = [&](const Aabb& box) { return least_along(box, direction); };
    field.ranges.visit_in_order({field.spacing_x, field.spacing_y}, limit, lowest_of,
                                [&](std::uint32_t i, std::uint32_t j) {
                                  const Cell cell = cell_of(i, j);
                                  for (const bool is_upper : {false, true}) {
                                    const TriangleCorners of_part = cell.triangle(is_upper);
                                    if (is_there(of_part) && least_along(of_part, direction) <= limit) {
                                      const std::uint32_t index = number_of(i, j, is_upper);
                                      visit(Triangle(of_part, index, true), index);
                                    }
                                  }
                                });
    if (field.is_solid) {
      visit_base_below(direction, limit, [&visit](const Triangle& part) { visit(part, part.index()); });
    }
  }
  // Of the grid.
  [[nodiscard]] Triangle part_near(const Vec3& p) const;

  // See Hierarchy: blocks of cells and the triangles in them. Walls and floors have a tree of their own below the root.
  // So what is deep in the ground is compared with the boxes of the ground alone.
  [[nodiscard]] Vec3 origin() const { return data_->box.centre(); }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    [[clang::uninitialized]] Children children;
    find_children(node, children);
    const Vec3 middle = origin();
    for (std::size_t first = 0; first < children.size(); first += EightBoxes::width) {
      EightBoxes eight = EightBoxes::empty();
      for (std::size_t lane = 0; lane < std::min(EightBoxes::width, children.size() - first); ++lane) {
        eight.set_sides(lane, sides_of(compact(children[first + lane].box, middle)));
        eight.numbers[lane] = children[first + lane].number;
      }
      visit(eight);
    }
  }

  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;
  // A triangle that is missing has three equal corners, so that the others keep their numbers. Of a solid with its
  // base.
  [[nodiscard]] Triangles triangles() const;

  // See Enclosing. The floor is as far below the lowest sample as the longer side of the field.
  [[nodiscard]] inline bool is_solid() const { return data_->is_solid; }
  [[nodiscard]] bool contains(const Vec3& point) const;
  [[nodiscard]] inline bool is_turned(std::uint32_t) const { return false; }
  [[nodiscard]] std::span<const Vec3> pieces() const [[clang::lifetimebound]] {
    return data_->pieces.get([this] { return find_pieces(); });
  }

  // Other heights. O(heights that change + log(all heights)).
  [[nodiscard]] Fault check(const HeightEdit& edit) const;
  void own() { static_cast<void>(data_.own()); }
  [[nodiscard]] Aabb apply(const HeightEdit& edit);

 private:
  // From (i, j) to (i + 1, j + 1), from (i + 1, j) to (i, j + 1), or the one or the other as i + j is even or odd.
  enum class Diagonal : std::uint8_t { rising, falling, alternating };

  struct Data {
    std::uint32_t columns, rows;
    Real spacing_x, spacing_y;
    Diagonal diagonal;
    bool is_solid;
    std::vector<Real> heights;  // NaN in holes
    RangePyramid ranges;        // of the heights
    Aabb box;
    std::uint64_t triangle_count;
    Lazy<std::vector<Vec3>> pieces{};

    // The low end of the box, where the lowest sample is at `lowest`.
    [[nodiscard]] Real floor_below(Real lowest) const {
      return is_solid ? lowest - std::max(box.high.x, box.high.y) : lowest;
    }
  };

  // A sample, by column and row.
  struct Sample {
    std::uint32_t i, j;
    friend bool operator==(const Sample&, const Sample&) = default;
  };
  struct Heights {
    Real low, high;
  };
  // The points at (i, j), (i + 1, j), (i, j + 1) and (i + 1, j + 1).
  struct Cell {
    Vec3 a, b, c, d;
    bool is_falling;  // its diagonal leads from b to c

    [[nodiscard]] inline TriangleCorners triangle(bool is_upper) const {
      return is_upper ? TriangleCorners{is_falling ? b : a, d, c} : TriangleCorners{a, b, is_falling ? c : d};
    }
    // Of the samples that are no NaN: std::min and std::max keep the first of two that do not compare.
    [[nodiscard]] inline Heights heights() const {
      return {std::min(std::min(std::min(std::min(infinity, a.z), b.z), c.z), d.z),
              std::max(std::max(std::max(std::max(-infinity, a.z), b.z), c.z), d.z)};
    }
  };

  // Up to four cells of a row, a cell per lane. The last one stands in for those that lack.
  struct FourCells {
    Lanes x, next_x;
    Real y, next_y;
    Lanes a, b, c, d;  // the heights of the points of Cell
    LaneNumbers are_falling;
    std::array<std::uint32_t, 4> numbers;  // of the lower triangles
    std::uint64_t present;                 // a bit for each cell

    [[nodiscard]] inline FourTriangles triangles(bool is_upper) const {
      const Columns of_a{x, all_lanes(y), a}, of_b{next_x, all_lanes(y), b}, of_c{x, all_lanes(next_y), c},
          of_d{next_x, all_lanes(next_y), d};
      const auto chosen = [&](const Columns& p, const Columns& q) {
        return Columns{are_falling ? p.x : q.x, are_falling ? p.y : q.y, are_falling ? p.z : q.z};
      };
      if (!is_upper) {
        return {of_a, of_b, chosen(of_c, of_d), numbers};
      }
      FourTriangles upper{chosen(of_b, of_a), of_d, of_c, numbers};
      for (std::uint32_t& number : upper.numbers) {
        ++number;
      }
      return upper;
    }
    // Those that have all corners.
    [[nodiscard]] inline std::uint64_t are_there(bool is_upper) const {
      const Lanes sum = is_upper ? (are_falling ? b : a) + d + c : a + b + (are_falling ? c : d);
      return present & bits_of(sum == sum);
    }
    // Of the samples that are no NaN, which does not compare.
    [[nodiscard]] inline Heights heights() const {
      const auto least = [](Lanes p, Lanes q, Lanes r, Lanes s) {
        return minimum(s, minimum(r, minimum(q, minimum(p, all_lanes(infinity)))));
      };
      return {-largest(-least(a, b, c, d)), largest(-least(-a, -b, -c, -d))};
    }
  };

  // Of walls and floors: a sample, or the point of the floor below it.
  struct BaseCorner {
    Sample at;
    bool is_on_floor;
  };
  using BaseTriangle = std::array<BaseCorner, 3>;
  // An edge with a triangle on its left, seen from above, and none on its right.
  struct Rim {
    Sample from, to;
  };
  using TakeFour = std::function<void(const FourTriangles&, std::uint64_t)>;
  // As many as a node has at most: 16 cells with two walls in place of each triangle, and with edges of the border.
  struct Child {
    std::uint32_t number;
    Aabb box;
  };
  using Children = SmallVector<Child, 96>;
  using TakePart = std::function<void(const Triangle&)>;
  using MeetTriangle = std::function<void(const TriangleCorners&, std::uint32_t)>;

  explicit HeightField(Data data) : data_(std::move(data)) {}
  [[nodiscard]] inline Real height(std::uint32_t i, std::uint32_t j) const {
    return data_->heights[std::size_t{j} * data_->columns + i];
  }
  [[nodiscard]] inline Vec3 point(std::uint32_t i, std::uint32_t j) const {
    return {i * data_->spacing_x, j * data_->spacing_y, height(i, j)};
  }
  [[nodiscard]] static inline bool is_falling(Diagonal diagonal, std::uint32_t i, std::uint32_t j) {
    return diagonal == Diagonal::falling || (diagonal == Diagonal::alternating && (i + j) % 2 != 0);
  }
  [[nodiscard]] inline Cell cell_of(std::uint32_t i, std::uint32_t j) const {
    return {point(i, j), point(i + 1, j), point(i, j + 1), point(i + 1, j + 1), is_falling(data_->diagonal, i, j)};
  }
  // `count`: of cells, 1 to 4.
  [[nodiscard]] inline FourCells cells_from(std::uint32_t i, std::uint32_t count, std::uint32_t j) const {
    const Data& field = *data_;
    const std::span<const Real> row = std::span(field.heights).subspan(std::size_t{j} * field.columns + i),
                                next_row = row.subspan(field.columns);
    [[clang::uninitialized]] FourCells cells;
    cells.y = j * field.spacing_y;
    cells.next_y = (j + 1) * field.spacing_y;
    cells.present = (std::uint64_t{1} << count) - 1;
    if (field.columns - i > 4) [[likely]] {
      // As many heights as that lie side by side: cells that were not asked for are not present.
      const auto four_from = [](std::span<const Real> heights) {
        const auto four = heights.first<4>();
        return Lanes{four[0], four[1], four[2], four[3]};
      };
      const Lanes place = static_cast<Real>(i) + Lanes{0, 1, 2, 3};
      cells.x = place * field.spacing_x;
      cells.next_x = (place + 1) * field.spacing_x;
      cells.a = four_from(row);
      cells.b = four_from(row.subspan(1));
      cells.c = four_from(next_row);
      cells.d = four_from(next_row.subspan(1));
      const LaneNumbers odd = (i + j) % 2 == 0 ? LaneNumbers{0, -1, 0, -1} : LaneNumbers{-1, 0, -1, 0};
      cells.are_falling = field.diagonal == Diagonal::alternating ? odd
                          : field.diagonal == Diagonal::falling   ? LaneNumbers(-1)
                                                                  : LaneNumbers(0);
      const std::uint32_t number = number_of(i, j, false);
      cells.numbers = {number, number + 2, number + 4, number + 6};
      return cells;
    }
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      const std::uint32_t at = std::min(lane, count - 1);
      cells.x[lane] = (i + at) * field.spacing_x;
      cells.next_x[lane] = (i + at + 1) * field.spacing_x;
      cells.a[lane] = row[at];
      cells.b[lane] = row[at + 1];
      cells.c[lane] = next_row[at];
      cells.d[lane] = next_row[at + 1];
      cells.are_falling[lane] = is_falling(field.diagonal, i + at, j) ? -1 : 0;
      cells.numbers[lane] = number_of(i + at, j, false);
    }
    return cells;
  }
  [[nodiscard]] inline std::uint32_t number_of(std::uint32_t i, std::uint32_t j, bool is_upper) const {
    return 2 * (j * (data_->columns - 1) + i) + (is_upper ? 1 : 0);
  }
  [[nodiscard]] inline TriangleCorners corners_in_grid(std::uint32_t index) const {
    const std::uint32_t cell = index / 2, i = cell % (data_->columns - 1), j = cell / (data_->columns - 1);
    return cell_of(i, j).triangle(index % 2 != 0);
  }
  // A triangle with a sample that is NaN is missing.
  [[nodiscard]] static inline bool is_there(const TriangleCorners& corners) {
    return !std::isnan(corners[0].z + corners[1].z + corners[2].z);
  }
  // The corners of a triangle of a cell, as Cell lists them.
  [[nodiscard]] inline std::array<Sample, 3> samples_of(std::uint32_t i, std::uint32_t j, bool is_upper) const {
    const bool falls = is_falling(data_->diagonal, i, j);
    const Sample a{i, j}, b{i + 1, j}, c{i, j + 1}, d{i + 1, j + 1};
    return is_upper ? std::array{falls ? b : a, d, c} : std::array{a, b, falls ? c : d};
  }
  [[nodiscard]] std::array<std::optional<Sample>, 2> samples_across(const Sample& first, const Sample& second) const;
  // How many triangles there are in a rectangle of cells. `height_at(i, j)`: of samples.
  template <class HeightAt>
  [[nodiscard]] static std::uint64_t count_triangles(const RangePyramid::Rectangle& cells, Diagonal diagonal,
                                                     const HeightAt& height_at);
  [[nodiscard]] std::int64_t change_of_count(const HeightEdit& edit) const;
  [[nodiscard]] std::vector<Vec3> find_pieces() const;
  [[nodiscard]] static inline std::uint32_t cell_at(Real position, std::uint32_t samples) {
    const Real last = samples - 2;
    return position > 0 ? static_cast<std::uint32_t>(std::min(position, last)) : 0;
  }
  // The first cell that touches a position: on a line of the grid the one before it.
  [[nodiscard]] static inline std::uint32_t cell_before(Real position, std::uint32_t samples) {
    const std::uint32_t cell = cell_at(position, samples);
    return cell > 0 && static_cast<Real>(cell) >= position ? cell - 1 : cell;
  }
  // Of a box that overlaps that of the field.
  [[nodiscard]] inline RangePyramid::Rectangle cells_under(const Aabb& box) const {
    const Data& field = *data_;
    const std::uint32_t i0 = cell_before(box.low.x / field.spacing_x, field.columns),
                        i1 = cell_at(box.high.x / field.spacing_x, field.columns);
    const std::uint32_t j0 = cell_before(box.low.y / field.spacing_y, field.rows),
                        j1 = cell_at(box.high.y / field.spacing_y, field.rows);
    return {i0, j0, i1 - i0 + 1, j1 - j0 + 1};
  }

  [[nodiscard]] inline bool lacks_triangles() const { return data_->triangle_count < triangle_count(); }
  // Of a box that overlaps that of the field.
  [[nodiscard]] inline bool reaches_base(const Aabb& box) const {
    const Vec3 &low = data_->box.low, &high = data_->box.high;
    return box.low.z <= low.z || box.low.x <= low.x || box.low.y <= low.y || box.high.x >= high.x ||
           box.high.y >= high.y || lacks_triangles();
  }
  void find_children(std::uint32_t node, Children& out) const;
  // Of a solid.
  [[nodiscard]] TriangleCorners corners_in_solid(std::uint32_t index) const;
  [[nodiscard]] bool is_at_base(std::uint32_t index) const;
  [[nodiscard]] bool is_crest_of_solid(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;
  void visit_base(const Aabb& box, const TakeFour& take) const;
  void visit_base_below(const Vec3& direction, Real& limit, const TakePart& take) const;
  void find_base_children(std::uint32_t node, Children& out) const;
  [[nodiscard]] RangePyramid::Range base_range(const RangePyramid::Block& block) const;
  void meet_base(const RaySlabs& slabs, const RaySlabs::Stretch& over_box, const Real& nearest,
                 const MeetTriangle& meet) const;
  void close(Triangles& out) const;
  // Walls and floors of a cell: visit(triangle, number).
  template <class Visitor>
  void visit_base_at(std::uint32_t i, std::uint32_t j, Visitor&& visit) const;
  template <class Visitor>
  void visit_edges_from(const Sample& from, Visitor&& visit) const;
  [[nodiscard]] std::optional<BaseTriangle> base_triangle(std::uint32_t number) const;
  [[nodiscard]] std::optional<Rim> rim_at_gap(std::uint32_t i, std::uint32_t j, bool is_upper) const;
  [[nodiscard]] std::optional<Rim> rim_at_border(std::uint32_t edge) const;
  [[nodiscard]] static BaseTriangle wall_of(const Rim& rim, bool is_second);
  [[nodiscard]] unsigned triangles_at(const Sample& one, const Sample& other) const;
  [[nodiscard]] Vec3 point(const BaseCorner& corner) const;
  [[nodiscard]] TriangleCorners corners_of(const BaseTriangle& triangle) const;

  Frozen<Data> data_;
};
static_assert(Shape<HeightField> && Surface<HeightField> && Hierarchy<HeightField> && Triangulated<HeightField> &&
              Terrain<HeightField> && Editable<HeightField, HeightEdit>);

}  // namespace abut
