// SPDX-License-Identifier: Apache-2.0
module abut.trees.winding_number;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

namespace abut {
namespace {

// Halves the triangles along the longest axis of their centres; the first half has `first` of them.
void cut(std::span<std::uint32_t> order, std::size_t first, std::span<const Vec3> centres) {
  Aabb box = Aabb::empty();
  for (const std::uint32_t triangle : order) {
    box.include(centres[triangle]);
  }
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const Real at_a = centres[a][axis], at_b = centres[b][axis];
                     return at_a < at_b || (at_a == at_b && a < b);
                   });
}

// Sums over the triangles of a group, about its centre.
struct Moments {
  Vec3 area{0, 0, 0};
  std::array<Vec3, 3> first{};                  // [i][j]: area i times place j
  std::array<std::array<Vec3, 3>, 3> second{};  // [i][j][k]: area i times place j times place k
  Real third = 0;                               // area times the cube of the distance, at most
  Real square_of_radius = 0;

  // Integrals over a triangle: of places that of the middle, of their products a twelfth of those of the corners and of
  // nine times the middle. A cube of a distance is convex: its mean is below that of the corners.
  void add(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec3 vector = 0.5 * cross(b - a, c - a), middle = (1.0 / 3.0) * (a + b + c);
    area += vector;
    Real cubes = 0;
    for (const Vec3& corner : corners) {
      const Real square = squared_norm(corner);
      square_of_radius = std::max(square_of_radius, square);
      cubes += square * std::sqrt(square);
    }
    third += norm(vector) * cubes / 3;
    for (int i = 0; i < 3; ++i) {
      first[static_cast<std::size_t>(i)] += vector[i] * middle;
      for (int j = 0; j < 3; ++j) {
        const Vec3 products = 9 * middle[j] * middle + a[j] * a + b[j] * b + c[j] * c;
        second[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += (vector[i] / 12) * products;
      }
    }
  }
  [[nodiscard]] Real pair(int i, int j) const {
    const auto at = [&](int p, int q) { return first[static_cast<std::size_t>(p)][q]; };
    return 0.5 * (at(i, j) + at(j, i)) - (i == j ? (at(0, 0) + at(1, 1) + at(2, 2)) / 3 : 0);
  }
  [[nodiscard]] Real triple(int i, int j, int k) const {
    const auto at = [&](int p, int q, int r) {
      return second[static_cast<std::size_t>(p)][static_cast<std::size_t>(q)][r];
    };
    const auto even = [&](int p, int q, int r) { return (at(p, q, r) + at(q, r, p) + at(r, p, q)) / 3; };
    const auto trace = [&](int axis) { return even(0, 0, axis) + even(1, 1, axis) + even(2, 2, axis); };
    return even(i, j, k) - ((i == j ? trace(k) : 0) + (i == k ? trace(j) : 0) + (j == k ? trace(i) : 0)) / 5;
  }
};

}  // namespace

WindingNumber::WindingNumber(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices)
    : vertices_(vertices.begin(), vertices.end()) {
  const auto count = static_cast<std::uint32_t>(indices.size() / 3);
  if (count == 0) {
    return;
  }
  std::vector<Vec3> centres(count);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = 0; i < count; ++i) {
    centres[i] = vertices[indices[3 * i]] + vertices[indices[3 * i + 1]] + vertices[indices[3 * i + 2]];
  }
  build({0, count}, centres, order);
  triangles_.reserve(count);
  for (const std::uint32_t triangle : order) {
    triangles_.push_back({indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]});
  }
  blocks_.shrink_to_fit();
  measure();
}

