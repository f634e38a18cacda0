// SPDX-License-Identifier: Apache-2.0
module abut.trees.inside.winding_number;
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

// Moments without trace are those of all, but for what no potential shows.
using Pairs = std::array<Vec3, 3>;
using Triples = std::array<Pairs, 3>;

Pairs pairs_of(const std::array<Lanes, 5>& lanes, std::size_t lane) {
  const Real xx = lanes[0][lane], yy = lanes[1][lane], xy = lanes[2][lane], xz = lanes[3][lane], yz = lanes[4][lane];
  return {Vec3{xx, xy, xz}, Vec3{xy, yy, yz}, Vec3{xz, yz, -xx - yy}};
}

Triples triples_of(const std::array<Lanes, 7>& lanes, std::size_t lane) {
  const Real xxx = lanes[0][lane], yyy = lanes[1][lane], xxy = lanes[2][lane], xxz = lanes[3][lane],
             yyx = lanes[4][lane], yyz = lanes[5][lane], xyz = lanes[6][lane], zzx = -xxx - yyx, zzy = -xxy - yyy,
             zzz = -xxz - yyz;
  return {Pairs{Vec3{xxx, xxy, xxz}, Vec3{xxy, yyx, xyz}, Vec3{xxz, xyz, zzx}},
          Pairs{Vec3{xxy, yyx, xyz}, Vec3{yyx, yyy, yyz}, Vec3{xyz, yyz, zzy}},
          Pairs{Vec3{xxz, xyz, zzx}, Vec3{xyz, yyz, zzy}, Vec3{zzx, zzy, zzz}}};
}

// Sums over the triangles of a group, about its centre, of areas over four pi.
struct Moments {
  static constexpr Real share = 1 / (4 * std::numbers::pi);
  Vec3 area{0, 0, 0};
  Pairs first{};     // [i][j]: area i times place j
  Triples second{};  // [i][j][k]: area i times place j times place k
  Real size = 0, spread = 0, radius = 0;

