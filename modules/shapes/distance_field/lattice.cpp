// SPDX-License-Identifier: Apache-2.0
module abut.shapes.distance_field.lattice;
import abut.core.standard;
import abut.math;
import abut.trees.samples.sparse_blocks;

namespace abut {
namespace {

// The six numbers of a symmetric matrix.
struct Symmetric {
  Real xx, yy, zz, xy, xz, yz;

  [[nodiscard]] static Symmetric part_of(const LinearMap& m) {
    return {m.x.x, m.y.y, m.z.z, 0.5 * (m.x.y + m.y.x), 0.5 * (m.x.z + m.z.x), 0.5 * (m.y.z + m.z.y)};
  }
  // How a map measures lengths.
  [[nodiscard]] static Symmetric square_of(const LinearMap& m) {
    return {dot(m.x, m.x), dot(m.y, m.y), dot(m.z, m.z), dot(m.x, m.y), dot(m.x, m.z), dot(m.y, m.z)};
  }
  [[nodiscard]] Symmetric operator-() const { return {-xx, -yy, -zz, -xy, -xz, -yz}; }
  // Whether all eigenvalues exceed a number: by the leading minors.
  [[nodiscard]] bool exceeds(Real least) const {
    const Real a = xx - least, b = yy - least, c = zz - least, second = a * b - xy * xy;
    return a > 0 && second > 0 && c * second + 2 * xy * xz * yz - a * yz * yz - b * xz * xz > 0;
  }
};

// What all eigenvalues exceed, at most `high`, which they do not; `low` they do.
Real least_eigenvalue(const Symmetric& matrix, Real low, Real high) {
  constexpr int most_halvings = 50;
  for (int i = 0; i < most_halvings; ++i) {
    const Real middle = 0.5 * (low + high);
    (matrix.exceeds(middle) ? low : high) = middle;
  }
  return low;
}
// What no eigenvalue exceeds, at least `low`.
Real most_eigenvalue(const Symmetric& matrix, Real low) {
  Real high = low;
  while (!(-matrix).exceeds(-high) && high < infinity) {
    high *= 2;
  }
  return high < infinity && high > low ? -least_eigenvalue(-matrix, -high, -low) : high;
}

Vec3 scaled(const Vec3& a, const Vec3& by) { return {a.x * by.x, a.y * by.y, a.z * by.z}; }

}  // namespace

LinearMap LinearMap::inverse() const {
  const Vec3 a = cross(y, z), b = cross(z, x), c = cross(x, y);
  const Real by = 1 / dot(x, a);
  return {by * Vec3{a.x, b.x, c.x}, by * Vec3{a.y, b.y, c.y}, by * Vec3{a.z, b.z, c.z}};
}

FieldLattice::FieldLattice(const GridPlace& counts, const Aabb& box, std::vector<Vec3> points)
    : counts_(counts), box_(box), points_(std::move(points)) {
  const Vec3 size = box.high - box.low;
  cell_ = {size.x / (counts.x - 1), size.y / (counts.y - 1), size.z / (counts.z - 1)};
  find_average();
  if (average_.determinant() > 0) {
    straight_ = average_.inverse();
    find_stretches();
  }
}

Vec3 FieldLattice::at_rest(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  return box_.low + scaled(cell_, {static_cast<Real>(i), static_cast<Real>(j), static_cast<Real>(k)});
}

// But for the rounding of whoever spreads points evenly.
bool FieldLattice::is_at_rest() const {
  const Real rounding = 8 * epsilon * std::max(largest_magnitude(box_.low), largest_magnitude(box_.high));
  for (std::uint32_t k = 0; k < counts_.z; ++k) {
    for (std::uint32_t j = 0; j < counts_.y; ++j) {
      for (std::uint32_t i = 0; i < counts_.x; ++i) {
        if (largest_magnitude(points_[number_of(i, j, k)] - at_rest(i, j, k)) > rounding) {
          return false;
        }
      }
    }
  }
  return true;
}

template <class Visitor>
void FieldLattice::visit_edges(Visitor&& visit) const {
  for (std::uint32_t k = 0; k < counts_.z; ++k) {
    for (std::uint32_t j = 0; j < counts_.y; ++j) {
      for (std::uint32_t i = 0; i < counts_.x; ++i) {
        const Vec3& from = points_[number_of(i, j, k)];
        if (i + 1 < counts_.x) {
          visit(0, (1 / cell_.x) * (points_[number_of(i + 1, j, k)] - from));
        }
        if (j + 1 < counts_.y) {
          visit(1, (1 / cell_.y) * (points_[number_of(i, j + 1, k)] - from));
        }
        if (k + 1 < counts_.z) {
          visit(2, (1 / cell_.z) * (points_[number_of(i, j, k + 1)] - from));
        }
      }
    }
  }
}

void FieldLattice::find_average() {
  Vec3 sum{0, 0, 0};
  for (const Vec3& point : points_) {
    sum += point;
  }
  middle_ = (1 / static_cast<Real>(points_.size())) * sum;
  std::array<Vec3, 3> sums{Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 0}};
  std::array<Real, 3> counts{0, 0, 0};
  visit_edges([&](std::size_t axis, const Vec3& slope) {
    sums[axis] += slope;
    ++counts[axis];
  });
  average_ = {(1 / counts[0]) * sums[0], (1 / counts[1]) * sums[1], (1 / counts[2]) * sums[2]};
}