// Halves of halves. Cuts lie where all groups but the last one are full, so that few blocks hold them.
std::uint32_t WindingNumber::build(Range range, std::span<const Vec3> centres, std::span<std::uint32_t> order) {
  const auto block = static_cast<std::uint32_t>(blocks_.size());
  blocks_.emplace_back();
  std::uint32_t full = triangles_of_leaf;
  while (std::uint64_t{full} * width < range.count) {
    full *= width;
  }
  const std::uint32_t groups = (range.count + full - 1) / full, before = groups / 2;
  const auto cut_after = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t groups_before) {
    const std::uint32_t from = range.first + begin * full, to = range.first + std::min(end * full, range.count);
    cut(order.subspan(from, to - from), groups_before * full, centres);
  };
  if (before > 0) {
    cut_after(0, groups, before);
  }
  if (before > 1) {
    cut_after(0, before, 1);
  }
  if (groups - before > 1) {
    cut_after(before, groups, 1);
  }
  for (std::uint32_t lane = 0; lane < groups; ++lane) {
    const Range group{range.first + lane * full, std::min(full, range.count - lane * full)};
    const std::uint32_t child = group.count <= triangles_of_leaf ? no_child : build(group, centres, order);
    blocks_[block].ranges[lane] = group;
    blocks_[block].children[lane] = child;
  }
  return block;
}

void WindingNumber::refit(std::span<const Vec3> vertices) {
  std::copy(vertices.begin(), vertices.end(), vertices_.begin());
  measure();
}

void WindingNumber::measure() {
  Aabb box = Aabb::empty();
  for (const Corners& corners : triangles_) {
    for (const std::uint32_t corner : corners) {
      box.include(vertices_[corner]);
    }
  }
  origin_ = box.centre();
  const Real size = largest_magnitude(0.5 * box.high - 0.5 * box.low);
  scale_ = size > 0 ? std::ldexp(1.0, -std::ilogb(size)) : 1;
  for (Block& block : blocks_) {
    for (std::size_t lane = 0; lane < width; ++lane) {
      measure_group(block, lane);
    }
  }
}

void WindingNumber::measure_group(Block& block, std::size_t lane) const {
  const auto group = std::span(triangles_).subspan(block.ranges[lane].first, block.ranges[lane].count);
  const auto corners_of = [&](const Corners& corners, const Vec3& origin) {
    return std::array{local(vertices_[corners[0]]) - origin, local(vertices_[corners[1]]) - origin,
                      local(vertices_[corners[2]]) - origin};
  };
  // The middle of the areas.
  Vec3 centre{0, 0, 0}, middle{0, 0, 0};
  Real area = 0;
  for (const Corners& triangle : group) {
    const auto [a, b, c] = corners_of(triangle, {0, 0, 0});
    const Real its = norm(cross(b - a, c - a));
    centre += its * (a + b + c);
    middle += a + b + c;
    area += its;
  }
  centre = area > 0 ? (1 / (3 * area)) * centre : (1.0 / std::max(3.0 * static_cast<Real>(group.size()), 1.0)) * middle;
  Moments moments;
  for (const Corners& triangle : group) {
    moments.add(corners_of(triangle, centre));
  }
  const Real share = 1 / (4 * std::numbers::pi);
  const Vec3 vector = share * moments.area;
  block.centre.x[lane] = centre.x;
  block.centre.y[lane] = centre.y;
  block.centre.z[lane] = centre.z;
  block.radius[lane] = std::sqrt(moments.square_of_radius);
  block.blur[lane] = share * moments.third;
  block.area.x[lane] = vector.x;
  block.area.y[lane] = vector.y;
  block.area.z[lane] = vector.z;
  const std::array first{moments.pair(0, 0), moments.pair(1, 1), moments.pair(0, 1), moments.pair(0, 2),
                         moments.pair(1, 2)};
  for (std::size_t i = 0; i < first.size(); ++i) {
    block.first[i][lane] = share * first[i];
  }
  const std::array second{moments.triple(0, 0, 0), moments.triple(1, 1, 1), moments.triple(0, 0, 1),
                          moments.triple(0, 0, 2), moments.triple(1, 1, 0), moments.triple(1, 1, 2),
                          moments.triple(0, 1, 2)};
  for (std::size_t i = 0; i < second.size(); ++i) {
    block.second[i][lane] = share * second[i];
  }
}

}  // namespace abut
