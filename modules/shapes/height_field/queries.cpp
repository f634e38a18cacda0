// SPDX-License-Identifier: Apache-2.0
module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;
import abut.trees.grids.range_pyramid;
import abut.trees.volumes.ray_slabs;

namespace abut {

// Of the triangles around a sample, or at the edge between two, those that are there: no comparison with NaN holds.
bool HeightField::is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
  const Data& field = *data_;
  if (field.is_solid && is_at_base(index)) {
    return is_crest_of_solid(index, corners, direction, height);
  }
  const std::uint32_t cell = index / 2;
  const auto own = samples_of(cell % (field.columns - 1), cell / (field.columns - 1), index % 2 != 0);
  const unsigned others = corners & (corners - 1);
  const Sample& first = own[static_cast<unsigned>(std::countr_zero(corners))];
  const Real highest = dot(direction, point(first.i, first.j)) + height;
  const auto height_of = [&](const Sample& sample) { return dot(direction, point(sample.i, sample.j)); };
  if (others != 0) {
    const Sample& second = own[static_cast<unsigned>(std::countr_zero(others))];
    const auto [one, other] = samples_across(first, second);
    return !(height_of(second) > highest) && !(one && height_of(*one) > highest) &&
           !(other && height_of(*other) > highest);
  }
  for (std::uint32_t j = first.j > 0 ? first.j - 1 : 0; j <= first.j && j < field.rows - 1; ++j) {
    for (std::uint32_t i = first.i > 0 ? first.i - 1 : 0; i <= first.i && i < field.columns - 1; ++i) {
      // The other corners of the cell, from the one across on.
      const Sample across{2 * i + 1 - first.i, 2 * j + 1 - first.j};
      const Real beside = height_of({across.i, first.j}), above = height_of({first.i, across.j});
      const bool is_on_diagonal = is_falling(field.diagonal, i, j) != ((first.i == i) == (first.j == j));
      if (!is_on_diagonal) {
        if ((beside > highest || above > highest) && !std::isnan(beside + above)) {
          return false;
        }
        continue;
      }
      const Real far = height_of(across);
      const bool is_far_above = far > highest;
      if (((beside > highest || is_far_above) && !std::isnan(beside + far)) ||
          ((above > highest || is_far_above) && !std::isnan(above + far))) {
        return false;
      }
    }
  }
  return true;
}

// The third corners of the two triangles at an edge, where there are cells.
std::array<std::optional<HeightField::Sample>, 2> HeightField::samples_across(const Sample& first,
                                                                              const Sample& second) const {
  const Data& field = *data_;
  const std::uint32_t i = std::min(first.i, second.i), j = std::min(first.j, second.j);
  if (first.i != second.i && first.j != second.j) {
    // A diagonal: the other two corners of its cell.
    return {Sample{first.i, second.j}, Sample{second.i, first.j}};
  }
  std::array<std::optional<Sample>, 2> across;
  if (first.j == second.j) {
    if (j < field.rows - 1) {
      across[0] = Sample{is_falling(field.diagonal, i, j) ? i : i + 1, j + 1};
    }
    if (j > 0) {
      across[1] = Sample{is_falling(field.diagonal, i, j - 1) ? i + 1 : i, j - 1};
    }
  } else {
    if (i < field.columns - 1) {
      across[0] = Sample{i + 1, is_falling(field.diagonal, i, j) ? j : j + 1};
    }
    if (i > 0) {
      across[1] = Sample{i - 1, is_falling(field.diagonal, i - 1, j) ? j + 1 : j};
    }
  }
  return across;
}

void HeightField::find_children(std::uint32_t node, Children& out) const {
  const Data& field = *data_;
  const std::uint32_t count = field.ranges.node_count();
  if (node >= count) {
    find_base_children(node - count, out);
    return;
  }
  if (node == 0 && field.is_solid) {
    out.push_back({count, field.box});
  }
  field.ranges.visit_in_block(
      node, {field.spacing_x, field.spacing_y},
      [&](std::uint32_t number, const Aabb& box) { out.push_back({number, box}); },
      [&](const RangePyramid::Rectangle& cells) {
        for (std::uint32_t j = cells.row; j < cells.row + cells.rows; ++j) {
          for (std::uint32_t i = cells.column; i < cells.column + cells.columns; ++i) {
            const Cell cell = cell_of(i, j);
            for (const bool is_upper : {false, true}) {
              if (const TriangleCorners of_part = cell.triangle(is_upper); is_there(of_part)) {
                out.push_back({number_of(i, j, is_upper) | EightBoxes::item_bit, box_around(of_part)});
              }
            }
          }
        }
      });
}