// In each cell a column of the slope is a mean of those of four edges. Beyond the box it is that of the average.
void FieldLattice::find_stretches() {
  constexpr Real least_allowed = 0.02, rounding = 1e-9;
  Real least = 1, most_squared = 1;
  for (std::uint32_t k = 0; k + 1 < counts_.z; ++k) {
    for (std::uint32_t j = 0; j + 1 < counts_.y; ++j) {
      for (std::uint32_t i = 0; i + 1 < counts_.x; ++i) {
        std::array<std::array<Vec3, 5>, 3> columns{};
        columns[0][4] = {1, 0, 0};
        columns[1][4] = {0, 1, 0};
        columns[2][4] = {0, 0, 1};
        for (std::uint32_t edge = 0; edge < 4; ++edge) {
          const std::uint32_t a = edge & 1u, b = edge >> 1;
          const auto along = [&](const Vec3& from, const Vec3& to, Real length) {
            return straight_ * ((1 / length) * (to - from));
          };
          columns[0][edge] =
              along(points_[number_of(i, j + a, k + b)], points_[number_of(i + 1, j + a, k + b)], cell_.x);
          columns[1][edge] =
              along(points_[number_of(i + a, j, k + b)], points_[number_of(i + a, j + 1, k + b)], cell_.y);
          columns[2][edge] =
              along(points_[number_of(i + a, j + b, k)], points_[number_of(i + a, j + b, k + 1)], cell_.z);
        }
        for (const Vec3& x : columns[0]) {
          for (const Vec3& y : columns[1]) {
            for (const Vec3& z : columns[2]) {
              const LinearMap slope{x, y, z};
              const Symmetric part = Symmetric::part_of(slope), square = Symmetric::square_of(slope);
              if (!part.exceeds(least)) {
                if (!part.exceeds(least_allowed)) {
                  return;
                }
                least = least_eigenvalue(part, least_allowed, least);
              }
              most_squared = most_eigenvalue(square, most_squared);
            }
          }
        }
      }
    }
  }
  const Symmetric square = Symmetric::square_of(average_);
  const Real least_of_average = least_eigenvalue(square, 0, square.xx),
             most_of_average = most_eigenvalue(square, square.xx);
  relaxed_ = least / most_squared;
  least_stretch_ = (1 - rounding) * least * std::sqrt(least_of_average);
  most_stretch_ = (1 + rounding) * std::sqrt(most_squared * most_of_average);
}

