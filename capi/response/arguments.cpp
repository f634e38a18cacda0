// SPDX-License-Identifier: Apache-2.0
#include "response/arguments.hpp"

#include "extension_arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <span>
#include <utility>

namespace abut::capi {

namespace {

// A field or an element of an argument, by name.
class Name {
 public:
  Name(const char* argument, const char* field) noexcept {
    static_cast<void>(std::snprintf(text_.data(), text_.size(), "%s.%s", argument, field));
  }
  Name(const char* argument, std::size_t index) noexcept {
    static_cast<void>(std::snprintf(text_.data(), text_.size(), "%s[%zu]", argument, index));
  }
  [[nodiscard]] const char* text() const noexcept { return text_.data(); }

 private:
  std::array<char, 96> text_{};
};

constexpr const char* within = "it must be within 1e30";

}  // namespace

abut_status check_number(double value, const char* argument, double least, double most,
                         const char* expectation) noexcept {
  if (!std::isfinite(value)) return refuse(ABUT_NOT_FINITE, argument, value, "it must be finite");
  if (!(value >= least && value <= most)) return refuse(ABUT_OUT_OF_RANGE, argument, value, expectation);
  return ABUT_OK;
}

abut_status check_vector(const abut_vec3& vector, const char* argument) noexcept {
  for (const auto& [field, value] : {std::pair("x", vector.x), std::pair("y", vector.y), std::pair("z", vector.z)}) {
    const abut_status status =
        check_number(value, Name(argument, field).text(), -largest_number, largest_number, within);
    if (status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

abut_status check_inertia(std::span<const double, 9> m, const char* argument, std::size_t first) noexcept {
  for (std::size_t i = 0; i < m.size(); ++i) {
    const abut_status status =
        check_number(m[i], Name(argument, first + i).text(), -largest_number, largest_number, within);
    if (status != ABUT_OK) return status;
  }
  // By so much of the largest number two halves of a matrix may differ.
  constexpr double rounding = 1e-12;
  for (const auto& [upper, lower] : {std::pair<std::size_t, std::size_t>(1, 3), {2, 6}, {5, 7}}) {
    if (std::fabs(m[upper] - m[lower]) > rounding * std::max({m[0], m[4], m[8]})) {
      return refuse(ABUT_INVALID_ARGUMENT, Name(argument, first + upper).text(), m[upper],
                    "the matrix of a body must be symmetric");
    }
  }
  // The pivots of Gaussian elimination. Each divides those after it, so none of them may be 0.
  const auto refuse_pivot = [&](std::size_t place) {
    return refuse(ABUT_OUT_OF_RANGE, Name(argument, first + place).text(), m[place],
                  "the matrix of a body must be positive definite, by at least 1e-30");
  };
  if (!(m[0] >= least_mass)) return refuse_pivot(0);
  const double d1 = m[4] - m[3] / m[0] * m[3], rest = m[7] - m[6] / m[0] * m[3];
  if (!(d1 >= least_mass)) return refuse_pivot(4);
  if (!(m[8] - m[6] / m[0] * m[6] - rest / d1 * rest >= least_mass)) return refuse_pivot(8);
  return ABUT_OK;
}

abut_status check_mass(const abut_mass_properties& mass, const char* argument) noexcept {
  abut_status status = check_number(mass.mass, Name(argument, "mass").text(), least_mass, largest_number,
                                    "it must lie between 1e-30 and 1e30");
  if (status == ABUT_OK) status = check_vector(mass.centre, Name(argument, "centre").text());
  if (status == ABUT_OK) status = check_inertia(std::span(mass.inertia), Name(argument, "inertia").text(), 0);
  return status;
}

abut_status check_density(double density, const char* argument) noexcept {
  return check_number(density, argument, least_mass, largest_number, "it must lie between 1e-30 and 1e30");
}

abut_status check_material(const abut_contact_material& material) noexcept {
  constexpr double largest_coefficient = 1e6;
  for (const auto& [name, value] :
       {std::pair("friction_primary", material.friction_primary),
        std::pair("friction_secondary", material.friction_secondary), std::pair("static_scale", material.static_scale),
        std::pair("restitution", material.restitution)}) {
    const abut_status status =
        check_number(value, name, 0, largest_coefficient, "of a contact it must lie between 0 and 1e6");
    if (status != ABUT_OK) return status;
  }
  for (const auto& [name, value] :
       {std::pair("compliance", material.compliance), std::pair("damping", material.damping),
        std::pair("restitution_threshold", material.restitution_threshold),
        std::pair("adhesive_force", material.adhesive_force)}) {
    const abut_status status =
        check_number(value, name, 0, largest_number, "of a contact it must lie between 0 and 1e30");
    if (status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

abut_status check_law(const abut_contact_law& law) noexcept {
  struct [[gsl::Pointer]] Number {
    const char* name;
    double value, least, most;
  };
  constexpr double largest_friction = 1e6;
  for (const Number& its : {Number{"law.friction_primary", law.friction_primary, 0, largest_friction},
                            Number{"law.friction_secondary", law.friction_secondary, 0, largest_friction},
                            Number{"law.compliance", law.compliance, 0, largest_number},
                            Number{"law.offset", law.offset, -largest_number, largest_number},
                            Number{"law.pull", law.pull, 0, largest_number}}) {
    const abut_status status =
        check_number(its.value, its.name, its.least, its.most, "the callback of a kind left it out of range");
    if (status != ABUT_OK) return status;
  }
  return check_vector(law.surface_velocity, "law.surface_velocity");
}

abut_status check_options(const abut_link_options& options) noexcept {
  if (!has_known_size(options)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "options.struct_size", options.struct_size,
                  "fill the options with abut_link_options_init");
  }
  if (options.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "options.reserved", options.reserved, "it must be 0");
  abut_status status = check_vector(options.point_a, "options.point_a");
  if (status == ABUT_OK) status = check_vector(options.point_b, "options.point_b");
  for (const auto& [name, value] :
       {std::pair("options.stiffness", options.stiffness), std::pair("options.damping", options.damping),
        std::pair("options.most_force", options.most_force), std::pair("options.break_force", options.break_force)}) {
    if (status == ABUT_OK) status = check_number(value, name, 0, largest_number, "it must lie between 0 and 1e30");
  }
  return status;
}

abut_status check_options(const abut_response_options& options) noexcept {
  if (!has_known_size(options)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "options.struct_size", options.struct_size,
                  "fill the options with abut_response_options_init");
  }
  if (options.most_rounds == 0) return refuse(ABUT_OUT_OF_RANGE, "options.most_rounds", 0, "it must be at least 1");
  if (options.flags > ABUT_RESPONSE_IMPACTS)
    return refuse(ABUT_UNKNOWN_VALUE, "options.flags", options.flags, "it must be bits of abut_response_flags");
  if (options.flags != 0 && abut_has_feature("motion") == 0)
    return refuse(ABUT_UNSUPPORTED, "options.flags", options.flags, "impacts need a build with the feature motion");
  if (options.solver > ABUT_SOLVER_SWEEPS)
    return refuse(ABUT_UNKNOWN_VALUE, "options.solver", options.solver, "it must be a value of abut_solver");
  if (options.threads == 0 || options.threads > most_threads)
    return refuse(ABUT_OUT_OF_RANGE, "options.threads", options.threads, "it must lie between 1 and 256");
  if (options.threads > 1 && abut_has_feature("threads") == 0)
    return refuse(ABUT_UNSUPPORTED, "options.threads", options.threads, "more than 1 needs the feature threads");
  if (options.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "options.reserved", options.reserved, "it must be 0");
  abut_status status = check_vector(options.gravity, "options.gravity");
  for (const auto& [name, value] :
       {std::pair("options.tolerance", options.tolerance), std::pair("options.slop", options.slop)}) {
    if (status == ABUT_OK) status = check_number(value, name, 0, largest_number, "it must lie between 0 and 1e30");
  }
  return status;
}

abut_status check_options(const abut_body_options& options) noexcept {
  if (!has_known_size(options)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "options.struct_size", options.struct_size,
                  "fill the options with abut_body_options_init");
  }
  if (options.integrator > ABUT_INTEGRATOR_IMPLICIT) {
    return refuse(ABUT_UNKNOWN_VALUE, "options.integrator", options.integrator,
                  "it must be a value of abut_integrator");
  }
  return options.mass.mass == 0 ? check_density(options.density, "options.density")
                                : check_mass(options.mass, "options.mass");
}

}  // namespace abut::capi
