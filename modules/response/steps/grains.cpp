// SPDX-License-Identifier: Apache-2.0
// Grains as bodies: they come behind all others, and turn neither by contacts nor by themselves.
module;

#include <abut/response.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {}  // namespace

abut_status Simulation::set_particles(Grains particles) {
  grains_.reserve(grains_.size() + 1);
  const abut_status status = source_->move_particles(particles.geometry, particles.xyz);
  if (status != ABUT_OK) return status;
  static_cast<void>(remove_surface(particles.geometry));
  remove_surfaces_on(particles.geometry);
  const auto old =
      std::ranges::find_if(grains_, [&](const Grains& its) { return is_same(its.geometry, particles.geometry); });
  if (old != grains_.end()) {
    *old = std::move(particles);
  } else {
    grains_.push_back(std::move(particles));
  }
  return ABUT_OK;
}

bool Simulation::remove_particles(abut_geometry_id geometry) {
  remove_surfaces_on(geometry);
  const bool was_surface = remove_surface(geometry);
  return std::erase_if(grains_, [&](const Grains& its) { return is_same(its.geometry, geometry); }) > 0 || was_surface;
}

const Grains* Simulation::particles_of(abut_geometry_id geometry) const {
  const auto found = std::ranges::find_if(grains_, [&](const Grains& its) { return is_same(its.geometry, geometry); });
  return found == grains_.end() ? nullptr : &*found;
}

void Simulation::read_particles(Pass& pass) const {
  for (std::uint32_t number = 0; number < grains_.size(); ++number) {
    const Grains& particles = grains_[number];
    read_elements(pass.motions.size(), number, pass);
    for (std::size_t i = 0; i < particles.masses.size(); ++i) {
      Motion its;
      its.mass = particles.masses[i];
      // No impulse has a moment about a particle, so any inertia will do.
      its.inertia = {its.mass, 0, 0, 0, its.mass, 0, 0, 0, its.mass};
      its.orientation = {1, 0, 0, 0};
      its.centre = vector_at(particles.xyz, i);
      its.linear = its.linear_before = vector_at(particles.velocities, i);
      its.is_awake = its.mass > 0;
      pass.motions.push_back(its);
    }
  }
}

abut_status Simulation::write_particles(double dt, const Pass& pass) {
  std::size_t place = bodies_.size();
  for (Grains& particles : grains_) {
    std::vector<double> xyz = particles.xyz;
    for (std::size_t i = 0; i < particles.masses.size(); ++i) {
      const Motion& its = pass.motions[place + i];
      if (!its.is_awake) continue;
      const abut_vec3 mean = its.is_pushed ? its.linear : scale(add(its.linear_before, its.linear), 0.5);
      set_vector_at(xyz, i, add(add(its.centre, scale(mean, dt)), its.shift));
    }
    const abut_status status = source_->move_particles(particles.geometry, xyz);
    if (status != ABUT_OK) return status;
    particles.xyz = std::move(xyz);
    for (std::size_t i = 0; i < particles.masses.size(); ++i) {
      if (pass.motions[place + i].is_awake) set_vector_at(particles.velocities, i, pass.motions[place + i].linear);
    }
    place += particles.masses.size();
  }
  for (const Surface& its : surfaces_) {
    if (const abut_status status = source_->move_particles(its.geometry, places_of(its)); status != ABUT_OK)
      return status;
  }
  return ABUT_OK;
}

}  // namespace abut::response
