// SPDX-License-Identifier: Apache-2.0
module abut.triangles.merged_vertices;
import abut.core.standard;
import abut.math;
import abut.triangles.buffers;

namespace abut {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

Vec3 place_of(std::span<const Real> xyz, std::uint32_t vertex) {
  const std::size_t first = 3 * std::size_t{vertex};
  return {xyz[first], xyz[first + 1], xyz[first + 2]};
}

// Vertices that stay, by the cell of a grid in which they lie. Cells that have the same hash share a list: whoever
// looks compares places anyway. Cells are two distances wide, so that rounding of a place in cells leads no further
// than to the next one.
class [[gsl::Pointer]] VertexCells {
 public:
  VertexCells(std::span<const Real> xyz, Real distance)
      : xyz_(xyz), distance_(distance), first_(std::bit_ceil(xyz.size() / 3 + 1), none), next_(xyz.size() / 3, none) {
    Real largest = 0;
    for (const Real number : xyz) {
      largest = std::max(largest, std::fabs(number));
    }
    constexpr Real least_share = 1e-15;  // of the largest coordinate: narrower cells hold no more places
    width_ = std::max({2 * distance, least_share * largest, std::numeric_limits<Real>::min()});
  }

  void add(std::uint32_t vertex) {
    const Vec3 cell = cell_of(place_of(xyz_, vertex));
    next_[vertex] = std::exchange(first_[list_of(cell.x, cell.y, cell.z)], vertex);
  }
  // The nearest one within the distance; none where there is none.
  [[nodiscard]] std::uint32_t nearest(const Vec3& place) const {
    const Vec3 cell = cell_of(place);
    std::uint32_t best = none;
    Real least = distance_;
    for (Real x = -1; x <= 1; ++x) {
      for (Real y = -1; y <= 1; ++y) {
        for (Real z = -1; z <= 1; ++z) {
          std::uint32_t vertex = first_[list_of(cell.x + x, cell.y + y, cell.z + z)];
          for (; vertex != none; vertex = next_[vertex]) {
            const Real way = norm(place_of(xyz_, vertex) - place);
            if (way < least || (way == least && vertex < best)) {
              least = way;
              best = vertex;
            }
          }
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Vec3 cell_of(const Vec3& place) const {
    return {std::floor(place.x / width_), std::floor(place.y / width_), std::floor(place.z / width_)};
  }
  [[nodiscard]] std::size_t list_of(Real x, Real y, Real z) const {
    std::uint64_t hash = 0;
    for (const Real number : {x, y, z}) {
      constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * golden;  // + 0: of minus zero as of zero
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & (first_.size() - 1);
  }

  std::span<const Real> xyz_;
  Real distance_, width_ = 0;
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace

MergedVertices merge_vertices(std::span<const Real> xyz, std::span<const std::uint32_t> triangles, Real distance) {
  std::vector<bool> is_used(xyz.size() / 3);
  for (std::uint32_t triangle = 0; triangle < triangles.size() / 3; ++triangle) {
    for (std::size_t corner = 0; corner < 3 && !is_removed(triangles, triangle); ++corner) {
      is_used[triangles[3 * std::size_t{triangle} + corner]] = true;
    }
  }
  MergedVertices out{{triangles.begin(), triangles.end()}, 0, 0, 0};
  std::vector<std::uint32_t> stays(xyz.size() / 3);
  VertexCells cells(xyz, distance);
  for (std::uint32_t vertex = 0; vertex < stays.size(); ++vertex) {
    stays[vertex] = vertex;
    if (!is_used[vertex]) {
      continue;
    }
    const Vec3 place = place_of(xyz, vertex);
    if (const std::uint32_t other = cells.nearest(place); other != none) {
      stays[vertex] = other;
      out.error = std::max(out.error, norm(place_of(xyz, other) - place));
      ++out.vertices;
    } else {
      cells.add(vertex);
    }
  }
  for (std::uint32_t triangle = 0; triangle < triangles.size() / 3; ++triangle) {
    const auto its = std::span(out.triangles).subspan(3 * std::size_t{triangle}, 3);
    for (std::uint32_t& corner : its) {
      corner = stays[corner];
    }
    if (!is_removed(triangles, triangle) && (its[0] == its[1] || its[1] == its[2] || its[2] == its[0])) {
      its[1] = its[2] = its[0];
      ++out.collapsed;
    }
  }
  return out;
}

}  // namespace abut
