// SPDX-License-Identifier: Apache-2.0
// Bodies and steps of response.h: checks arguments, keeps exceptions in, and hands on to abut.response.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"
#include "response/source.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "defaults.hpp"

import abut.response;

namespace {

using abut::capi::check_density;
using abut::capi::check_number;
using abut::capi::check_options;
using abut::capi::check_vector;
using abut::capi::guarded;
using abut::capi::largest_number;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::MassProperties;

constexpr abut_response_options usual_options{.struct_size = sizeof(abut_response_options),
                                              .most_rounds = 100,
                                              .gravity = {0, 0, -9.81},
                                              .tolerance = 1e-9,
                                              .slop = 1e-5,
                                              .flags = 0,
                                              .solver = ABUT_SOLVER_NEWTON,
                                              .threads = 1,
                                              .reserved = 0};
constexpr abut_body_options usual_body{.struct_size = sizeof(abut_body_options),
                                       .integrator = ABUT_INTEGRATOR_IMPLICIT,
                                       .density = 1000,
                                       .mass = {0, {0, 0, 0}, {}}};

[[nodiscard]] abut_status refuse_no_body(abut_part_id part) noexcept {
  return refuse(ABUT_STALE_ID, "part.slot", part.slot, "the part is no body of this response");
}

[[nodiscard]] abut_mass_properties written(const MassProperties& mass) {
  abut_mass_properties out{.mass = mass.mass, .centre = mass.centre, .inertia = {}};
  std::ranges::copy(mass.inertia, std::span(out.inertia).begin());
  return out;
}

[[nodiscard]] MassProperties read(const abut_mass_properties& mass) {
  MassProperties out{.mass = mass.mass, .centre = mass.centre, .inertia = {}};
  std::ranges::copy(mass.inertia, out.inertia.begin());
  return out;
}

// The mass that a part gets; by its shapes where the caller gives none.
[[nodiscard]] abut_status mass_of(const abut_universe* universe, abut_part_id part, const abut_body_options& options,
                                  MassProperties& out) {
  abut_motion motion = 0;
  abut_status status = abut_part_motion(universe, part, &motion);
  if (status != ABUT_OK) return status;
  if (motion != ABUT_MOTION_DYNAMIC)
    return refuse(ABUT_INVALID_ARGUMENT, "motion of a part", motion, "a body must be dynamic");
  if (options.mass.mass > 0) {
    out = read(options.mass);
    return ABUT_OK;
  }
  status = abut::capi::mass_of_part(universe, part, options.density, out);
  return status != ABUT_OK ? status : abut::capi::check_mass(written(out), "mass by density");
}

[[nodiscard]] abut::response::Simulation::Editor editor_of(abut_contact_callback callback, void* context) {
  return [callback, context](const abut_contact& contact, abut_contact_material& material, bool& counts) {
    counts = callback == nullptr || callback(context, &contact, &material) != 0;
    return counts ? abut::capi::check_material(material) : abut_status{ABUT_OK};
  };
}

[[nodiscard]] abut::response::Simulation::Field field_of(abut_force_callback callback, void* context) {
  if (callback == nullptr) return {};
  return [callback, context](abut_part_id part, const abut_pose& pose, const abut_velocity& velocity, double time,
                             abut_vec3& force, abut_vec3& torque) {
    callback(context, part, &pose, &velocity, time, &force, &torque);
    const abut_status status = check_vector(force, "force of the callback");
    return status != ABUT_OK ? status : check_vector(torque, "torque of the callback");
  };
}

// Sets a flag while a step runs.
class [[gsl::Pointer]] Stepping {
 public:
  explicit Stepping(abut_response& response) noexcept : response_(&response) { response_->is_stepping = true; }
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;
  ~Stepping() { response_->is_stepping = false; }

 private:
  abut_response* response_;
};

}  // namespace

