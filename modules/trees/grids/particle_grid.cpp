// SPDX-License-Identifier: Apache-2.0
module abut.trees.grids.particle_grid;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

// The side of a cell at which a box holds at most `count` cells along its length, in its area and in its volume.
Real side_for(const Aabb& box, Real count) {
  std::array extents{box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
  std::ranges::sort(extents);
  const Real along = extents[2] / count, across = std::sqrt(extents[2] / count) * std::sqrt(extents[1]);
  return std::max({along, across, std::cbrt(extents[2] / count) * std::cbrt(extents[1]) * std::cbrt(extents[0])});
}

}  // namespace

HashGrid::HashGrid(std::span<const Vec3> points, Real least_cell) {
  for (const Vec3& point : points) {
    bounds_.include(point);
  }
  cell_ = std::max(least_cell, side_for(bounds_, static_cast<Real>(points.size())));
  // Coincident points without extent have one cell of any size.
  per_cell_ = cell_ > 0 ? 1 / cell_ : 0;
  mask_ = std::bit_ceil(2 * points.size()) - 1;
  starts_.resize(mask_ + 2);
  // Counting sort by bucket; equal buckets keep the order of the points.
  for (const Vec3& point : points) {
    ++starts_[bucket_of(cell_of(point)) + 1];
  }
  for (std::size_t i = 1; i < starts_.size(); ++i) {
    starts_[i] += starts_[i - 1];
  }
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  items_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    items_[next[bucket_of(cell_of(points[i]))]++] = {points[i], static_cast<std::uint32_t>(i)};
  }
}

std::uint32_t HashGrid::item_near(const Vec3& place) const {
  const Vec3 inside = maximum(minimum(place, bounds_.high), bounds_.low);
  std::uint32_t best = items_.front().index;
  Real least = infinity;
  const auto consider = [&](const Item& item) {
    const Real square = squared_norm(item.point - place);
    if (square < least) {
      least = square;
      best = item.index;
    }
  };
  // Boxes that double their size: few cells are empty for long, since there are as many cells as points.
  for (Real reach = cell_; least == infinity; reach *= 2) {
    visit_near(Aabb::around(inside, {reach, reach, reach}), consider);
  }
  return best;
}

}  // namespace abut
