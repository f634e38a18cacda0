// SPDX-License-Identifier: Apache-2.0
module abut.trees.samples.field_sampling;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.inside.nearest_triangle;
import abut.trees.samples.sparse_blocks;
import abut.trees.inside.winding_number;

namespace abut {
namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr std::uint32_t along = SparseBlocks::samples_along(0);
constexpr std::size_t samples_of_block = SparseBlocks::samples_of_block(0);

// Whether each edge leads as often one way as the other. Vertices at one place are one.
bool is_closed(const SurfaceTriangles& surface) {
  std::vector<std::uint32_t> order(surface.vertices.size()), same(order.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto numbers = [&](std::uint32_t vertex) {
    const Vec3& v = surface.vertices[vertex];
    return std::tuple(v.x, v.y, v.z);
  };
  std::ranges::sort(order, {}, numbers);
  for (std::size_t i = 0; i < order.size(); ++i) {
    same[order[i]] = i > 0 && numbers(order[i]) == numbers(order[i - 1]) ? same[order[i - 1]] : order[i];
  }
  std::vector<std::pair<std::uint64_t, int>> edges;
  edges.reserve(surface.indices.size());
  for (std::size_t i = 0; i < surface.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const auto [low, high] = std::pair(same[surface.indices[i]], same[surface.indices[next]]);
    edges.emplace_back(std::uint64_t{std::min(low, high)} << 32 | std::max(low, high), low < high ? 1 : -1);
  }
  std::ranges::sort(edges);
  int sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    sum = edges[i].first >> 32 == (edges[i].first & none) ? sum : sum + edges[i].second;
    if (sum != 0 && (i + 1 == edges.size() || edges[i + 1].first != edges[i].first)) {
      return false;
    }
  }
  return true;
}

std::vector<TriangleAt> triangles_of(const SurfaceTriangles& surface) {
  std::vector<TriangleAt> triangles(surface.indices.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::span<const std::uint32_t> corners = surface.indices.subspan(3 * i, 3);
    triangles[i] = {surface.vertices[corners[0]], surface.vertices[corners[1]], surface.vertices[corners[2]]};
  }
  return triangles;
}

class MeshSampler {
 public:
  MeshSampler(const SurfaceTriangles& surface, const FieldGrid& grid, std::uint32_t fringe)
      : grid_(grid),
        fringe_(fringe),
        blocks_(grid.samples, {grid.spacing, grid.spacing, grid.spacing}, {}, fringe),
        tree_(triangles_of(surface)),
        winding_(surface.vertices, surface.indices),
        is_closed_(is_closed(surface)) {}

  // Which blocks hold samples is known before the first of these is there, so that there is no second copy of any.
  [[nodiscard]] SparseBlocks sample(Real band) && {
    find_closest(band);
    start_corners();
    spread_to_corners();
    find_at_corners();
    sign_corners();
    hold_blocks();
    Workers(0).for_each(held_.size(), [&](std::size_t i) { sample_block(i); });
    if (fringe_ > 0) {
      Workers(0).for_each(held_.size(), [&](std::size_t i) { copy_fringe(i); });
    }
    return std::move(blocks_);
  }

 private:
  // Of a block without its fringe.
  struct BlockSamples {
    std::array<Real, samples_of_block> values;
    std::array<std::uint32_t, samples_of_block> triangles;  // near each
  };