abut_status abut_shape_mass_properties(const abut_shape* shape, double density, abut_mass_properties* out) {
  if (shape == nullptr) return refuse_null("shape");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_density(density, "density"); status != ABUT_OK) return status;
  return guarded([&] {
    MassProperties mass;
    const abut_status status = abut::capi::mass_of_shape(shape, mass);
    if (status == ABUT_OK) *out = written(abut::response::scaled(mass, density));
    return status;
  });
}

void abut_response_options_init(abut_response_options* options, uint32_t struct_size) {
  abut::capi::fill_defaults(usual_options, struct_size, options);
}

void abut_body_options_init(abut_body_options* options, uint32_t struct_size) {
  abut::capi::fill_defaults(usual_body, struct_size, options);
}

abut_status abut_response_create(abut_universe* universe, const abut_response_options* options, abut_response** out) {
  if (universe == nullptr) return refuse_null("universe");
  if (out == nullptr) return refuse_null("out");
  if (options != nullptr) {
    if (const abut_status status = check_options(*options); status != ABUT_OK) return status;
  }
  return guarded([&]() -> abut_status {
    abut::capi::ResponseAttachment attachment;
    if (const abut_status status = abut::capi::attach_response(universe, attachment); status != ABUT_OK) return status;
    auto source = std::make_unique<abut::capi::ResponseSource>(universe);
    auto response =
        std::make_unique<abut_response>(abut_response{.attachment = std::move(attachment),
                                                      .universe = abut::capi::UniversePointer(universe),
                                                      .simulation = abut::response::Simulation(std::move(source))});
    response->simulation.set_options(options == nullptr ? usual_options : *options);
    response->simulation.set_editor(editor_of(nullptr, nullptr));
    *out = response.release();
    return ABUT_OK;
  });
}

void abut_response_destroy(abut_response* response) {
  if (response != nullptr && response->is_stepping) return;
  const std::unique_ptr<abut_response> owned(response);
}

abut_status abut_response_set_options(abut_response* response, const abut_response_options* options) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (options == nullptr) return refuse_null("options");
    if (const abut_status status = check_options(*options); status != ABUT_OK) return status;
    its.simulation.set_options(*options);
    return ABUT_OK;
  });
}

abut_status abut_response_add_bodies(abut_response* response, const abut_part_id* parts, std::size_t count,
                                     const abut_body_options* options) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (options != nullptr) {
      if (const abut_status status = check_options(*options); status != ABUT_OK) return status;
    }
    if (count == 0) return ABUT_OK;
    if (parts == nullptr) return refuse_null("parts");
    if (const abut_status status = abut::capi::check_fits("count", count, sizeof(abut_part_id)); status != ABUT_OK)
      return status;
    // SAFETY: the caller answers for `count` parts.
    ABUT_UNSAFE_BEGIN
    const std::span<const abut_part_id> all(parts, count);
    ABUT_UNSAFE_END
    std::vector<MassProperties> masses(count);
    for (std::size_t i = 0; i < count; ++i) {
      const abut_status status =
          mass_of(its.universe.get(), all[i], options == nullptr ? usual_body : *options, masses[i]);
      if (status == ABUT_STALE_ID) {
        const std::string name = "parts[" + std::to_string(i) + "]";
        return abut::capi::refuse_stale(name.c_str(), all[i]);
      }
      if (status != ABUT_OK) return status;
    }
    its.simulation.reserve(its.simulation.body_count() + count);
    const abut_integrator integrator = options == nullptr ? usual_body.integrator : options->integrator;
    for (std::size_t i = 0; i < count; ++i) its.simulation.add_body(all[i], masses[i], integrator);
    return ABUT_OK;
  });
}

abut_status abut_response_remove_body(abut_response* response, abut_part_id part) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    return its.simulation.remove_body(part) ? ABUT_OK : refuse_no_body(part);
  });
}

