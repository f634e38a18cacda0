// SPDX-License-Identifier: Apache-2.0
// The base of a solid height field: walls where the triangles of the grid end, at the border of the field and at holes,
// and a floor below each triangle. With it the surface is closed. All of it follows from the samples, so that edits
// have nothing to update.
//
// A triangle of the grid that is there has the number t, its floor has the number count + t. One that is missing may
// have a wall at the edge of a neighbour: a missing sample leaves it at most one edge. Two triangles of that wall take
// its numbers, t and count + t. Two for each edge of the border come last.
module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;
import abut.trees.grids.range_pyramid;
import abut.trees.volumes.ray_slabs;

namespace abut {

// The edge of the neighbour of a triangle that is missing.
std::optional<HeightField::Rim> HeightField::rim_at_gap(std::uint32_t i, std::uint32_t j, bool is_upper) const {
  const auto samples = samples_of(i, j, is_upper);
  for (std::size_t missing = 0; missing < 3; ++missing) {
    const Sample &from = samples[(missing + 1) % 3], &to = samples[(missing + 2) % 3];
    if (triangles_at(from, to) > 0) {
      return Rim{to, from};
    }
  }
  return std::nullopt;
}

std::optional<HeightField::Rim> HeightField::rim_at_border(std::uint32_t edge) const {
  const std::uint32_t wide = data_->columns - 1, high = data_->rows - 1;
  Rim rim{};
  if (edge < wide) {
    rim = {{edge, 0}, {edge + 1, 0}};
  } else if (edge < 2 * wide) {
    const std::uint32_t i = edge - wide;
    rim = {{i + 1, high}, {i, high}};
  } else if (edge < 2 * wide + high) {
    const std::uint32_t j = edge - 2 * wide;
    rim = {{0, j + 1}, {0, j}};
  } else {
    const std::uint32_t j = edge - 2 * wide - high;
    rim = {{wide, j}, {wide, j + 1}};
  }
  return triangles_at(rim.from, rim.to) > 0 ? std::optional(rim) : std::nullopt;
}

HeightField::BaseTriangle HeightField::wall_of(const Rim& rim, bool is_second) {
  const BaseCorner from{rim.from, false}, to{rim.to, false}, below_from{rim.from, true}, below_to{rim.to, true};
  return is_second ? BaseTriangle{from, below_to, to} : BaseTriangle{from, below_from, below_to};
}

template <class Visitor>
void HeightField::visit_base_at(std::uint32_t i, std::uint32_t j, Visitor&& visit) const {
  const Data& field = *data_;
  const std::uint32_t wide = field.columns - 1, high = field.rows - 1;
  const auto count = static_cast<std::uint32_t>(triangle_count());
  const auto visit_wall = [&](const std::optional<Rim>& rim, std::uint32_t first, std::uint32_t second) {
    if (rim) {
      visit(wall_of(*rim, false), first);
      visit(wall_of(*rim, true), second);
    }
  };
  const Cell cell = cell_of(i, j);
  for (const bool is_upper : {false, true}) {
    const std::uint32_t number = number_of(i, j, is_upper);
    if (is_there(cell.triangle(is_upper))) {
      const auto [a, b, c] = samples_of(i, j, is_upper);
      visit(BaseTriangle{BaseCorner{a, true}, BaseCorner{c, true}, BaseCorner{b, true}}, count + number);
    } else {
      visit_wall(rim_at_gap(i, j, is_upper), number, count + number);
    }
  }
  const auto visit_border = [&](bool is_at, std::uint32_t edge) {
    if (is_at) {
      visit_wall(rim_at_border(edge), 2 * count + 2 * edge, 2 * count + 2 * edge + 1);
    }
  };
  visit_border(j == 0, i);
  visit_border(j + 1 == high, wide + i);
  visit_border(i == 0, 2 * wide + j);
  visit_border(i + 1 == wide, 2 * wide + high + j);
}

std::optional<HeightField::BaseTriangle> HeightField::base_triangle(std::uint32_t number) const {
  const auto count = static_cast<std::uint32_t>(triangle_count());
  if (number >= 2 * count) {
    const std::uint32_t edge = number / 2 - count;
    const auto rim = rim_at_border(edge);
    return rim ? std::optional(wall_of(*rim, number % 2 != 0)) : std::nullopt;
  }
  const bool is_second = number >= count;
  const std::uint32_t of_grid = is_second ? number - count : number, cell = of_grid / 2;
  const std::uint32_t i = cell % (data_->columns - 1), j = cell / (data_->columns - 1);
  const bool is_upper = of_grid % 2 != 0;
  if (is_there(cell_of(i, j).triangle(is_upper))) {
    const auto [a, b, c] = samples_of(i, j, is_upper);
    return is_second ? BaseTriangle{BaseCorner{a, true}, BaseCorner{c, true}, BaseCorner{b, true}}
                     : BaseTriangle{BaseCorner{a, false}, BaseCorner{b, false}, BaseCorner{c, false}};
  }
  const auto rim = rim_at_gap(i, j, is_upper);
  return rim ? std::optional(wall_of(*rim, is_second)) : std::nullopt;
}

Vec3 HeightField::point(const BaseCorner& corner) const {
  const Vec3 sample = point(corner.at.i, corner.at.j);
  return corner.is_on_floor ? Vec3{sample.x, sample.y, data_->box.low.z} : sample;
}
TriangleCorners HeightField::corners_of(const BaseTriangle& triangle) const {
  return {point(triangle[0]), point(triangle[1]), point(triangle[2])};
}
TriangleCorners HeightField::corners_in_solid(std::uint32_t index) const {
  const auto triangle = base_triangle(index);
  return triangle ? corners_of(*triangle) : corners_in_grid(index);
}

// The heights of walls and floors in a block.
RangePyramid::Range HeightField::base_range(const RangePyramid::Block& block) const {
  const RangePyramid& ranges = data_->ranges;
  const RangePyramid::Range& ground = ranges.range_of(block);
  const bool has_walls = ranges.is_at_border(block) || ranges.lacks_any(block);
  const Real floor = data_->box.low.z;
  return ground.low > ground.high ? ground : RangePyramid::Range{floor, has_walls ? ground.high : floor};
}

void HeightField::visit_base(const Aabb& box, const TakeFour& take) const {
  FourTriangles four = FourTriangles::all({});
  std::size_t count = 0;
  const auto hand_over = [&] {
    if (count > 0) {
      take(four, (std::uint64_t{1} << count) - 1);
      count = 0;
    }
  };
  const auto add = [&](const BaseTriangle& triangle, std::uint32_t number) {
    const TriangleCorners corners = corners_of(triangle);
    if (!box_around(corners).overlaps(box)) {
      return;
    }
    FourTriangles one = FourTriangles::all(corners);
    one.numbers.fill(number);
    // The last one stands in for those that lack.
    for (std::size_t lane = count; lane < 4; ++lane) {
      four.put(lane, one);
    }
    if (++count == 4) {
      hand_over();
    }
  };
  const auto visit_row = [&](std::uint32_t i, std::uint32_t cells, std::uint32_t j) {
    for (const std::uint32_t end = i + cells; i < end; ++i) {
      visit_base_at(i, j, add);
    }
  };
  data_->ranges.visit_over(cells_under(box), box, visit_row,
                           [this](const RangePyramid::Block& block) { return base_range(block); });
  hand_over();
}

void HeightField::visit_base_below(const Vec3& direction, Real& limit, const TakePart& take) const {
  const Data& field = *data_;
  const auto visit_cell = [&](std::uint32_t i, std::uint32_t j) {
    visit_base_at(i, j, [&](const BaseTriangle& triangle, std::uint32_t number) {
      if (const TriangleCorners corners = corners_of(triangle); least_along(corners, direction) <= limit) {
        take({corners, number, true});
      }
    });
  };
  field.ranges.visit_in_order(
      {field.spacing_x, field.spacing_y}, limit, [&](const Aabb& box) { return least_along(box, direction); },
      visit_cell, [this](const RangePyramid::Block& block) { return base_range(block); });
}

void HeightField::find_base_children(std::uint32_t node, Children& out) const {
  const Data& field = *data_;
  const std::uint32_t first = field.ranges.node_count();
  const auto add_block = [&](std::uint32_t number, const Aabb& box) { out.push_back({first + number, box}); };
  const auto add_cells = [&](const RangePyramid::Rectangle& cells) {
    for (std::uint32_t j = cells.row; j < cells.row + cells.rows; ++j) {
      for (std::uint32_t i = cells.column; i < cells.column + cells.columns; ++i) {
        visit_base_at(i, j, [&](const BaseTriangle& triangle, std::uint32_t number) {
          out.push_back({number | EightBoxes::item_bit, box_around(corners_of(triangle))});
        });
      }
    }
  };
  field.ranges.visit_in_block(node, {field.spacing_x, field.spacing_y}, add_block, add_cells,
                              [this](const RangePyramid::Block& block) { return base_range(block); });
}

void HeightField::meet_base(const RaySlabs& slabs, const RaySlabs::Stretch& over_box, const Real& nearest,
                            const MeetTriangle& meet) const {
  const Data& field = *data_;
  const auto meet_cell = [&](std::uint32_t i, std::uint32_t j, const RaySlabs::Stretch&) {
    visit_base_at(i, j,
                  [&](const BaseTriangle& triangle, std::uint32_t number) { meet(corners_of(triangle), number); });
  };
  field.ranges.visit_ray(slabs, over_box, {field.spacing_x, field.spacing_y}, nearest, meet_cell,
                         [this](const RangePyramid::Block& block) { return base_range(block); });
}

// Adds points of the floor to the samples, and all triangles.
void HeightField::close(Triangles& out) const {
  const Data& field = *data_;
  const auto samples = static_cast<std::uint32_t>(out.vertices.size()),
             count = static_cast<std::uint32_t>(triangle_count());
  for (std::uint32_t place = 0; place < samples; ++place) {
    out.vertices.push_back(point({{place % field.columns, place / field.columns}, true}));
  }
  for (std::uint32_t number = 0; number < 2 * count + 4 * (field.columns + field.rows - 2); ++number) {
    const auto triangle = base_triangle(number).value_or(BaseTriangle{});
    for (const BaseCorner& corner : triangle) {
      out.indices.push_back(corner.at.j * field.columns + corner.at.i + (corner.is_on_floor ? samples : 0));
    }
  }
}

// How many triangles of the grid there are at an edge.
unsigned HeightField::triangles_at(const Sample& one, const Sample& other) const {
  unsigned count = 0;
  if (!std::isnan(height(one.i, one.j) + height(other.i, other.j))) {
    for (const std::optional<Sample>& across : samples_across(one, other)) {
      count += across && !std::isnan(height(across->i, across->j)) ? 1u : 0u;
    }
  }
  return count;
}

// Calls visit(sample, count) for the other ends of edges from a sample, with how many triangles there are at each.
template <class Visitor>
void HeightField::visit_edges_from(const Sample& from, Visitor&& visit) const {
  const Data& field = *data_;
  for (std::uint32_t j = from.j > 0 ? from.j - 1 : 0; j <= from.j + 1 && j < field.rows; ++j) {
    for (std::uint32_t i = from.i > 0 ? from.i - 1 : 0; i <= from.i + 1 && i < field.columns; ++i) {
      const bool is_diagonal = i != from.i && j != from.j;
      const bool is_edge = !is_diagonal || is_falling(field.diagonal, std::min(i, from.i), std::min(j, from.j)) ==
                                               ((i < from.i) != (j < from.j));
      const unsigned count = is_edge && Sample{i, j} != from ? triangles_at(from, {i, j}) : 0;
      if (count > 0) {
        visit(Sample{i, j}, count);
      }
    }
  }
}

// Whether walls may change what is a crest of a triangle.
bool HeightField::is_at_base(std::uint32_t index) const {
  const Data& field = *data_;
  const std::uint32_t cell = index / 2, i = cell % (field.columns - 1), j = cell / (field.columns - 1);
  return index >= triangle_count() || lacks_triangles() || i == 0 || j == 0 || i + 2 == field.columns ||
         j + 2 == field.rows;
}

// See is_crest.
bool HeightField::is_crest_of_solid(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
  const auto triangle = base_triangle(index);
  if (!triangle) {
    return true;
  }
  const unsigned others = corners & (corners - 1);
  const BaseCorner& first = (*triangle)[static_cast<unsigned>(std::countr_zero(corners))];
  const Vec3 start = point(first);
  const auto rises = [&](const BaseCorner& corner) { return dot(direction, point(corner) - start) > height; };
  const auto across_wall = [](const BaseCorner& corner) { return BaseCorner{corner.at, !corner.is_on_floor}; };
  if (others == 0) {
    bool is_crest = true, is_at_wall = false;
    visit_edges_from(first.at, [&](const Sample& other, unsigned count) {
      is_crest = is_crest && !rises({other, first.is_on_floor});
      is_at_wall = is_at_wall || count == 1;
    });
    return is_crest && !(is_at_wall && rises(across_wall(first)));
  }
  const BaseCorner& second = (*triangle)[static_cast<unsigned>(std::countr_zero(others))];
  if (rises(second)) {
    return false;
  }
  if (first.at == second.at) {
    // Between walls.
    bool is_crest = true;
    visit_edges_from(first.at, [&](const Sample& other, unsigned count) {
      is_crest = is_crest && !(count == 1 && rises({other, first.is_on_floor}));
    });
    return is_crest;
  }
  if (first.is_on_floor != second.is_on_floor) {
    // Where a wall is cut in two.
    return !rises(across_wall(first)) && !rises(across_wall(second));
  }
  for (const std::optional<Sample>& across : samples_across(first.at, second.at)) {
    if (across && !std::isnan(this->height(across->i, across->j)) && rises({*across, first.is_on_floor})) {
      return false;
    }
  }
  return triangles_at(first.at, second.at) > 1 || !(rises(across_wall(first)) || rises(across_wall(second)));
}

}  // namespace abut