  [[nodiscard]] Vec3 place_of(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return grid_.origin + grid_.spacing * Vec3{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
  }
  [[nodiscard]] std::size_t corner_number(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const GridPlace& counts = blocks_.block_counts();
    return (std::size_t{z} * (counts.y + 1) + y) * (counts.x + 1) + x;
  }
  // Corners lie at each eighth sample, and at the last one.
  [[nodiscard]] Vec3 corner_place(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const GridPlace& all = grid_.samples;
    constexpr std::uint32_t side = SparseBlocks::side;
    return place_of(std::min(side * x, all.x - 1), std::min(side * y, all.y - 1), std::min(side * z, all.z - 1));
  }

  // Of each block that a triangle comes within the band of: the triangle that is nearest to its middle.
  void find_closest(Real band) {
    const std::size_t count = blocks_.blocks().size();
    std::vector<Real> least(count, infinity);
    closest_.assign(count, none);
    const GridPlace& counts = blocks_.block_counts();
    const Real side = SparseBlocks::side * grid_.spacing, reach = 0.5 * std::sqrt(Real{3}) * side + band;
    const auto range = [&](Real low, Real high, std::uint32_t all) {
      const auto block = [&](Real at) {
        return static_cast<std::uint32_t>(std::clamp(std::floor(at / side), Real{0}, static_cast<Real>(all - 1)));
      };
      return std::pair(block(low - band), block(high + band));
    };
    for (std::uint32_t triangle = 0; triangle < tree_.triangles().size(); ++triangle) {
      const TriangleAt& corners = tree_.triangles()[triangle];
      const Vec3 low = minimum(minimum(corners.a, corners.b), corners.c) - grid_.origin,
                 high = maximum(maximum(corners.a, corners.b), corners.c) - grid_.origin;
      const auto [x0, x1] = range(low.x, high.x, counts.x);
      const auto [y0, y1] = range(low.y, high.y, counts.y);
      const auto [z0, z1] = range(low.z, high.z, counts.z);
      for (std::uint32_t z = z0; z <= z1; ++z) {
        for (std::uint32_t y = y0; y <= y1; ++y) {
          for (std::uint32_t x = x0; x <= x1; ++x) {
            const std::size_t number = (std::size_t{z} * counts.y + y) * counts.x + x;
            const Vec3 middle = grid_.origin + side * Vec3{x + 0.5, y + 0.5, z + 0.5};
            const Real squared = squared_distance(middle, corners);
            if (squared <= reach * reach && squared < least[number]) {
              least[number] = squared;
              closest_[number] = triangle;
            }
          }
        }
      }
    }
  }

  void sample_block(std::size_t i) {
    const std::uint32_t number = held_[i];
    BlockSamples samples;
    find_samples(number, samples);
    const std::span<float> out = values_of(i);
    for (std::uint32_t z = 0; z < along; ++z) {
      for (std::uint32_t y = 0; y < along; ++y) {
        for (std::uint32_t x = 0; x < along; ++x) {
          const GridPlace at{x, y, z};
          out[index_with_fringe(at)] = static_cast<float>(samples.values[index_in_block(at)]);
        }
      }
    }
    if (fringe_ > 0) {
      find_fringe(number, samples, out);
    }
  }
  // In cubes of 27, each from a triangle of the one before. Signs follow row by row.
  void find_samples(std::uint32_t number, BlockSamples& samples) const {
    constexpr std::uint32_t cube = 3, cubes = along / cube;
    static_assert(cubes * cube == along);
    for (std::uint32_t i = 0; i < cubes * cubes * cubes; ++i) {
      const GridPlace first{cube * (i % cubes), cube * (i / cubes % cubes), cube * (i / cubes / cubes)};
      sample_cube<cube>(number, first, samples);
    }
    std::array<Real, samples_of_block>& out = samples.values;
    for (std::uint32_t k = 0; k < along; ++k) {
      for (std::uint32_t j = 0; j < along; ++j) {
        for (std::uint32_t i = 0; i < along; ++i) {
          const std::size_t at = index_in_block({i, j, k});
          out[at] = is_inside(place_in_block(number, {i, j, k}), out[at], out, at, {i, j, k}) ? -out[at] : out[at];
        }
      }
    }
  }
  template <std::uint32_t Side>
  void sample_cube(std::uint32_t number, const GridPlace& first, BlockSamples& samples) const {
    constexpr std::size_t count = Side * Side * Side;
    static_assert(count <= NearestTriangle::most_points);
    std::array<Vec3, count> places;
    std::array<std::size_t, count> indices;
    for (std::uint32_t i = 0; i < count; ++i) {
      const GridPlace at{first.x + i % Side, first.y + i / Side % Side, first.z + i / Side / Side};
      places[i] = place_in_block(number, at);
      indices[i] = index_in_block(at);
    }
    std::array<NearestTriangle::Found, count> found;
    // Triangles of the neighbours that are known, each once.
    std::array<std::uint32_t, count + 1> near{closest_[number]};
    std::size_t near_count = 1;
    const std::array<std::pair<std::uint32_t, std::size_t>, 3> before{
        {{first.x, 1}, {first.y, along}, {first.z, std::size_t{along} * along}}};
    for (std::uint32_t axis = 0, divisor = 1; axis < 3; ++axis, divisor *= Side) {
      for (std::uint32_t i = 0; before[axis].first > 0 && i < count; ++i) {
        if (i / divisor % Side == 0) {
          near[near_count++] = samples.triangles[indices[i] - before[axis].second];
        }
      }
    }
    const std::span<std::uint32_t> known = std::span(near).first(near_count);
    std::ranges::sort(known);
    const auto end = std::unique(known.begin(), known.end());
    tree_.find(places, known.first(static_cast<std::size_t>(end - known.begin())), found);
    for (std::uint32_t i = 0; i < count; ++i) {
      samples.values[indices[i]] = std::sqrt(found[i].squared);
      samples.triangles[indices[i]] = found[i].triangle;
    }
  }
  [[nodiscard]] static std::size_t index_in_block(const GridPlace& at) {
    return (std::size_t{at.z} * along + at.y) * along + at.x;
  }
  // Counts from the first cell of a block; numbers wrap around in the fringe below it, and come back here.
  [[nodiscard]] std::size_t index_with_fringe(const GridPlace& at) const {
    const std::size_t row = SparseBlocks::samples_along(fringe_);
    return ((at.z + fringe_) * row + (at.y + fringe_)) * row + (at.x + fringe_);
  }
  // With the fringe, of one of the blocks that hold some.
  [[nodiscard]] std::span<float> values_of(std::size_t i) {
    const std::size_t each = SparseBlocks::samples_of_block(fringe_);
    return blocks_.values().subspan(i * each, each);
  }
  // Samples beyond the border count as those on it.
  [[nodiscard]] Vec3 place_in_block(std::uint32_t number, const GridPlace& at) const {
    const GridPlace first = blocks_.cells_of(number).first, &all = grid_.samples;
    return place_of(std::min(first.x + at.x, all.x - 1), std::min(first.y + at.y, all.y - 1),
                    std::min(first.z + at.z, all.z - 1));
  }
  // As a neighbour in the block that is known, where no triangle lies between; else by winding.
  [[nodiscard]] bool is_inside(const Vec3& p, Real distance, std::span<const Real> known, std::size_t at,
                               const GridPlace& in_block) const {
    if (!(distance > on_surface * grid_.spacing)) {
      return false;
    }
    const std::array<std::pair<std::uint32_t, std::size_t>, 3> before{
        {{in_block.x, 1}, {in_block.y, along}, {in_block.z, std::size_t{along} * along}}};
    for (const auto& [place, step] : before) {
      if (is_closed_ && place > 0 && std::fabs(known[at - step]) + distance > (1 + on_surface) * grid_.spacing) {
        return known[at - step] < 0;
      }
    }
    return winding_.contains(p);
  }

  // Corners of blocks that hold samples begin with a triangle of such a block.
  void start_corners() {
    corners_.assign(corner_number(0, 0, blocks_.block_counts().z + 1), infinity);
    corner_triangles_.assign(corners_.size(), none);
    for (std::uint32_t number = 0; number < closest_.size(); ++number) {
      if (closest_[number] != none) {
        visit_corners(number, [&](const GridPlace& at) { take_triangle(at, closest_[number]); });
      }
    }
    is_near_.resize(corners_.size());
    std::transform(corner_triangles_.begin(), corner_triangles_.end(), is_near_.begin(),
                   [](std::uint32_t triangle) { return triangle != none ? 1 : 0; });
  }
  template <class Visitor>
  void visit_corners(std::uint32_t number, Visitor&& visit) const {
    const GridPlace at = blocks_.block_at(number);
    for (std::uint32_t bits = 0; bits < 8; ++bits) {
      visit(GridPlace{at.x + (bits & 1u), at.y + (bits >> 1 & 1u), at.z + (bits >> 2)});
    }
  }

  // Hands triangles on from corner to corner, in eight directions, so that each begins with one that is close.
  void spread_to_corners() {
    const GridPlace counts = blocks_.block_counts();
    for (int pass = 0; pass < 8; ++pass) {
      const auto turned = [&](int bit, std::uint32_t at, std::uint32_t last) {
        return pass >> bit & 1 ? last - at : at;
      };
      for (std::uint32_t k = 0; k <= counts.z; ++k) {
        for (std::uint32_t j = 0; j <= counts.y; ++j) {
          for (std::uint32_t i = 0; i <= counts.x; ++i) {
            const std::uint32_t x = turned(0, i, counts.x), y = turned(1, j, counts.y), z = turned(2, k, counts.z);
            if (is_near_[corner_number(x, y, z)] != 0) {
              continue;
            }
            const auto take_from = [&](std::uint32_t from_x, std::uint32_t from_y, std::uint32_t from_z) {
              take_triangle({x, y, z}, corner_triangles_[corner_number(from_x, from_y, from_z)]);
            };
            if (i > 0) {
              take_from(turned(0, i - 1, counts.x), y, z);
            }
            if (j > 0) {
              take_from(x, turned(1, j - 1, counts.y), z);
            }
            if (k > 0) {
              take_from(x, y, turned(2, k - 1, counts.z));
            }
          }
        }
      }
    }
  }
  void take_triangle(const GridPlace& at, std::uint32_t triangle) {
    const std::size_t here = corner_number(at.x, at.y, at.z);
    if (triangle == none || triangle == corner_triangles_[here]) {
      return;
    }
    const Real distance = std::sqrt(squared_distance(corner_place(at.x, at.y, at.z), tree_.triangles()[triangle]));
    if (distance < corners_[here]) {
      corners_[here] = distance;
      corner_triangles_[here] = triangle;
    }
  }

  // The nearest triangles, row by row. Near the surface with a sign: as the corner before, where no triangle lies
  // between, else by winding.
  void find_at_corners() {
    const GridPlace counts = blocks_.block_counts();
    Workers(0).for_each(std::size_t{counts.y + 1} * (counts.z + 1), [&](std::size_t row) {
      const auto y = static_cast<std::uint32_t>(row % (counts.y + 1)),
                 z = static_cast<std::uint32_t>(row / (counts.y + 1));
      for (std::uint32_t x = 0; x <= counts.x; ++x) {
        const std::size_t here = corner_number(x, y, z);
        const std::array<Vec3, 1> place{corner_place(x, y, z)};
        const std::array<std::uint32_t, 1> close{corner_triangles_[here]};
        std::array<NearestTriangle::Found, 1> found;
        tree_.find(place, close, found);
        const Real distance = std::sqrt(found[0].squared);
        corners_[here] = distance;
        corner_triangles_[here] = found[0].triangle;
        if (is_near_[here] != 0 && distance > on_surface * grid_.spacing) {
          const Real apart = (1 + on_surface) * SparseBlocks::side * grid_.spacing;
          const bool is_like =
              is_closed_ && x > 0 && is_near_[here - 1] != 0 && std::fabs(corners_[here - 1]) + distance > apart;
          const bool is_inside = is_like ? corners_[here - 1] < 0 : winding_.contains(place[0]);
          corners_[here] = is_inside ? -distance : distance;
        }
      }
    });
  }

  // Beside a corner of no block that holds samples there are only blocks without triangles.
  void sign_corners() {
    const GridPlace counts = blocks_.block_counts();
    for (std::uint32_t z = 0; z <= counts.z; ++z) {
      for (std::uint32_t y = 0; y <= counts.y; ++y) {
        for (std::uint32_t x = 0; x <= counts.x; ++x) {
          const std::size_t here = corner_number(x, y, z);
          if (is_near_[here] != 0) {
            continue;
          }
          const std::size_t before = x > 0   ? corner_number(x - 1, y, z)
                                     : y > 0 ? corner_number(x, y - 1, z)
                                     : z > 0 ? corner_number(x, y, z - 1)
                                             : here;
          const bool is_inside =
              is_closed_ && before != here ? corners_[before] < 0 : winding_.contains(corner_place(x, y, z));
          corners_[here] = is_inside ? -corners_[here] : corners_[here];
        }
      }
    }
  }

  // Around gaps the winding passes one half where no triangle is near: such blocks get samples, too.
  void hold_blocks() {
    for (std::uint32_t number = 0; number < closest_.size(); ++number) {
      if (closest_[number] == none) {
        int inside = 0;
        std::uint32_t triangle = none;
        visit_corners(number, [&](const GridPlace& at) {
          const std::size_t corner = corner_number(at.x, at.y, at.z);
          inside += corners_[corner] < 0 ? 1 : 0;
          triangle = corner_triangles_[corner];
        });
        closest_[number] = inside % 8 != 0 ? triangle : none;
      }
      if (closest_[number] != none) {
        held_.push_back(number);
      }
    }
    blocks_.hold(held_);
    std::transform(corners_.begin(), corners_.end(), blocks_.corners().begin(),
                   [](Real value) { return static_cast<float>(value); });
  }

  // Calls visit(index, in_block, sample) for samples of the fringe that lie in the grid. `in_block` is the one next to
  // it in the block.
  template <class Visitor>
  void visit_fringe(std::uint32_t number, Visitor&& visit) const {
    const GridPlace first = blocks_.cells_of(number).first, &all = grid_.samples;
    // One more than the number of the sample.
    const auto is_beyond = [](std::uint32_t sample, std::uint32_t samples) { return sample == 0 || sample > samples; };
    const auto inward = [](std::uint32_t in_fringe) { return std::clamp(in_fringe, 1u, along) - 1; };
    constexpr std::uint32_t wide = SparseBlocks::samples_along(1);
    for (std::uint32_t k = 0; k < wide; ++k) {
      for (std::uint32_t j = 0; j < wide; ++j) {
        for (std::uint32_t i = 0; i < wide; ++i) {
          const GridPlace in_block{inward(i), inward(j), inward(k)}, next{first.x + i, first.y + j, first.z + k};
          const bool is_inner = in_block.x + 1 == i && in_block.y + 1 == j && in_block.z + 1 == k;
          if (!is_inner && !is_beyond(next.x, all.x) && !is_beyond(next.y, all.y) && !is_beyond(next.z, all.z)) {
            visit((std::size_t{k} * wide + j) * wide + i, in_block, GridPlace{next.x - 1, next.y - 1, next.z - 1});
          }
        }
      }
    }
  }
  // The block without its fringe that holds a sample, or none.
  [[nodiscard]] std::uint32_t holder_of(const GridPlace& sample) const {
    std::uint32_t found = none;
    blocks_.visit_blocks({sample, {1, 1, 1}}, [&](std::uint32_t number) {
      found = found == none && blocks_.blocks()[number].place != SparseBlocks::no_samples ? number : found;
    });
    return found;
  }
  // Samples of the fringe that a neighbour holds are copied from there, once all are known.
  void copy_fringe(std::size_t at) {
    const std::span<float> out = values_of(at);
    visit_fringe(held_[at], [&](std::size_t here, const GridPlace& /*in_block*/, const GridPlace& sample) {
      if (const std::uint32_t holder = holder_of(sample); holder != none) {
        const GridPlace first = blocks_.cells_of(holder).first;
        out[here] =
            values_of(blocks_.blocks()[holder]
                          .place)[index_with_fringe({sample.x - first.x, sample.y - first.y, sample.z - first.z})];
      }
    });
  }
  // The others are found from the nearest ones in the block.
  void find_fringe(std::uint32_t number, const BlockSamples& samples, std::span<float> out) const {
    FringeBatch batch;
    visit_fringe(number, [&](std::size_t here, const GridPlace& in_block, const GridPlace& sample) {
      if (holder_of(sample) != none) {
        return;
      }
      batch.places[batch.count] = place_of(sample.x, sample.y, sample.z);
      batch.into[batch.count] = here;
      batch.near[batch.count] = index_in_block(in_block);
      if (++batch.count == batch.places.size()) {
        find_batch(batch, samples, out);
        batch = {};
      }
    });
    find_batch(batch, samples, out);
  }
  struct FringeBatch {
    std::size_t count = 0;
    std::array<Vec3, 16> places{};
    std::array<std::size_t, 16> into{}, near{};  // near: a sample in the block
  };
  void find_batch(const FringeBatch& batch, const BlockSamples& samples, std::span<float> out) const {
    if (batch.count == 0) {
      return;
    }
    std::array<std::uint32_t, 16> near{};
    std::array<NearestTriangle::Found, 16> found{};
    for (std::size_t i = 0; i < batch.count; ++i) {
      near[i] = samples.triangles[batch.near[i]];
    }
    const std::span<std::uint32_t> known = std::span(near).first(batch.count);
    std::ranges::sort(known);
    const auto end = std::unique(known.begin(), known.end());
    tree_.find(std::span(batch.places).first(batch.count), known.first(static_cast<std::size_t>(end - known.begin())),
               std::span(found).first(batch.count));
    for (std::size_t i = 0; i < batch.count; ++i) {
      const Real distance = std::sqrt(found[i].squared), neighbour = samples.values[batch.near[i]];
      // A neighbour is one cell away along each axis at most.
      const Real apart = std::sqrt(Real{3}) * (1 + on_surface) * grid_.spacing;
      const bool is_like = is_closed_ && std::fabs(neighbour) + distance > apart;
      const bool is_in =
          distance > on_surface * grid_.spacing && (is_like ? neighbour < 0 : winding_.contains(batch.places[i]));
      out[batch.into[i]] = static_cast<float>(is_in ? -distance : distance);
    }
  }

  static constexpr Real on_surface = 1e-7;  // of a cell: such points count as on the surface
  FieldGrid grid_;
  std::uint32_t fringe_;
  SparseBlocks blocks_;
  NearestTriangle tree_;
  WindingNumber winding_;
  bool is_closed_;
  std::vector<std::uint32_t> closest_, held_;  // a triangle for each block that holds samples, and their numbers
  std::vector<Real> corners_;
  std::vector<std::uint32_t> corner_triangles_;
  std::vector<std::uint8_t> is_near_;  // corners of blocks near the surface
};

}  // namespace

SparseBlocks sample_distances(const SurfaceTriangles& surface, const FieldGrid& grid, Real band, std::uint32_t fringe) {
  return MeshSampler(surface, grid, fringe).sample(band);
}

}  // namespace abut
