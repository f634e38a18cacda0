// SPDX-License-Identifier: Apache-2.0
// Rays against a sampled field, cell by cell: along a ray the value in a cell is a polynomial of third degree (Parker
// et al., "Interactive ray tracing for isosurface rendering", 1998). Where values are tri-quadratic, it is of sixth
// degree in each eighth of a cell. Blocks of one sign are passed at once.
module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.ray_slabs;
import abut.trees.samples.sparse_blocks;

namespace abut {
namespace {

// c[0] + c[1] s + c[2] s^2 + c[3] s^3 for s from 0 to 1.
struct Cubic {
  std::array<Real, 4> c;

  // Through the values at 0, 1/3, 2/3 and 1.
  [[nodiscard]] static Cubic through(const std::array<Real, 4>& v) {
    const Real first = v[1] - v[0], second = v[2] - 2 * v[1] + v[0], third = v[3] - 3 * v[2] + 3 * v[1] - v[0];
    return {{v[0], 3 * first - 1.5 * second + third, 4.5 * (second - third), 4.5 * third}};
  }
  [[nodiscard]] Real at(Real s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

  // Where the slope changes its sign, in rising order, between 0 and 1.
  [[nodiscard]] std::array<Real, 4> pieces() const {
    std::array<Real, 4> ends{0, 1, 1, 1};
    const Real a = 3 * c[3], b = c[2], under = b * b - a * c[1];
    if (!(under > 0)) {
      return ends;
    }
    // 3 c3 s^2 + 2 c2 s + c1 = 0, without cancellation.
    const Real q = -(b + std::copysign(std::sqrt(under), b));
    const Real one = a != 0 ? q / a : 1, two = q != 0 ? c[1] / q : 1;
    const auto limited = [](Real s) { return s > 0 && s < 1 ? s : 1; };
    ends[1] = std::min(limited(one), limited(two));
    ends[2] = std::max(limited(one), limited(two));
    return ends;
  }
  // The zero between two points with values of unlike sign, where the slope has one sign.
  [[nodiscard]] Real zero_between(Real low, Real high) const {
    const bool rises = at(low) < 0;
    constexpr int most_steps = 64;
    Real s = 0.5 * (low + high);
    for (int step = 0; step < most_steps && high - low > epsilon; ++step) {
      const Real value = at(s), slope = c[1] + s * (2 * c[2] + s * 3 * c[3]);
      if (std::fabs(value) <= epsilon * std::fabs(slope)) {
        break;
      }
      ((value < 0) == rises ? low : high) = s;
      const Real next = s - value / slope;
      s = next > low && next < high ? next : 0.5 * (low + high);
    }
    return s;
  }
};

// The first zero along a stretch. `sign_before`: of the values before it, which rounding must not lose.
std::optional<Real> first_zero(const Cubic& cubic, Real& sign_before) {
  const std::array<Real, 4> ends = cubic.pieces();
  const Real start = cubic.at(0);
  if (start == 0 || (sign_before != 0 && (start < 0) != (sign_before < 0))) {
    return 0;
  }
  Real before = start;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Real value = cubic.at(ends[i]);
    if ((value < 0) != (before < 0) || value == 0) {
      return cubic.zero_between(ends[i - 1], ends[i]);
    }
    before = value;
  }
  sign_before = before;
  return std::nullopt;
}

// In Bernstein form, for s from 0 to 1.
struct Sextic {
  std::array<Real, 7> c;