abut_status abut_response_body(const abut_response* response, abut_part_id part, abut_mass_properties* out) {
  if (response == nullptr) return refuse_null("response");
  if (out == nullptr) return refuse_null("out");
  const std::optional<MassProperties> mass = response->simulation.mass_of(part);
  if (!mass) return refuse_no_body(part);
  *out = written(*mass);
  return ABUT_OK;
}

abut_status abut_response_apply_force(abut_response* response, abut_part_id part, const abut_vec3* force,
                                      const abut_vec3* at) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (force == nullptr) return refuse_null("force");
    if (const abut_status status = check_vector(*force, "force"); status != ABUT_OK) return status;
    if (at != nullptr) {
      if (const abut_status status = check_vector(*at, "at"); status != ABUT_OK) return status;
    }
    if (!its.simulation.mass_of(part)) return refuse_no_body(part);
    if (const abut_status status = abut_part_wake(its.universe.get(), part); status != ABUT_OK) return status;
    return its.simulation.push(part, *force, at == nullptr ? std::nullopt : std::optional(*at));
  });
}

abut_status abut_response_apply_torque(abut_response* response, abut_part_id part, const abut_vec3* torque) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (torque == nullptr) return refuse_null("torque");
    if (const abut_status status = check_vector(*torque, "torque"); status != ABUT_OK) return status;
    if (!its.simulation.mass_of(part)) return refuse_no_body(part);
    if (const abut_status status = abut_part_wake(its.universe.get(), part); status != ABUT_OK) return status;
    its.simulation.twist(part, *torque);
    return ABUT_OK;
  });
}

abut_status abut_response_set_contact_callback(abut_response* response, abut_contact_callback callback, void* context) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    its.simulation.set_editor(editor_of(callback, context));
    return ABUT_OK;
  });
}

abut_status abut_response_set_force_callback(abut_response* response, abut_force_callback callback, void* context) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    its.simulation.set_field(field_of(callback, context));
    return ABUT_OK;
  });
}

abut_status abut_response_step(abut_response* response, double dt) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    const abut_status checked = check_number(dt, "dt", std::numeric_limits<double>::min(), largest_number,
                                             "it must be above 0 and at most 1e30");
    if (checked != ABUT_OK) return checked;
    if (its.simulation.has_particles() && its.simulation.stops_at_impacts())
      return refuse(ABUT_UNSUPPORTED, "particles go without ABUT_RESPONSE_IMPACTS");
    if (const abut::response::Kind* const kind = its.simulation.rules().without_law(); kind != nullptr) {
      const std::string message = "kind " + kind->name + " has no function yet; abut_response_add_kind gives it one";
      return refuse(ABUT_INVALID_ARGUMENT, message.c_str());
    }
    const Stepping stepping(its);
    const abut_status status = its.simulation.step(dt);
    if (status == ABUT_OK && its.listener != nullptr) {
      for (const abut_response_object& object : its.simulation.objects()) its.listener(its.listener_context, &object);
    }
    if (status != ABUT_NOT_CONVERGED) return status;
    return refuse(status, "no finite velocities were found; masses, forces and dt are too far apart in size");
  });
}

abut_status abut_response_contacts(const abut_response* response, const abut_response_contact** contacts,
                                   std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (contacts == nullptr) return refuse_null("contacts");
  if (count == nullptr) return refuse_null("count");
  *contacts = response->simulation.contacts().data();
  *count = response->simulation.contacts().size();
  return ABUT_OK;
}

abut_status abut_response_islands(const abut_response* response, const abut_response_island** islands,
                                  std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (islands == nullptr) return refuse_null("islands");
  if (count == nullptr) return refuse_null("count");
  *islands = response->simulation.islands().data();
  *count = response->simulation.islands().size();
  return ABUT_OK;
}

abut_status abut_response_energy(const abut_response* response, abut_energy* out) {
  if (response == nullptr) return refuse_null("response");
  if (out == nullptr) return refuse_null("out");
  return guarded([&] { return response->simulation.energy(*out); });
}
