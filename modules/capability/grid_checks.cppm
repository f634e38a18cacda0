// SPDX-License-Identifier: Apache-2.0
// Checks of the samples of height fields and distance fields. Each answers with the first fault, if any.
export module abut.capability.grid_checks;
import abut.capability.checks;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// How many samples a grid has along an axis.
[[nodiscard]] inline Fault check_samples(std::string_view name, Real value) {
  if (Fault fault = check_finite(name, value)) {
    return fault;
  }
  if (value == 0) {
    return error_about(Errc::empty, name, value, "at least 2");
  }
  if (!(value >= 2 && value <= 65535) || value != std::floor(value)) {
    return error_about(Errc::out_of_range, name, value, "a whole number from 2 to 65535");
  }
  return std::nullopt;
}

// `count` of `all` samples along an axis, from number `first` on.
struct [[gsl::Pointer]] Stretch {
  std::string_view first_name, count_name;
  std::uint32_t first, count;
};

[[nodiscard]] inline Fault check_stretch(const Stretch& stretch, std::uint32_t all) {
  if (stretch.first > all) {
    return error_about(Errc::index_out_of_range, stretch.first_name, std::uint64_t{stretch.first},
                       "at most " + std::to_string(all));
  }
  if (stretch.count > all - stretch.first) {
    return error_about(Errc::index_out_of_range, stretch.count_name, std::uint64_t{stretch.count},
                       "at most " + std::to_string(all - stretch.first) + ", as " + std::string(stretch.first_name) +
                           " is " + std::to_string(stretch.first));
  }
  return std::nullopt;
}

// Values of a distance field, which are kept as single numbers.
[[nodiscard]] inline Fault check_field_values(std::span<const Real> values) {
  constexpr Real largest = 3e38;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(std::fabs(values[i]) <= largest)) {
      const std::string name = "values[" + std::to_string(i) + "]";
      const Fault fault = check_finite(name, values[i]);
      return fault ? fault : error_about(Errc::out_of_range, name, values[i], "at most 3e38 in magnitude");
    }
  }
  return std::nullopt;
}

}  // namespace abut
