// SPDX-License-Identifier: Apache-2.0
// The surface of a sampled field as a net (Gibson, "Constrained elastic surface nets", 1998): a point in each cell that
// the surface goes through, and two triangles around each edge of the grid that it crosses.
module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.samples.sparse_blocks;

namespace abut {
namespace {

bool is_crossed(const CellCorners& corners) {
  const auto inside = std::ranges::count_if(corners, [](float value) { return value < 0; });
  return inside > 0 && inside < 8;
}

// In a cell, from 0 to 1: the middle of the points where the surface crosses its edges.
Vec3 middle_of_crossings(const CellCorners& corners) {
  Vec3 sum{0, 0, 0};
  Real count = 0;
  for (std::size_t from = 0; from < 8; ++from) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t to = from | std::size_t{1} << axis;
      if (to != from && (corners[from] < 0) != (corners[to] < 0)) {
        const Real a = static_cast<Real>(corners[from]), b = static_cast<Real>(corners[to]), at = a / (a - b);
        const Vec3 start{from & 1 ? 1.0 : 0.0, from & 2 ? 1.0 : 0.0, from & 4 ? 1.0 : 0.0};
        sum += start + Vec3{axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0};
        ++count;
      }
    }
  }
  return (1 / count) * sum;
}

}  // namespace

std::uint32_t DistanceField::cell_number(const GridPlace& place) const {
  const GridPlace& samples = data_->blocks.samples();
  return (place.z * (samples.y - 1) + place.y) * (samples.x - 1) + place.x;
}

// The middle of the crossings, moved onto the surface by Newton's method within the cell.
Vec3 DistanceField::point_in(const SurfaceCell& cell) const {
  const Vec3& spacing = data_->spacing;
  if (data_->is_smooth) {
    return smooth_point_in(cell);
  }
  Vec3 at = middle_of_crossings(cell.corners);
  constexpr int most_steps = 4;
  for (int step = 0; step < most_steps; ++step) {
    const Interpolated found = interpolate(cell.corners, at);
    const Vec3 gradient{found.slope.x / spacing.x, found.slope.y / spacing.y, found.slope.z / spacing.z};
    const Real square = squared_norm(gradient);
    if (found.value == 0 || !(square > 0)) {
      break;
    }
    const Vec3 way = (-found.value / square) * gradient;
    at = maximum(minimum(at + Vec3{way.x / spacing.x, way.y / spacing.y, way.z / spacing.z}, Vec3{1, 1, 1}),
                 Vec3{0, 0, 0});
  }
  return placed(
      at + Vec3{static_cast<Real>(cell.place.x), static_cast<Real>(cell.place.y), static_cast<Real>(cell.place.z)});
}

Vec3 DistanceField::placed(const Vec3& at) const {
  const Vec3& spacing = data_->spacing;
  return data_->origin + Vec3{at.x * spacing.x, at.y * spacing.y, at.z * spacing.z};
}

// The same where values are tri-quadratic. Where that leads nowhere, there is a zero on an edge that is crossed.
Vec3 DistanceField::smooth_point_in(const SurfaceCell& cell) const {
  constexpr int most_steps = 8;
  constexpr Real end_share = 1e-9;  // of a cell
  const Vec3& spacing = data_->spacing;
  const Vec3 low{static_cast<Real>(cell.place.x), static_cast<Real>(cell.place.y), static_cast<Real>(cell.place.z)},
      high = low + Vec3{1, 1, 1};
  Vec3 at = low + middle_of_crossings(cell.corners);
  for (int step = 0; step < most_steps; ++step) {
    const Interpolated found = interpolated(at);
    if (std::fabs(found.value) <= end_share * finest()) {
      return placed(at);
    }
    const Vec3 gradient{found.slope.x / spacing.x, found.slope.y / spacing.y, found.slope.z / spacing.z};
    const Vec3 way = (-found.value / squared_norm(gradient)) * gradient;
    const Vec3 next = at + Vec3{way.x / spacing.x, way.y / spacing.y, way.z / spacing.z};
    if (!is_finite(next)) {
      break;
    }
    at = maximum(minimum(next, high), low);
  }
  const auto corner = [&](std::size_t bits) {
    return low + Vec3{bits & 1 ? 1.0 : 0.0, bits & 2 ? 1.0 : 0.0, bits & 4 ? 1.0 : 0.0};
  };
  std::size_t inside = 0, outside = 0;
  for (std::size_t bits = 0; bits < 8; ++bits) {
    (cell.corners[bits] < 0 ? inside : outside) = bits;
  }
  return placed(zero_between(corner(inside), corner(outside)));
}