  // Its halves, by de Casteljau.
  [[nodiscard]] std::pair<Sextic, Sextic> halves() const {
    Sextic low{}, high = *this;
    for (std::size_t i = 0; i < c.size(); ++i) {
      low.c[i] = high.c[0];
      for (std::size_t k = 0; k + 1 + i < c.size(); ++k) {
        high.c[k] = 0.5 * (high.c[k] + high.c[k + 1]);
      }
    }
    return {low, high};
  }
  // The first place where the sign is not that of a value before. Nothing where all coefficients have that sign.
  [[nodiscard]] std::optional<Real> first_change(bool is_inside, int halvings = 0) const {
    const auto is_other = [&](Real value) { return is_inside ? value >= 0 : value <= 0; };
    if (std::ranges::none_of(c, is_other)) {
      return std::nullopt;
    }
    constexpr int most_halvings = 52;
    if (is_other(c[0]) || halvings == most_halvings) {
      return 0;
    }
    const auto [low, high] = halves();
    if (const std::optional<Real> found = low.first_change(is_inside, halvings + 1)) {
      return 0.5 * *found;
    }
    const std::optional<Real> found = high.first_change(is_inside, halvings + 1);
    return found ? std::optional(0.5 + 0.5 * *found) : std::nullopt;
  }
};

// The parts of a stretch within a cell: it is cut in the middle between samples. `from` and `to` are seen from the
// first corner of the cell.
std::array<Real, 5> eighths_along(const Vec3& from, const Vec3& to) {
  std::array<Real, 5> ends{0, 1, 1, 1, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const Real a = from[axis] - 0.5, b = to[axis] - 0.5;
    ends[static_cast<std::size_t>(axis) + 1] = (a < 0) != (b < 0) ? std::clamp(a / (a - b), Real{0}, Real{1}) : 1;
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

}  // namespace

// The first zero along a stretch within a cell, as a share of it. `sign_before` as in first_zero.
std::optional<Real> DistanceField::smooth_zero(const SparseBlocks::Block& block, const GridPlace& in_block,
                                               const GridPlace& cell, const Vec3& from, const Vec3& to,
                                               Real& sign_before) const {
  const SparseBlocks& blocks = data_->blocks;
  const std::array<Real, 5> ends = eighths_along(from, to);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Real begin = ends[i], end = ends[i + 1];
    if (!(end > begin) && i > 0) {
      continue;
    }
    const Vec3 a = from + begin * (to - from), b = from + end * (to - from), middle = 0.5 * (a + b);
    const auto upper = [](Real at) { return at < 0.5 ? 0u : 1u; };
    const GridPlace nearest{upper(middle.x), upper(middle.y), upper(middle.z)};
    const Vec3 first{static_cast<Real>(nearest.x), static_cast<Real>(nearest.y), static_cast<Real>(nearest.z)};
    const SamplesAround around =
        blocks.samples_around(block, {in_block.x + nearest.x, in_block.y + nearest.y, in_block.z + nearest.z});
    const auto middle_samples = blocks.ends_at({cell.x + nearest.x, cell.y + nearest.y, cell.z + nearest.z});
    const Sextic along{SplinePatch::make(around, middle_samples, a - first, b - first).diagonal()};
    const Real start = along.c.front();
    if (sign_before == 0) {
      sign_before = start < 0 ? -1 : 1;
      if (start == 0) {
        return begin;
      }
    }
    if (const std::optional<Real> found = along.first_change(sign_before < 0)) {
      return begin + *found * (end - begin);
    }
  }
  return std::nullopt;
}

std::optional<RayHit> DistanceField::cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
  if (data_->lattice) {
    return cast_bent_ray(origin, direction, max_distance);
  }
  const Data& field = *data_;
  const SparseBlocks& blocks = field.blocks;
  const Vec3 o = origin - field.origin, d = direction;
  const auto scaled = [](const Vec3& a, const Vec3& by) { return Vec3{a.x * by.x, a.y * by.y, a.z * by.z}; };
  const Aabb grid{{0, 0, 0}, scaled(field.last, field.spacing)};
  const RaySlabs::Stretch over = RaySlabs(o, d, grid).within(grid, {0, max_distance});
  if (over.is_empty()) {
    return std::nullopt;
  }
  const auto place_at = [&](Real way) {
    const Vec3 at = scaled(o + way * d, field.inverse);
    const auto cell = [](Real value, Real last) {
      return static_cast<std::uint32_t>(value > 0 ? std::min(value, last - 1) : 0);
    };
    return GridPlace{cell(at.x, field.last.x), cell(at.y, field.last.y), cell(at.z, field.last.z)};
  };
  const auto axis_of = [](const GridPlace& place, int axis) {
    return axis == 0 ? place.x : axis == 1 ? place.y : place.z;
  };
  const auto with_axis = [](GridPlace place, int axis, std::uint32_t value) {
    (axis == 0 ? place.x : axis == 1 ? place.y : place.z) = value;
    return place;
  };
  GridPlace cell = place_at(over.enter);
  Real way = over.enter, sign_before = 0;
  for (;;) {
    const std::uint32_t number = (cell.z / SparseBlocks::side * blocks.block_counts().y + cell.y / SparseBlocks::side) *
                                     blocks.block_counts().x +
                                 cell.x / SparseBlocks::side;
    const SparseBlocks::Block& block = blocks.blocks()[number];
    const bool is_passed = block.place == SparseBlocks::no_samples || block.low > 0 || block.high < 0;
    const GridBox box = is_passed ? blocks.cells_of(number) : GridBox{cell, {1, 1, 1}};
    int axis = 0;
    Real leave = infinity;
    for (int i = 0; i < 3; ++i) {
      if (d[i] != 0) {
        const std::uint32_t side = d[i] > 0 ? axis_of(box.first, i) + axis_of(box.count, i) : axis_of(box.first, i);
        const Real until = (side * field.spacing[i] - o[i]) / d[i];
        if (until < leave) {
          leave = until;
          axis = i;
        }
      }
    }
    leave = std::max(leave, way);
    const Real end = std::min(leave, over.leave);
    if (!is_passed) {
      const GridPlace in_block{cell.x % SparseBlocks::side, cell.y % SparseBlocks::side, cell.z % SparseBlocks::side};
      const Vec3 first{static_cast<Real>(cell.x), static_cast<Real>(cell.y), static_cast<Real>(cell.z)};
      const auto place_in_cell = [&](Real at) { return scaled(o + at * d, field.inverse) - first; };
      const auto zero_of_cubic = [&] {
        const CellCorners corners = blocks.corners_of_cell(block, in_block);
        const auto value_at_way = [&](Real at) { return interpolate(corners, place_in_cell(at)).value; };
        return first_zero(Cubic::through({value_at_way(way), value_at_way(way + (end - way) / 3),
                                          value_at_way(way + 2 * (end - way) / 3), value_at_way(end)}),
                          sign_before);
      };
      if (const std::optional<Real> zero =
              field.is_smooth ? smooth_zero(block, in_block, cell, place_in_cell(way), place_in_cell(end), sign_before)
                              : zero_of_cubic()) {
        const Real distance = std::min(way + *zero * (end - way), max_distance);
        const Vec3 normal = value_at(origin + distance * d).gradient;
        return RayHit{distance, UnitVec3::make(normal).value_or(-direction), {FeatureKind::cell, cell_number(cell)}};
      }
    } else {
      sign_before = block.low > 0 ? 1 : -1;
    }
    const bool is_up = d[axis] > 0;
    const std::uint32_t side = axis_of(box.first, axis) + (is_up ? axis_of(box.count, axis) : 0u);
    if (!(leave < over.leave) || (is_up ? side >= field.last[axis] : side == 0)) {
      return std::nullopt;
    }
    // Beside the axis that is left, a whole block may be passed at any of its cells.
    if (is_passed) {
      const GridPlace at = place_at(leave);
      for (int i = 0; i < 3; ++i) {
        cell = with_axis(
            cell, i,
            std::clamp(axis_of(at, i), axis_of(box.first, i), axis_of(box.first, i) + axis_of(box.count, i) - 1));
      }
    }
    cell = with_axis(cell, axis, is_up ? side : side - 1);
    way = leave;
  }
}

}  // namespace abut
