// SPDX-License-Identifier: Apache-2.0
#include "dynamics.hpp"

#include <algorithm>
#include <string>

#include "common/owners.hpp"

namespace cli {

Dynamics::Dynamics(abut_universe* universe, const Scene& scene, std::span<const abut_part_id> parts,
                   std::vector<std::size_t> bodies)
    : library_(load_response()), response_(nullptr, {library_.destroy}), bodies_(std::move(bodies)) {
  const Response& wanted = *scene.response;
  abut_response_options options;
  library_.options_init(&options, sizeof options);
  options.gravity = wanted.gravity;
  options.tolerance = wanted.tolerance.value_or(options.tolerance);
  options.slop = wanted.slop.value_or(options.slop);
  options.solver = wanted.solver;
  options.flags = wanted.has_impacts ? ABUT_RESPONSE_IMPACTS : 0;
  options.threads = std::max<std::uint32_t>(scene.universe.threads, 1);
  abut_response* made = nullptr;
  check_scene(library_.create(universe, &options, &made), "response");
  response_.reset(made);
  add_bodies(scene, parts);
}

void Dynamics::add_bodies(const Scene& scene, std::span<const abut_part_id> parts) {
  for (const std::size_t i : bodies_) {
    const Part& part = scene.parts[i];
    abut_body_options options;
    library_.body_options_init(&options, sizeof options);
    options.density = part.density.value_or(options.density);
    const std::string path = "the body " + part.name;
    check_scene(library_.add_bodies(response_.get(), &parts[i], 1, &options), path);
    if (!part.mass) {
      continue;
    }
    // The density that has this mass.
    abut_mass_properties weighed{};
    check_scene(library_.body(response_.get(), parts[i], &weighed), path);
    options.density *= *part.mass / weighed.mass;
    check_scene(library_.remove_body(response_.get(), parts[i]), path);
    check_scene(library_.add_bodies(response_.get(), &parts[i], 1, &options), path);
  }
}

abut_status Dynamics::step(double dt) { return library_.step(response_.get(), dt); }

abut_energy Dynamics::energy() const {
  abut_energy energy{};
  check(library_.energy(response_.get(), &energy), "energy of the bodies");
  return energy;
}

std::span<const abut_response_contact> Dynamics::contacts() const {
  const abut_response_contact* contacts = nullptr;
  std::size_t count = 0;
  check(library_.contacts(response_.get(), &contacts, &count), "contacts of the bodies");
  return {contacts, count};
}

std::size_t Dynamics::contact_count() const { return contacts().size(); }

double Dynamics::deepest() const {
  double deepest = 0;
  for (const abut_response_contact& contact : contacts()) {
    deepest = std::max(deepest, -contact.distance);
  }
  return deepest;
}

double Dynamics::residual() const {
  const abut_response_island* islands = nullptr;
  std::size_t count = 0;
  check(library_.islands(response_.get(), &islands, &count), "islands of the bodies");
  double worst = 0;
  for (const abut_response_island& island : std::span(islands, count)) {
    worst = std::max({worst, island.residuals.contact, island.residuals.motion});
  }
  return worst;
}

}  // namespace cli
