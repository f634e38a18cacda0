// SPDX-License-Identifier: Apache-2.0
// Checks of the numbers that shapes are made from. Each answers with the first fault, if any.
export module abut.capability.checks;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

using Fault = std::optional<Error>;

// Coordinates beyond this would overflow when squared twice.
inline constexpr Real largest_coordinate = 1e70;

[[nodiscard]] inline Fault check_finite(std::string_view name, Real value) {
  if (!std::isfinite(value)) {
    return error_about(Errc::not_finite, name, value, "finite");
  }
  if (std::fabs(value) > largest_coordinate) {
    return error_about(Errc::out_of_range, name, value, "at most 1e70 in magnitude");
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_positive(std::string_view name, Real value) {
  if (Fault fault = check_finite(name, value)) {
    return fault;
  }
  if (!(value > 0)) {
    return error_about(Errc::out_of_range, name, value, "positive");
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_not_negative(std::string_view name, Real value) {
  if (Fault fault = check_finite(name, value)) {
    return fault;
  }
  if (value < 0) {
    return error_about(Errc::out_of_range, name, value, "zero or positive");
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_all_finite(std::string_view name, std::span<const Real> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    // The name is only put together for a fault: there may be millions of values.
    if (!(std::fabs(values[i]) <= largest_coordinate)) {
      return check_finite(std::string(name) + "[" + std::to_string(i) + "]", values[i]);
    }
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_count(std::string_view name, std::size_t count, std::size_t expected) {
  if (count != expected) {
    return error_about(Errc::invalid_argument, name, static_cast<std::uint64_t>(count),
                       std::to_string(expected) + " for this kind");
  }
  return std::nullopt;
}

[[nodiscard]] inline Fault check_no_buffers(std::span<const Real> reals, std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("real_count", reals.size(), 0)) {
    return fault;
  }
  return check_count("index_count", indices.size(), 0);
}

// Of shapes that are made from lengths alone, each zero or positive.
[[nodiscard]] inline Fault check_lengths(std::span<const std::string_view> names, std::span<const Real> parameters,
                                         std::span<const Real> reals, std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), names.size())) {
    return fault;
  }
  if (Fault fault = check_no_buffers(reals, indices)) {
    return fault;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Fault fault = check_not_negative(names[i], parameters[i])) {
      return fault;
    }
  }
  return std::nullopt;
}

}  // namespace abut