  // Integrals over a triangle: of places that of the middle, of their products a twelfth of those of the corners and of
  // nine times the middle.
  void add(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec3 vector = (0.5 * share) * cross(b - a, c - a), middle = (1.0 / 3.0) * (a + b + c);
    const Real its = norm(vector);
    area += vector;
    size += its;
    spread += its / 12 * (9 * squared_norm(middle) + squared_norm(a) + squared_norm(b) + squared_norm(c));
    radius = std::max({radius, norm(a), norm(b), norm(c)});
    for (int i = 0; i < 3; ++i) {
      first[static_cast<std::size_t>(i)] += vector[i] * middle;
      for (int j = 0; j < 3; ++j) {
        const Vec3 products = 9 * middle[j] * middle + a[j] * a + b[j] * b + c[j] * c;
        second[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += (vector[i] / 12) * products;
      }
    }
  }
  // Those of a group about its own centre, which lies at `shift`. Its areas have their mean there.
  void add(const Moments& group, const Vec3& shift) {
    area += group.area;
    size += group.size;
    spread += group.spread + group.size * squared_norm(shift);
    radius = std::max(radius, norm(shift) + group.radius);
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      first[row] += group.first[row] + group.area[i] * shift;
      for (int j = 0; j < 3; ++j) {
        second[row][static_cast<std::size_t>(j)] += group.second[row][static_cast<std::size_t>(j)] +
                                                    group.first[row][j] * shift +
                                                    shift[j] * (group.first[row] + group.area[i] * shift);
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
  places_.resize(count);
  for (const std::uint32_t triangle : order) {
    places_[triangle] = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back({indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]});
  }
  blocks_.shrink_to_fit();
  weights_.resize(blocks_.size());
  stale_.resize((width * blocks_.size() + 63) / 64);
  measure();
  first_cost_ = cost();
  tighten();
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

void WindingNumber::move(std::uint32_t triangle, std::span<const Vec3> vertices) {
  const std::uint32_t place = places_[triangle];
  for (const std::uint32_t corner : triangles_[place]) {
    vertices_[corner] = vertices[corner];
  }
  for (std::uint32_t block = 0; block != no_child;) {
    const Block& its = blocks_[block];
    std::uint32_t lane = 0;
    while (place - its.ranges[lane].first >= its.ranges[lane].count) {
      ++lane;
    }
    const std::size_t bit = width * std::size_t{block} + lane;
    stale_[bit / 64] |= std::uint64_t{1} << bit % 64;
    block = its.children[lane];
  }
}

// Groups above others come later, as children come after their parents. Large ones keep bounds that are wider than they
// have to be.
void WindingNumber::settle() {
  constexpr std::uint32_t most_tightened = 16 * triangles_of_leaf;
  for (std::size_t word = stale_.size(); word-- > 0;) {
    while (stale_[word] != 0) {
      const auto last = static_cast<std::size_t>(std::bit_width(stale_[word]) - 1);
      stale_[word] ^= std::uint64_t{1} << last;
      const std::size_t block = (64 * word + last) / width, lane = last % width;
      measure_lane(block, lane);
      if (blocks_[block].ranges[lane].count <= most_tightened) {
        tighten_lane(block, lane);
      }
    }
  }
  // Units are those of the size of the whole, but for a few times it.
  constexpr Real least = 0.25, most = 8;
  Real reach = 0;
  for (std::size_t lane = 0; lane < width && !blocks_.empty(); ++lane) {
    const Block& root = blocks_[0];
    reach = std::max(reach, norm({root.centre.x[lane], root.centre.y[lane], root.centre.z[lane]}) + root.radius[lane]);
  }
  if (!(reach >= least && reach <= most)) {
    measure();
    tighten();
  }
}

Real WindingNumber::cost() const {
  if (blocks_.empty()) {
    return 0;
  }
  const Lanes root = blocks_[0].radius * blocks_[0].radius;
  const Real of_root = root[0] + root[1] + root[2] + root[3];
  return of_root > 0 ? surface_ / of_root : 0;
}

bool WindingNumber::is_worn() const { return cost() > 1.5 * first_cost_; }

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
  for (std::size_t bit = width * blocks_.size(); bit-- > 0;) {
    measure_lane(bit / width, bit % width);
  }
}

void WindingNumber::tighten() {
  for (std::size_t bit = 0; bit < width * blocks_.size(); ++bit) {
    tighten_lane(bit / width, bit % width);
  }
}

// A cube of a distance is convex: its mean over a triangle is below that of the corners.
void WindingNumber::tighten_lane(std::size_t number, std::size_t lane) {
  Block& block = blocks_[number];
  const Vec3 centre{block.centre.x[lane], block.centre.y[lane], block.centre.z[lane]};
  Real square = 0, third = 0;
  for (const Corners& triangle : std::span(triangles_).subspan(block.ranges[lane].first, block.ranges[lane].count)) {
    const Vec3 a = local(vertices_[triangle[0]]) - centre, b = local(vertices_[triangle[1]]) - centre,
               c = local(vertices_[triangle[2]]) - centre;
    Real cubes = 0;
    for (const Real its : {squared_norm(a), squared_norm(b), squared_norm(c)}) {
      square = std::max(square, its);
      cubes += its * std::sqrt(its);
    }
    third += norm(cross(b - a, c - a)) * cubes;
  }
  surface_ += square - block.radius[lane] * block.radius[lane];
  block.radius[lane] = std::sqrt(square);
  block.blur[lane] = Moments::share / 6 * third;
}

void WindingNumber::measure_lane(std::size_t number, std::size_t lane) {
  Block& block = blocks_[number];
  Moments moments;
  Vec3 centre{0, 0, 0}, middle{0, 0, 0};
  Real sizes = 0, count = 0;
  // The middle of the areas.
  const auto weigh = [&](const Vec3& its, Real size) {
    centre += size * its;
    middle += its;
    sizes += size;
    count += 1;
  };
  const auto find_centre = [&] { centre = sizes > 0 ? (1 / sizes) * centre : (1 / std::max(count, 1.0)) * middle; };
  if (block.children[lane] == no_child) {
    const auto group = std::span(triangles_).subspan(block.ranges[lane].first, block.ranges[lane].count);
    const auto corners_of = [&](const Corners& corners, const Vec3& origin) {
      return std::array{local(vertices_[corners[0]]) - origin, local(vertices_[corners[1]]) - origin,
                        local(vertices_[corners[2]]) - origin};
    };
    for (const Corners& triangle : group) {
      const auto [a, b, c] = corners_of(triangle, {0, 0, 0});
      weigh((1.0 / 3.0) * (a + b + c), norm(cross(b - a, c - a)));
    }
    find_centre();
    for (const Corners& triangle : group) {
      moments.add(corners_of(triangle, centre));
    }
  } else {
    const Block& child = blocks_[block.children[lane]];
    const Weights& weights = weights_[block.children[lane]];
    const auto centre_of = [&](std::size_t of) {
      return Vec3{child.centre.x[of], child.centre.y[of], child.centre.z[of]};
    };
    for (std::size_t of = 0; of < width && child.ranges[of].count > 0; ++of) {
      weigh(centre_of(of), weights.size[of]);
    }
    find_centre();
    for (std::size_t of = 0; of < width && child.ranges[of].count > 0; ++of) {
      moments.add(Moments{{child.area.x[of], child.area.y[of], child.area.z[of]},
                          pairs_of(child.first, of),
                          triples_of(child.second, of),
                          weights.size[of],
                          weights.spread[of],
                          child.radius[of]},
                  centre_of(of) - centre);
    }
  }
  block.centre.x[lane] = centre.x;
  block.centre.y[lane] = centre.y;
  block.centre.z[lane] = centre.z;
  surface_ += moments.radius * moments.radius - block.radius[lane] * block.radius[lane];
  block.radius[lane] = moments.radius;
  weights_[number].size[lane] = moments.size;
  weights_[number].spread[lane] = moments.spread;
  // No place is further away than the radius.
  block.blur[lane] = moments.radius * moments.spread;
  block.area.x[lane] = moments.area.x;
  block.area.y[lane] = moments.area.y;
  block.area.z[lane] = moments.area.z;
  const std::array first{moments.pair(0, 0), moments.pair(1, 1), moments.pair(0, 1), moments.pair(0, 2),
                         moments.pair(1, 2)};
  for (std::size_t i = 0; i < first.size(); ++i) {
    block.first[i][lane] = first[i];
  }
  const std::array second{moments.triple(0, 0, 0), moments.triple(1, 1, 1), moments.triple(0, 0, 1),
                          moments.triple(0, 0, 2), moments.triple(1, 1, 0), moments.triple(1, 1, 2),
                          moments.triple(0, 1, 2)};
  for (std::size_t i = 0; i < second.size(); ++i) {
    block.second[i][lane] = second[i];
  }
}

}  // namespace abut
