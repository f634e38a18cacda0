// SPDX-License-Identifier: Apache-2.0
module abut.shapes.distance_field;
import abut.capability;
import abut.capability.grid_checks;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.distance_field.lattice;
import abut.trees.samples.sparse_blocks;

namespace abut {
namespace {

constexpr Real least_spacing = 1e-30;

Fault check_spacing(std::string_view name, Real value, Real samples) {
  if (Fault fault = check_positive(name, value)) {
    return fault;
  }
  if (value < least_spacing) {
    return error_about(Errc::out_of_range, name, value, "at least 1e-30");
  }
  if (value > largest_coordinate / samples) {
    return error_about(Errc::out_of_range, name, value, "at most 1e70 divided by the number of samples");
  }
  return std::nullopt;
}

Fault check_parameters(std::span<const std::string_view> names, std::span<const Real> parameters) {
  // Some came later: the interpolation, and then a lattice.
  if (parameters.size() != names.size() - 4 && parameters.size() != names.size() - 3) {
    if (Fault fault = check_count("parameter_count", parameters.size(), names.size())) {
      return fault;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (Fault fault = check_samples(names[i], parameters[i])) {
      return fault;
    }
    if (Fault fault = check_spacing(names[i + 3], parameters[i + 3], parameters[i])) {
      return fault;
    }
    if (Fault fault = check_finite(names[i + 6], parameters[i + 6])) {
      return fault;
    }
  }
  if (parameters[9] != 0 && parameters[9] != 1) {
    return error_about(Errc::unknown_value, names[9], parameters[9], "0 (a solid) or 1 (a container)");
  }
  if (parameters.size() > 10 && parameters[10] != 0 && parameters[10] != 1) {
    return error_about(Errc::unknown_value, names[10], parameters[10], "0 (linear) or 1 (quadratic)");
  }
  if (parameters.size() > 11) {
    for (std::size_t i = 11; i < 14; ++i) {
      if (!(parameters[i] >= 0 && parameters[i] <= FieldLattice::most_along) ||
          parameters[i] != std::floor(parameters[i])) {
        return error_about(Errc::out_of_range, names[i], parameters[i], "0, or a whole number from 2 to 64");
      }
    }
  }
  if (parameters[0] * parameters[1] * parameters[2] >= no_index) {
    return Error{Errc::size_overflow, "a distance field has at most 2^32 - 2 samples"};
  }
  return std::nullopt;
}

// In rising order, so that each is there once.
Fault check_held(std::span<const std::uint32_t> indices, std::size_t blocks) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= blocks) {
      return error_about(Errc::index_out_of_range, "indices[" + std::to_string(i) + "]", std::uint64_t{indices[i]},
                         "below the number of blocks, which is " + std::to_string(blocks));
    }
    if (i > 0 && indices[i] <= indices[i - 1]) {
      return error_about(Errc::invalid_argument, "indices[" + std::to_string(i) + "]", std::uint64_t{indices[i]},
                         "greater than the one before");
    }
  }
  return std::nullopt;
}

// In cells.
Aabb box_of(const GridPlace& first, const GridPlace& count) {
  const Vec3 low{static_cast<Real>(first.x), static_cast<Real>(first.y), static_cast<Real>(first.z)};
  return {low, low + Vec3{static_cast<Real>(count.x), static_cast<Real>(count.y), static_cast<Real>(count.z)}};
}

std::size_t block_count(std::span<const Real> parameters, std::uint32_t more) {
  std::size_t count = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    count *= (static_cast<std::size_t>(parameters[i]) - 2) / SparseBlocks::side + 1 + more;
  }
  return count;
}

}  // namespace

std::vector<Real> DistanceField::parameters() const {
  const Data& field = *data_;
  const GridPlace& samples = field.blocks.samples();
  const auto along = [&](std::uint32_t GridPlace::* axis) {
    return field.lattice ? static_cast<Real>(field.lattice->counts().*axis) : 0;
  };
  return {static_cast<Real>(samples.x),
          static_cast<Real>(samples.y),
          static_cast<Real>(samples.z),
          field.spacing.x,
          field.spacing.y,
          field.spacing.z,
          field.origin.x,
          field.origin.y,
          field.origin.z,
          field.is_inside_out ? 1.0 : 0.0,
          field.is_smooth ? 1.0 : 0.0,
          along(&GridPlace::x),
          along(&GridPlace::y),
          along(&GridPlace::z)};
}

