// SPDX-License-Identifier: Apache-2.0
module abut.shapes.particles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.grids.particle_grid;

namespace abut {

Result<Particles> Particles::make(std::span<const Real> parameters, std::span<const Real> reals,
                                  std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), 1)) {
    return *fault;
  }
  if (Fault fault = check_count("index_count", indices.size(), 0)) {
    return *fault;
  }
  if (Fault fault = check_not_negative("radius", parameters[0])) {
    return *fault;
  }
  const std::size_t stride = parameters[0] > 0 ? 3 : 4;
  if (reals.empty()) {
    return Error{Errc::empty, "count is 0; particles need at least one"};
  }
  if (reals.size() % stride != 0) {
    return error_about(Errc::invalid_argument, "real_count", static_cast<std::uint64_t>(reals.size()),
                       stride == 3 ? "a multiple of 3" : "a multiple of 4, since radius is 0");
  }
  if (reals.size() / stride >= no_index) {
    return Error{Errc::size_overflow, "there are at most 2^32 - 2 particles in a shape"};
  }
  if (Fault fault = check_all_finite("xyz", reals)) {
    return *fault;
  }
  const std::size_t count = reals.size() / stride;
  Data data{{}, {}, parameters[0], parameters[0], Aabb::empty(), {}};
  data.places.reserve(count);
  data.radii.reserve(stride == 4 ? count : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const Real> numbers = reals.subspan(stride * i, stride);
    data.places.push_back({numbers[0], numbers[1], numbers[2]});
    if (stride == 4) {
      if (Fault fault = check_not_negative("xyz[" + std::to_string(4 * i + 3) + "]", numbers[3])) {
        return *fault;
      }
      data.radii.push_back(numbers[3]);
    }
  }
  measure(data);
  return Particles(std::move(data));
}

void Particles::measure(Data& data) {
  data.centres = Aabb::empty();
  for (const Vec3& place : data.places) {
    data.centres.include(place);
  }
  data.largest_radius = data.common_radius;
  for (const Real radius : data.radii) {
    data.largest_radius = std::max(data.largest_radius, radius);
  }
}

std::vector<Particles> Particles::samples() {
  const std::array<Real, 9> alike{0, 0, 0, 0.5, 0, 0, 0.2, 0.3, -0.1};
  const std::array<Real, 8> various{0, 0, 0, 0.3, 0.4, 0.1, 0, 0.05};
  return {make(std::array{0.2}, alike, {}).value(), make(std::array{0.0}, various, {}).value()};
}

std::optional<RayHit> Particles::cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
  const Vec3 d = direction;
  const Real reach = data_->largest_radius;
  // The part of the ray in the box of all particles, a little widened against rounding.
  const Aabb box = data_->centres.inflated(reach * (1 + 8 * epsilon));
  Real enter = 0, leave = max_distance;
  for (int axis = 0; axis < 3; ++axis) {
    const Real slack = 8 * epsilon * (std::fabs(box.low[axis]) + std::fabs(box.high[axis]) + std::fabs(origin[axis]));
    const Real low = box.low[axis] - slack - origin[axis], high = box.high[axis] + slack - origin[axis];
    if (d[axis] == 0) {
      if (low > 0 || high < 0) {
        return std::nullopt;
      }
      continue;
    }
    enter = std::max(enter, std::min(low / d[axis], high / d[axis]));
    leave = std::min(leave, std::max(low / d[axis], high / d[axis]));
  }
  if (!(enter <= leave)) {
    return std::nullopt;
  }
  std::optional<RayHit> best;
  const auto try_between = [&](Real from, Real to) {
    Aabb around = Aabb::empty();
    around.include(origin + from * d);
    around.include(origin + to * d);
    around = around.inflated(8 * epsilon * (largest_magnitude(around.low) + largest_magnitude(around.high)));
    visit_places(around, [&](const Vec3& place, std::uint32_t index) {
      auto hit = part(index).cast_ray(origin - place, direction, max_distance);
      if (hit && (!best || hit->distance < best->distance)) {
        best = hit;
        best->feature = {FeatureKind::particle, index};
      }
    });
  };
  const Real step = 2 * grid().cell(), stretches = std::ceil((leave - enter) / step);
  if (!(stretches < static_cast<Real>(particle_count()))) {
    try_between(enter, leave);
    return best;
  }
  for (Real i = 0; i < stretches; ++i) {
    // What is hit before this stretch was found in one before it.
    if (best && best->distance <= enter + i * step) {
      break;
    }
    try_between(enter + i * step, std::min(leave, enter + (i + 1) * step));
  }
  return best;
}

}  // namespace abut
