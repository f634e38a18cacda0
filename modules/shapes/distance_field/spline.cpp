// SPDX-License-Identifier: Apache-2.0
// Where the surface of a field with tri-quadratic values may be. A cell may have some of it while all its corners lie
// on one side. Bernstein coefficients tell where that cannot be, and boxes are halved where they leave it open.
module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.samples.sparse_blocks;

namespace abut {
namespace {

Vec3 position_of(const GridPlace& sample) {
  return {static_cast<Real>(sample.x), static_cast<Real>(sample.y), static_cast<Real>(sample.z)};
}

bool has_both_signs(const SamplesAround& samples) {
  const auto inside = std::ranges::count_if(samples, [](float value) { return value < 0; });
  return inside > 0 && inside < std::ssize(samples);
}

// A search for points on both sides of the surface in a patch.
struct SignSearch {
  std::optional<std::pair<Vec3, Vec3>> ends{};  // inside and outside
  bool is_doubtful = false;

  void look(const SplinePatch& patch, const Vec3& low, const Vec3& high, int cuts) {
    if (ends || !patch.has_both_signs()) {
      return;
    }
    std::optional<Vec3> inside, outside;
    for (std::size_t bits = 0; bits < 8; ++bits) {
      (patch.corner(bits) < 0 ? inside : outside) =
          Vec3{bits & 1 ? high.x : low.x, bits & 2 ? high.y : low.y, bits & 4 ? high.z : low.z};
    }
    if (inside && outside) {
      ends.emplace(*inside, *outside);
      return;
    }
    if (cuts == 0) {
      is_doubtful = true;
      return;
    }
    const Vec3 middle = 0.5 * (low + high);
    for (int bits = 0; bits < 8; ++bits) {
      const bool x = (bits & 1) != 0, y = (bits & 2) != 0, z = (bits & 4) != 0;
      const SplinePatch piece = patch.half(0, x).half(1, y).half(2, z);
      look(piece, {x ? middle.x : low.x, y ? middle.y : low.y, z ? middle.z : low.z},
           {x ? high.x : middle.x, y ? high.y : middle.y, z ? high.z : middle.z}, cuts - 1);
    }
  }
};

}  // namespace

// At all corners of some cells. Single numbers, so that signs are the same wherever they are asked for.
std::vector<float> DistanceField::corner_values(const GridBox& cells) const {
  std::vector<float> out;
  for (std::uint32_t k = 0; k <= cells.count.z; ++k) {
    for (std::uint32_t j = 0; j <= cells.count.y; ++j) {
      for (std::uint32_t i = 0; i <= cells.count.x; ++i) {
        out.push_back(corner_value({cells.first.x + i, cells.first.y + j, cells.first.z + k}));
      }
    }
  }
  return out;
}

float DistanceField::corner_value(const GridPlace& sample) const {
  return static_cast<float>(interpolated(position_of(sample)).value);
}

// By halving.
Vec3 DistanceField::zero_between(const Vec3& inside, const Vec3& outside) const {
  constexpr int most_steps = 60;
  Vec3 in = inside, out = outside;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 middle = 0.5 * (in + out);
    (interpolated(middle).value < 0 ? in : out) = middle;
  }
  return out;
}

// A point of the surface in a cell whose corners are all on one side.
bool DistanceField::add_uncrossed(const SparseBlocks::Block& block, const GridPlace& in_block, const GridPlace& place,
                                  SurfacePoints& out) const {
  constexpr int most_cuts = 4;
  const SparseBlocks& blocks = data_->blocks;
  SignSearch search;
  for (std::uint32_t bits = 0; bits < 8 && !search.ends; ++bits) {
    const std::uint32_t x = bits & 1u, y = bits >> 1 & 1u, z = bits >> 2;
    const SamplesAround around = blocks.samples_around(block, {in_block.x + x, in_block.y + y, in_block.z + z});
    if (!has_both_signs(around)) {
      continue;
    }
    // The eighth of the cell at this corner.
    const GridPlace sample{place.x + x, place.y + y, place.z + z};
    const Vec3 low{-0.5 * x, -0.5 * y, -0.5 * z}, high = low + Vec3{0.5, 0.5, 0.5};
    search.look(SplinePatch::make(around, blocks.ends_at(sample), low, high), position_of(sample) + low,
                position_of(sample) + high, most_cuts);
  }
  if (search.ends) {
    out.points.push_back(placed(zero_between(search.ends->first, search.ends->second)));
    out.cells.push_back(cell_number(place));
  } else if (search.is_doubtful) {
    out.doubtful.push_back(placed(position_of(place) + Vec3{0.5, 0.5, 0.5}));
  }
  return search.ends.has_value();
}

// Of a block that holds samples, around the parts of samples in which a value may not be positive.
Aabb DistanceField::smooth_solid_in_cells(const Data& data, std::uint32_t number) {
  const SparseBlocks::Block& block = data.blocks.blocks()[number];
  const GridBox cells = data.blocks.cells_of(number);
  Aabb out = Aabb::empty();
  for (std::uint32_t k = 0; k <= cells.count.z; ++k) {
    for (std::uint32_t j = 0; j <= cells.count.y; ++j) {
      for (std::uint32_t i = 0; i <= cells.count.x; ++i) {
        const SamplesAround around = data.blocks.samples_around(block, {i, j, k});
        if (std::ranges::none_of(around, [](float value) { return value <= 0; })) {
          continue;
        }
        const GridPlace sample{cells.first.x + i, cells.first.y + j, cells.first.z + k};
        const Vec3 low{i == 0 ? 0 : -0.5, j == 0 ? 0 : -0.5, k == 0 ? 0 : -0.5},
            high{i == cells.count.x ? 0 : 0.5, j == cells.count.y ? 0 : 0.5, k == cells.count.z ? 0 : 0.5};
        if (SplinePatch::make(around, data.blocks.ends_at(sample), low, high).least() <= 0) {
          out.include(Aabb{position_of(sample) + low, position_of(sample) + high});
        }
      }
    }
  }
  return out;
}

}  // namespace abut