Buffers DistanceField::buffers() const {
  const SparseBlocks& blocks = data_->blocks;
  Buffers out;
  if (!blocks.is_sparse()) {
    const GridPlace& samples = blocks.samples();
    for (std::uint32_t k = 0; k < samples.z; ++k) {
      for (std::uint32_t j = 0; j < samples.y; ++j) {
        for (std::uint32_t i = 0; i < samples.x; ++i) {
          out.reals.push_back(blocks.sample({i, j, k}));
        }
      }
    }
  } else {
    out.reals.insert(out.reals.end(), blocks.corners().begin(), blocks.corners().end());
    out.reals.insert(out.reals.end(), blocks.values().begin(), blocks.values().end());
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
      if (blocks.blocks()[i].place != SparseBlocks::no_samples) {
        out.indices.push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
  if (data_->lattice) {
    for (const Vec3& point : data_->lattice->points()) {
      out.reals.insert(out.reals.end(), {point.x, point.y, point.z});
    }
  }
  return out;
}

// No solid reaches out of the grid.
Real DistanceField::limited(const Data& data, const GridPlace& sample, Real value) {
  const auto to_border = [](std::uint32_t at, std::uint32_t all, Real spacing) {
    return std::min(at, all - 1 - at) * spacing;
  };
  const GridPlace& all = data.blocks.samples();
  const Real depth = std::min({to_border(sample.x, all.x, data.spacing.x), to_border(sample.y, all.y, data.spacing.y),
                               to_border(sample.z, all.z, data.spacing.z)});
  return std::max(value, -depth);
}

Result<DistanceField> DistanceField::make(std::span<const Real> parameters, std::span<const Real> reals,
                                          std::span<const std::uint32_t> indices) {
  if (Fault fault = check_parameters(parameter_names, parameters)) {
    return *fault;
  }
  const auto count = [&](std::size_t i) { return static_cast<std::uint32_t>(parameters[i]); };
  const GridPlace samples{count(0), count(1), count(2)};
  if (reals.empty()) {
    return Error{Errc::empty, "values is empty; a distance field needs columns * rows * layers of them"};
  }
  const std::size_t blocks = block_count(parameters, 0);
  const bool is_smooth = parameters.size() > 10 && parameters[10] == 1;
  const GridPlace points = parameters.size() > 11 ? GridPlace{count(11), count(12), count(13)} : GridPlace{0, 0, 0};
  const std::size_t lattice_reals = std::size_t{3} * points.x * points.y * points.z;
  const std::size_t expected =
      indices.empty() ? std::size_t{samples.x} * samples.y * samples.z
                      : block_count(parameters, 1) + indices.size() * SparseBlocks::samples_of_block(is_smooth ? 1 : 0);
  if (Fault fault = check_count("real_count", reals.size(), expected + lattice_reals)) {
    return *fault;
  }
  const std::span<const Real> xyz = reals.subspan(expected);
  reals = reals.first(expected);
  if (Fault fault = check_held(indices, blocks)) {
    return *fault;
  }
  if (Fault fault = check_field_values(reals)) {
    return *fault;
  }
  std::vector<std::uint32_t> held(indices.begin(), indices.end());
  if (held.empty()) {
    held.resize(blocks);
    std::iota(held.begin(), held.end(), 0u);
  }
  Data data = data_of(parameters,
                      SparseBlocks(samples, {parameters[3], parameters[4], parameters[5]}, held, is_smooth ? 1 : 0));
  if (indices.empty()) {
    data.blocks.set({{0, 0, 0}, samples}, [&](const GridPlace& at) {
      return limited(data, at, reals[(std::size_t{at.z} * samples.y + at.y) * samples.x + at.x]);
    });
  } else {
    const auto as_single = [](Real value) { return static_cast<float>(value); };
    const std::span<float> corners = data.blocks.corners(), values = data.blocks.values();
    std::transform(reals.begin(), reals.begin() + std::ssize(corners), corners.begin(), as_single);
    std::transform(reals.begin() + std::ssize(corners), reals.end(), values.begin(), as_single);
  }
  Result<std::optional<FieldLattice>> lattice = lattice_over(data, points, xyz);
  if (!lattice) {
    return lattice.error();
  }
  bend(data, std::move(lattice).value());
  return measured(std::move(data));
}

Result<DistanceField> DistanceField::make(std::span<const Real> parameters, SparseBlocks blocks) {
  if (Fault fault = check_parameters(parameter_names, parameters)) {
    return *fault;
  }
  return measured(data_of(parameters, std::move(blocks)));
}

DistanceField::Data DistanceField::data_of(std::span<const Real> parameters, SparseBlocks blocks) {
  const Vec3 spacing{parameters[3], parameters[4], parameters[5]};
  const bool is_smooth = parameters.size() > 10 && parameters[10] == 1;
  return {std::move(blocks),
          spacing,
          {1 / spacing.x, 1 / spacing.y, 1 / spacing.z},
          {parameters[6], parameters[7], parameters[8]},
          {parameters[0] - 1, parameters[1] - 1, parameters[2] - 1},
          parameters[9] == 1,
          is_smooth};
}

Result<DistanceField> DistanceField::measured(Data data) {
  measure(data, {{0, 0, 0}, data.blocks.samples()});
  const auto is_crossed = [](const SparseBlocks::Block& block) {
    return block.place == SparseBlocks::no_samples && block.low <= 0 && block.high >= 0;
  };
  if (std::ranges::any_of(data.blocks.blocks(), is_crossed)) {
    return Error{Errc::invalid_argument, "values change sign in a block that holds no samples"};
  }
  return DistanceField(std::move(data));
}

void DistanceField::measure(Data& data, const GridBox& changed) {
  data.blocks.measure(changed);
  const std::span<const SparseBlocks::Block> blocks = data.blocks.blocks();
  data.steepest = 1;
  for (const SparseBlocks::Block& block : blocks) {
    data.steepest = std::max(data.steepest, static_cast<Real>(block.steepest));
  }
  // Between samples of a distance values are off by half the diagonal of a cell at most. Between the corners of a block
  // it is half the diagonal of the block.
  const Real diagonal = norm(data.spacing);
  data.slack = data.blocks.is_sparse() ? 0.5 * (SparseBlocks::side + 1) * diagonal : 0;
  // Where space shrinks, values change faster.
  data.steepest /= data.least_stretch;
  data.ways = DistanceFieldWays(blocks);
  data.rim = data.lattice && data.blocks.is_sparse() ? data.blocks.least_beside_empty() : infinity;
  measure_solid(data);
  data.surface.forget();
}

// Around all cells with a value that is not positive; blocks that lie within what is known are left out.
void DistanceField::measure_solid(Data& data) {
  Aabb in_cells = Aabb::empty();
  const std::span<const SparseBlocks::Block> blocks = data.blocks.blocks();
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const GridBox cells = data.blocks.cells_of(number);
    const Aabb around = box_of(cells.first, cells.count);
    if (blocks[number].low > 0 ||
        (minimum(in_cells.low, around.low) == in_cells.low && maximum(in_cells.high, around.high) == in_cells.high)) {
      continue;
    }
    if (blocks[number].place == SparseBlocks::no_samples) {
      in_cells.include(around);
    } else {
      in_cells.include(data.is_smooth ? smooth_solid_in_cells(data, number) : solid_in_cells(data, number));
    }
  }
  // A field without a solid has the box of its grid.
  if (!in_cells.is_bounded()) {
    in_cells = {{0, 0, 0}, data.last};
  }
  const auto placed = [&](const Vec3& at) {
    return data.origin + Vec3{at.x * data.spacing.x, at.y * data.spacing.y, at.z * data.spacing.z};
  };
  data.solid = {placed(in_cells.low), placed(in_cells.high)};
  if (data.lattice) {
    data.solid = data.lattice->bent_box(data.solid);
  }
}

// Of a block that holds samples.
Aabb DistanceField::solid_in_cells(const Data& data, std::uint32_t number) {
  const SparseBlocks::Block& block = data.blocks.blocks()[number];
  const GridBox cells = data.blocks.cells_of(number);
  Aabb out = Aabb::empty();
  for (std::uint32_t k = 0; k < cells.count.z; ++k) {
    for (std::uint32_t j = 0; j < cells.count.y; ++j) {
      for (std::uint32_t i = 0; i < cells.count.x; ++i) {
        const CellCorners corners = data.blocks.corners_of_cell(block, {i, j, k});
        if (std::ranges::any_of(corners, [](float value) { return value <= 0; })) {
          out.include(box_of({cells.first.x + i, cells.first.y + j, cells.first.z + k}, {1, 1, 1}));
        }
      }
    }
  }
  return out;
}

// A solid s in the grid and the point c of the grid nearest to a point p: |p - s|^2 >= |p - c|^2 + |c - s|^2.
FieldValue DistanceField::beyond(const Vec3& p, const Vec3& in_grid, const FieldValue& on_border) const {
  const Data& field = *data_;
  const auto past = [](Real value, Real at, Real last, Real spacing) {
    return at == 0 ? std::min(value, Real{0}) : at == last ? std::max(value - last * spacing, Real{0}) : Real{0};
  };
  const Vec3 away{past(p.x, in_grid.x, field.last.x, field.spacing.x),
                  past(p.y, in_grid.y, field.last.y, field.spacing.y),
                  past(p.z, in_grid.z, field.last.z, field.spacing.z)};
  const Real value = std::max(on_border.value, Real{0}), far = norm(away), whole = std::hypot(far, value);
  if (!(whole > 0)) {
    return on_border;
  }
  const Vec3& slope = on_border.gradient;
  const Vec3 along{away.x == 0 ? slope.x : 0, away.y == 0 ? slope.y : 0, away.z == 0 ? slope.z : 0};
  return {whole, (1 / whole) * (away + value * along)};
}

std::vector<DistanceField> DistanceField::samples() {
  // A ball of radius 0.8, a container around it, a box with unlike cells, and one of continuous gradient.
  const auto ball = std::to_array<Real>({12, 12, 12, 0.2, 0.2, 0.2, -1.1, -1.1, -1.1, 0});
  const auto slab = std::to_array<Real>({10, 7, 5, 0.2, 0.3, 0.25, -0.9, -0.9, -0.5, 0});
  const auto smooth = std::to_array<Real>({11, 12, 13, 0.2, 0.15, 0.12, -1, -0.825, -0.72, 0, 1});
  std::array<Real, 10> container = ball;
  container[9] = 1;
  const auto filled = [](std::span<const Real> parameters, auto&& value_of) {
    std::vector<Real> values;
    for (Real k = 0; k < parameters[2]; ++k) {
      for (Real j = 0; j < parameters[1]; ++j) {
        for (Real i = 0; i < parameters[0]; ++i) {
          values.push_back(value_of({parameters[6] + i * parameters[3], parameters[7] + j * parameters[4],
                                     parameters[8] + k * parameters[5]}));
        }
      }
    }
    return values;
  };
  const auto of_ball = [](const Vec3& p) { return norm(p) - 0.8; };
  const auto of_slab = [](const Vec3& p) {
    const Vec3 out = absolute(p) - Vec3{0.6, 0.5, 0.2};
    return norm(maximum(out, Vec3{0, 0, 0})) + std::min(std::max({out.x, out.y, out.z}), Real{0});
  };
  const std::vector<Real> round = filled(ball, of_ball);
  return {make(ball, round, {}).value(), make(container, round, {}).value(),
          make(slab, filled(slab, of_slab), {}).value(), make(smooth, filled(smooth, of_slab), {}).value()};
}

}  // namespace abut