FieldLattice::Bent FieldLattice::bent(const Vec3& at_rest) const {
  const Vec3 inside = maximum(minimum(at_rest, box_.high), box_.low), from_low = inside - box_.low;
  const auto cell_of = [](Real at, std::uint32_t count) {
    return at > 0 ? std::min(static_cast<std::uint32_t>(at), count - 2) : 0;
  };
  const Vec3 at{from_low.x / cell_.x, from_low.y / cell_.y, from_low.z / cell_.z};
  const std::uint32_t i = cell_of(at.x, counts_.x), j = cell_of(at.y, counts_.y), k = cell_of(at.z, counts_.z);
  const Real x = at.x - i, y = at.y - j, z = at.z - k;
  const std::size_t first = number_of(i, j, k), row = counts_.x, layer = row * counts_.y;
  const std::span<const Vec3> p = std::span(points_).subspan(first, layer + row + 2);
  const auto along_x = [&](std::size_t from) { return p[from + 1] - p[from]; };
  const Vec3 x00 = along_x(0), x10 = along_x(row), x01 = along_x(layer), x11 = along_x(layer + row);
  const Vec3 v00 = p[0] + x * x00, v10 = p[row] + x * x10, v01 = p[layer] + x * x01, v11 = p[layer + row] + x * x11;
  const Vec3 y0 = v10 - v00, y1 = v11 - v01, v0 = v00 + y * y0, v1 = v01 + y * y1;
  const Vec3 x0 = x00 + y * (x10 - x00), x1 = x01 + y * (x11 - x01);
  Bent out{v0 + z * (v1 - v0),
           {(1 / cell_.x) * (x0 + z * (x1 - x0)), (1 / cell_.y) * (y0 + z * (y1 - y0)), (1 / cell_.z) * (v1 - v0)}};
  const Vec3 beyond = at_rest - inside;
  if (!(beyond == Vec3{0, 0, 0})) [[unlikely]] {
    out.place += average_ * beyond;
    out.slope = {beyond.x != 0 ? average_.x : out.slope.x, beyond.y != 0 ? average_.y : out.slope.y,
                 beyond.z != 0 ? average_.z : out.slope.z};
  }
  return out;
}

// Cell by cell of the lattice: what is tri-linear lies between its corners.
Aabb FieldLattice::bent_box(const Aabb& at_rest) const {
  const auto ends_along = [&](int axis, std::uint32_t count) {
    std::vector<Real> ends{at_rest.low[axis]};
    for (std::uint32_t i = 0; i < count; ++i) {
      const Real end = box_.low[axis] + i * cell_[axis];
      if (end > at_rest.low[axis] && end < at_rest.high[axis]) {
        ends.push_back(end);
      }
    }
    ends.push_back(at_rest.high[axis]);
    return ends;
  };
  Aabb out = Aabb::empty();
  for (const Real z : ends_along(2, counts_.z)) {
    for (const Real y : ends_along(1, counts_.y)) {
      for (const Real x : ends_along(0, counts_.x)) {
        out.include(bent({x, y, z}).place);
      }
    }
  }
  return out;
}

// By Newton's method. Where that is no good, as it may be across edges of cells, a step by the average leads nearer.
FieldLattice::Unbent FieldLattice::unbent(const Vec3& place) const {
  constexpr int most_steps = 200;
  constexpr Real good_share = 0.7;
  const Real size = largest_magnitude(place) + largest_magnitude(middle_) + largest_magnitude(box_.low) +
                    largest_magnitude(box_.high);
  const Real enough =
      16 * epsilon * size * std::max({Real{1}, norm(straight_.x), norm(straight_.y), norm(straight_.z)});
  Vec3 at_rest = box_.centre() + straight_ * (place - middle_);
  Bent here = bent(at_rest);
  Vec3 off = straight_ * (here.place - place);
  for (int i = 0; i < most_steps && largest_magnitude(off) > enough; ++i) {
    const Vec3 next = at_rest - here.slope.inverse() * (here.place - place);
    const Bent there = bent(next);
    const Vec3 off_there = straight_ * (there.place - place);
    if (squared_norm(off_there) <= good_share * squared_norm(off)) {
      at_rest = next;
      here = there;
      off = off_there;
    } else {
      at_rest = at_rest - relaxed_ * off;
      here = bent(at_rest);
      off = straight_ * (here.place - place);
    }
  }
  return {at_rest, here.slope};
}

}  // namespace abut
