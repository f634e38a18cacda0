// SPDX-License-Identifier: Apache-2.0
// Expected failures: a stable code, and a sentence for people.
export module abut.core.error;
import abut.core.standard;

export namespace abut {

// The numbers are those of abut_status in abut.h.
enum class Errc : std::int32_t {
  invalid_argument = 1,
  null_argument = 2,
  not_finite = 3,
  out_of_range = 4,
  zero_vector = 5,
  not_unit = 6,
  index_out_of_range = 7,
  size_overflow = 8,
  empty = 9,
  stale_id = 10,
  wrong_struct_size = 11,
  unknown_value = 12,
  unsupported = 13,
  not_converged = 14,
  out_of_memory = 15,
  internal = 16,
  busy = 17,
};

struct Error {
  Errc code{};
  std::string message;
};

[[nodiscard]] std::string to_text(double value) {
  // The shortest digits that read back as the same number; at most 24 characters.
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::to_chars(text.data(), &text.back(), value).ptr - text.data()));
  return text;
}

[[nodiscard]] std::string to_text(std::uint64_t value) { return std::to_string(value); }

// "radius is -1; it must be positive"
[[nodiscard]] Error error_about(Errc code, std::string_view name, double value, std::string_view expectation) {
  return {code, std::string(name) + " is " + to_text(value) + "; it must be " + std::string(expectation)};
}
[[nodiscard]] Error error_about(Errc code, std::string_view name, std::uint64_t value, std::string_view expectation) {
  return {code, std::string(name) + " is " + to_text(value) + "; it must be " + std::string(expectation)};
}

}  // namespace abut