// The one of the cell below or above the point, or the nearest one that is there.
Triangle HeightField::part_near(const Vec3& p) const {
  const Data& field = *data_;
  const auto any_of_cell = [&](std::uint32_t i, std::uint32_t j) -> std::optional<std::uint32_t> {
    const Cell cell = cell_of(i, j);
    for (const bool is_upper : {false, true}) {
      if (is_there(cell.triangle(is_upper))) {
        return number_of(i, j, is_upper);
      }
    }
    return std::nullopt;
  };
  const std::uint32_t i = cell_at(p.x / field.spacing_x, field.columns), j = cell_at(p.y / field.spacing_y, field.rows);
  if (const auto below = any_of_cell(i, j)) {
    return part(*below);
  }
  std::uint32_t nearest = 0;
  Real limit = infinity;
  const auto way_to = [&](const Aabb& box) {
    const Real x = std::max(std::max(box.low.x - p.x, p.x - box.high.x), Real{0}),
               y = std::max(std::max(box.low.y - p.y, p.y - box.high.y), Real{0});
    return x + y;
  };
  const auto consider = [&](std::uint32_t column, std::uint32_t row) {
    const auto found = limit == infinity ? any_of_cell(column, row) : std::nullopt;
    nearest = found.value_or(nearest);
    limit = found ? -infinity : limit;
  };
  field.ranges.visit_in_order({field.spacing_x, field.spacing_y}, limit, way_to, consider);
  return part(nearest);
}

std::optional<RayHit> HeightField::cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
  const Data& field = *data_;
  const RaySlabs slabs(origin, direction, field.box);
  const TriangleRay ray(origin, direction);
  const RaySlabs::Stretch over_box = slabs.within(field.box, {0, max_distance});
  Real nearest = max_distance;
  std::uint32_t hit = no_index;
  // A triangle that is missing is met nowhere: comparisons with NaN are false.
  const auto meet = [&](const TriangleCorners& corners, std::uint32_t index) {
    const auto distance = ray.distance_to(corners, nearest);
    if (distance && (*distance < nearest || index < hit)) {
      nearest = *distance;
      hit = index;
    }
  };
  const auto meet_cell = [&](std::uint32_t i, std::uint32_t j, const RaySlabs::Stretch& over) {
    const Cell cell = cell_of(i, j);
    const Heights heights = cell.heights();
    if (!slabs.within(2, heights.low, heights.high, over).is_empty()) {
      meet(cell.triangle(false), number_of(i, j, false));
      meet(cell.triangle(true), number_of(i, j, true));
    }
  };
  field.ranges.visit_ray(slabs, over_box, {field.spacing_x, field.spacing_y}, nearest, meet_cell);
  // Without holes walls and floors lie in the sides of the box: a way meets none where both of its ends lie off these.
  const RaySlabs::Stretch way = over_box.until(nearest);
  const auto is_at_base = [&](Real length) {
    constexpr Real slack_share = 1e-9;
    const Vec3 point = origin + length * direction;
    const Vec3 size = maximum(maximum(absolute(field.box.low), absolute(field.box.high)), absolute(origin));
    return reaches_base(Aabb{point, point}.inflated(slack_share * largest_magnitude(size)));
  };
  if (field.is_solid && !way.is_empty() && (is_at_base(way.enter) || is_at_base(way.leave))) {
    meet_base(slabs, over_box, nearest,
              [&meet](const TriangleCorners& corners, std::uint32_t index) { meet(corners, index); });
  }
  return hit == no_index ? std::nullopt : std::optional(RayHit{nearest, part(hit).normal(), {FeatureKind::face, hit}});
}

// Below the triangle of the column, and nowhere below a hole.
bool HeightField::contains(const Vec3& p) const {
  const Data& field = *data_;
  if (!field.box.overlaps({p, p})) {
    return false;
  }
  const std::uint32_t i = cell_at(p.x / field.spacing_x, field.columns), j = cell_at(p.y / field.spacing_y, field.rows);
  const Real x = p.x / field.spacing_x - i, y = p.y / field.spacing_y - j;
  const Cell cell = cell_of(i, j);
  const Real a = cell.a.z, b = cell.b.z, c = cell.c.z, d = cell.d.z;
  // On either side of the diagonal.
  Real surface = y <= x ? a + x * (b - a) + y * (d - b) : a + y * (c - a) + x * (d - c);
  if (cell.is_falling) {
    surface = x + y <= 1 ? a + x * (b - a) + y * (c - a) : d + (1 - x) * (c - d) + (1 - y) * (b - d);
  }
  return p.z < surface;
}

Triangles HeightField::triangles() const {
  const Data& field = *data_;
  Triangles out;
  out.vertices.reserve(field.heights.size());
  for (std::uint32_t j = 0; j < field.rows; ++j) {
    for (std::uint32_t i = 0; i < field.columns; ++i) {
      const Vec3 sample = point(i, j);
      out.vertices.push_back(std::isnan(sample.z) ? Vec3{sample.x, sample.y, field.box.low.z} : sample);
    }
  }
  if (field.is_solid) {
    close(out);
    return out;
  }
  for (std::uint32_t j = 0; j + 1 < field.rows; ++j) {
    for (std::uint32_t i = 0; i + 1 < field.columns; ++i) {
      for (const bool is_upper : {false, true}) {
        const bool is_missing = !is_there(cell_of(i, j).triangle(is_upper));
        const auto samples = samples_of(i, j, is_upper);
        for (const Sample& sample : samples) {
          const Sample& corner = is_missing ? samples[0] : sample;
          out.indices.push_back(corner.j * field.columns + corner.i);
        }
      }
    }
  }
  return out;
}

}  // namespace abut
