// SPDX-License-Identifier: Apache-2.0
// Distance fields that a lattice bends: places are taken back to where they are at rest.
module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.distance_field.lattice;
import abut.trees.volumes.ray_slabs;
import abut.trees.samples.sparse_blocks;

namespace abut {

Result<std::optional<FieldLattice>> DistanceField::lattice_over(const Data& data, const GridPlace& counts,
                                                                std::span<const Real> xyz) {
  using Answer = std::optional<FieldLattice>;
  if (counts == GridPlace{0, 0, 0}) {
    return Answer();
  }
  const auto is_wrong = [](std::uint32_t count) { return count < 2 || count > FieldLattice::most_along; };
  for (const auto& [which, count] :
       {std::pair("columns", counts.x), std::pair("rows", counts.y), std::pair("layers", counts.z)}) {
    if (is_wrong(count)) {
      return error_about(Errc::out_of_range, which, std::uint64_t{count}, "from 2 to 64, or 0 as all of them");
    }
  }
  std::vector<Vec3> points(xyz.size() / 3);
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    if (!(std::fabs(xyz[i]) <= largest_coordinate)) {
      const std::string which = "xyz[" + std::to_string(i) + "]";
      const Fault fault = check_finite(which, xyz[i]);
      return fault ? *fault : error_about(Errc::out_of_range, which, xyz[i], "at most 1e70 in magnitude");
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
  }
  const Vec3 size{data.last.x * data.spacing.x, data.last.y * data.spacing.y, data.last.z * data.spacing.z};
  FieldLattice lattice(counts, {data.origin, data.origin + size}, std::move(points));
  if (lattice.is_at_rest()) {
    return Answer();
  }
  if (!lattice.is_sound()) {
    return Error{
        Errc::out_of_range,
        "xyz bends space too much: edges must not turn by 90 degrees from the average, nor shrink to a fiftieth"};
  }
  return Answer(std::move(lattice));
}

void DistanceField::bend(Data& data, std::optional<FieldLattice> lattice) {
  data.least_stretch = lattice ? lattice->least_stretch() : 1;
  data.most_stretch = lattice ? lattice->most_stretch() : 1;
  data.lattice = std::move(lattice);
}

Fault DistanceField::check(const LatticeEdit& edit) const {
  const auto made = lattice_over(*data_, {edit.columns, edit.rows, edit.layers}, edit.xyz);
  return made ? std::nullopt : Fault(made.error());
}

Aabb DistanceField::apply(const LatticeEdit& edit) {
  Data& field = data_.own();
  bend(field, lattice_over(field, {edit.columns, edit.rows, edit.layers}, edit.xyz).value());
  measure(field, {{0, 0, 0}, {1, 1, 1}});
  return Aabb::everything();
}

FieldValue DistanceField::bent_value_at(const Vec3& point) const {
  const FieldLattice::Unbent back = data_->lattice->unbent(point);
  const FieldValue found = value_at_rest(back.at_rest);
  return {found.value, back.slope.inverse().transposed(found.gradient)};
}

void DistanceField::bend_points(SurfacePoints& points) const {
  for (Vec3& point : points.points) {
    point = data_->lattice->bent(point).place;
  }
  for (Vec3& point : points.doubtful) {
    point = data_->lattice->bent(point).place;
  }
  for (SurfacePoints::Run& run : points.runs) {
    run.box = Aabb::empty();
    for (const Vec3& point : std::span(points.points).subspan(run.first, run.count)) {
      run.box.include(point);
    }
  }
}

// A ray is no straight line at rest. It goes on by as much as the value proves, and by a thousandth of a cell at least.
std::optional<RayHit> DistanceField::cast_bent_ray(const Vec3& origin, const UnitVec3& direction,
                                                   Real max_distance) const {
  constexpr Real least_share = 1e-3;
  constexpr int most_halvings = 60;
  const Data& field = *data_;
  const Aabb around = field.solid.inflated(finest());
  const Vec3 d = direction;
  const RaySlabs::Stretch over = RaySlabs(origin, d, around).within(around, {0, max_distance});
  if (over.is_empty()) {
    return std::nullopt;
  }
  const auto value_on_way = [&](Real way) { return value_at(origin + way * d).value; };
  const auto hit_at = [&](Real way) {
    const Vec3 place = origin + way * d;
    const Vec3 at_rest = field.lattice->unbent(place).at_rest - field.origin;
    const auto cell = [](Real at, Real last) {
      return static_cast<std::uint32_t>(at > 0 ? std::min(at, last - 1) : 0);
    };
    const GridPlace in_grid{cell(at_rest.x * field.inverse.x, field.last.x),
                            cell(at_rest.y * field.inverse.y, field.last.y),
                            cell(at_rest.z * field.inverse.z, field.last.z)};
    return RayHit{
        way, UnitVec3::make(value_at(place).gradient).value_or(-direction), {FeatureKind::cell, cell_number(in_grid)}};
  };
  const auto sure_way = [&](Real value) {
    const Real turned = field.is_inside_out ? -value : value, nearest = std::min(std::fabs(turned), field.rim);
    return field.least_stretch * field.ways.least(turned < 0 ? -nearest : nearest, 0);
  };
  Real way = over.enter, value = value_on_way(way);
  while (way < over.leave) {
    if (value == 0) {
      return hit_at(way);
    }
    const Real next = std::min(way + std::max(sure_way(value), least_share * finest()), over.leave);
    const Real there = value_on_way(next);
    if ((there < 0) != (value < 0)) {
      Real low = way, high = next;
      for (int i = 0; i < most_halvings; ++i) {
        const Real middle = 0.5 * (low + high);
        ((value_on_way(middle) < 0) == (value < 0) ? low : high) = middle;
      }
      return hit_at(high);
    }
    way = next;
    value = there;
  }
  return std::nullopt;
}

// Of what grows by no more than its way: half the diagonal between samples, and how they are rounded.
Real DistanceField::near_error() const {
  Real largest = 0;
  for (const SparseBlocks::Block& block : data_->blocks.blocks()) {
    if (block.place != SparseBlocks::no_samples) {
      largest = std::max({largest, std::fabs(static_cast<Real>(block.low)), std::fabs(static_cast<Real>(block.high))});
    }
  }
  constexpr Real rounding = 0.5 * static_cast<Real>(std::numeric_limits<float>::epsilon());
  return 0.5 * norm(data_->spacing) + rounding * largest;
}

Real DistanceField::far_error() const {
  if (!data_->blocks.is_sparse()) {
    return 0;
  }
  Real largest = 0;
  for (const float value : data_->blocks.corners()) {
    largest = std::max(largest, std::fabs(static_cast<Real>(value)));
  }
  constexpr Real rounding = 0.5 * static_cast<Real>(std::numeric_limits<float>::epsilon());
  return 0.5 * SparseBlocks::side * norm(data_->spacing) + rounding * largest;
}

}  // namespace abut
