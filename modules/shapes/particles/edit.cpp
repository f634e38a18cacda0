// SPDX-License-Identifier: Apache-2.0
module abut.shapes.particles;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

namespace abut {

Fault Particles::check(const ParticleEdit& edit) const {
  const std::size_t all = particle_count(), count = edit.xyz.size() / 3;
  if (edit.first > all) {
    return error_about(Errc::index_out_of_range, "first", std::uint64_t{edit.first}, "at most " + std::to_string(all));
  }
  if (count > all - edit.first) {
    return error_about(Errc::index_out_of_range, "count", std::uint64_t{count},
                       "at most " + std::to_string(all - edit.first) + ", as first is " + std::to_string(edit.first));
  }
  if (!edit.radii.empty() && data_->radii.empty()) {
    return error_about(Errc::unsupported, "radii", std::uint64_t{edit.radii.size()},
                       "none, as these particles have one radius in common");
  }
  if (Fault fault = check_all_finite("xyz", edit.xyz)) {
    return fault;
  }
  for (std::size_t i = 0; i < edit.radii.size(); ++i) {
    if (!(edit.radii[i] >= 0 && edit.radii[i] <= largest_coordinate)) {
      return check_not_negative("radii[" + std::to_string(i) + "]", edit.radii[i]);
    }
  }
  return std::nullopt;
}

Aabb Particles::apply(const ParticleEdit& edit) {
  Data& data = data_.own();
  Aabb changed = Aabb::empty();
  const auto include = [&](std::size_t place) {
    const Real radius = radius_of(static_cast<std::uint32_t>(place));
    changed.include(Aabb::around(data.places[place], {radius, radius, radius}));
  };
  for (std::size_t i = 0; i < edit.xyz.size() / 3; ++i) {
    const std::size_t place = edit.first + i;
    include(place);
    data.places[place] = {edit.xyz[3 * i], edit.xyz[3 * i + 1], edit.xyz[3 * i + 2]};
    if (!edit.radii.empty()) {
      data.radii[place] = edit.radii[i];
    }
    include(place);
  }
  const Aabb centres = data.centres;
  const Real largest = data.largest_radius;
  measure(data);
  data.grid.forget();
  // The order in which queries find particles comes from the cells of the grid, and those from these.
  const bool has_same_cells =
      centres.low == data.centres.low && centres.high == data.centres.high && largest == data.largest_radius;
  return has_same_cells ? changed : Aabb::everything();
}

}  // namespace abut