SurfacePoints DistanceField::make_surface() const {
  const SparseBlocks& blocks = data_->blocks;
  SurfacePoints out;
  for (std::uint32_t number = 0; number < blocks.blocks().size(); ++number) {
    const SparseBlocks::Block& block = blocks.blocks()[number];
    if (block.place == SparseBlocks::no_samples || block.low >= 0 || block.high < 0) {
      continue;
    }
    const GridBox cells = blocks.cells_of(number);
    SurfacePoints::Run run{Aabb::empty(), static_cast<std::uint32_t>(out.points.size()), 0};
    const std::vector<float> known = data_->is_smooth ? corner_values(cells) : std::vector<float>();
    const auto corners_of = [&](const GridPlace& at) {
      if (!data_->is_smooth) {
        return blocks.corners_of_cell(block, at);
      }
      CellCorners corners{};
      for (std::uint32_t bits = 0; bits < 8; ++bits) {
        corners[bits] =
            known[((at.z + (bits >> 2)) * (cells.count.y + 1) + at.y + (bits >> 1 & 1u)) * (cells.count.x + 1) + at.x +
                  (bits & 1u)];
      }
      return corners;
    };
    for (std::uint32_t k = 0; k < cells.count.z; ++k) {
      for (std::uint32_t j = 0; j < cells.count.y; ++j) {
        for (std::uint32_t i = 0; i < cells.count.x; ++i) {
          const CellCorners corners = corners_of({i, j, k});
          const GridPlace place{cells.first.x + i, cells.first.y + j, cells.first.z + k};
          if (is_crossed(corners)) {
            out.points.push_back(point_in({place, corners}));
            out.cells.push_back(cell_number(place));
            run.box.include(out.points.back());
          } else if (data_->is_smooth && add_uncrossed(block, {i, j, k}, place, out)) {
            run.box.include(out.points.back());
          }
        }
      }
    }
    run.count = static_cast<std::uint32_t>(out.points.size()) - run.first;
    if (run.count > 0) {
      out.runs.push_back(run);
    }
  }
  if (data_->lattice) {
    bend_points(out);
  }
  return out;
}

// An edge of the grid with ends on both sides of the surface: the points in the four cells around it are a quad.
Triangles DistanceField::triangles() const {
  const SparseBlocks& blocks = data_->blocks;
  const SurfacePoints& net = surface();
  Triangles out{net.points, {}};
  // By the number of the cell.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_cell(net.points.size());
  for (std::uint32_t i = 0; i < by_cell.size(); ++i) {
    by_cell[i] = {net.cells[i], i};
  }
  std::ranges::sort(by_cell);
  const auto point_of = [&](const GridPlace& cell) {
    return std::lower_bound(by_cell.begin(), by_cell.end(), std::pair{cell_number(cell), 0u})->second;
  };
  const GridPlace& samples = blocks.samples();
  const auto is_inside_at = [&](const GridPlace& at) {
    return data_->is_smooth ? corner_value(at) < 0 : blocks.sample(at) < 0;
  };
  for (const std::uint32_t cell : net.cells) {
    const GridPlace place{cell % (samples.x - 1), cell / (samples.x - 1) % (samples.y - 1),
                          cell / (samples.x - 1) / (samples.y - 1)};
    const bool is_inside = is_inside_at(place);
    for (int axis = 0; axis < 3; ++axis) {
      const GridPlace along{axis == 0 ? 1u : 0u, axis == 1 ? 1u : 0u, axis == 2 ? 1u : 0u};
      if (is_inside_at({place.x + along.x, place.y + along.y, place.z + along.z}) == is_inside) {
        continue;
      }
      // The ends of such an edge do not both lie on the border, so there are cells all around it.
      const GridPlace first{along.z, along.x, along.y}, second{along.y, along.z, along.x};
      const auto before = [&](bool in_first, bool in_second) {
        return point_of({place.x - (in_first ? first.x : 0) - (in_second ? second.x : 0),
                         place.y - (in_first ? first.y : 0) - (in_second ? second.y : 0),
                         place.z - (in_first ? first.z : 0) - (in_second ? second.z : 0)});
      };
      const std::array<std::uint32_t, 4> quad{before(true, true), before(false, true), before(false, false),
                                              before(true, false)};
      const bool is_forward = is_inside != data_->is_inside_out;
      // Along the shorter diagonal.
      const auto length = [&](std::size_t a, std::size_t b) {
        return squared_norm(net.points[quad[a]] - net.points[quad[b]]);
      };
      const std::size_t start = length(0, 2) <= length(1, 3) ? 0 : 1;
      for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {
        const std::uint32_t a = quad[start], b = quad[(start + turn) % 4], c = quad[(start + turn + 1) % 4];
        out.indices.insert(out.indices.end(), {a, is_forward ? b : c, is_forward ? c : b});
      }
    }
  }
  return out;
}

}  // namespace abut
