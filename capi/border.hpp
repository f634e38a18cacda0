// SPDX-License-Identifier: Apache-2.0
// Checks of what comes in, and the only place where pointers of the caller become spans.
#ifndef ABUT_CAPI_BORDER_HPP
#define ABUT_CAPI_BORDER_HPP

#include "prelude.hpp"

#include "error.hpp"

import abut.capability;
import abut.core;

namespace abut::capi {

// Which argument a check is about: "pose_a", "poses[3]", or "options[3].pose". Put into words only when a
// check fails.
struct [[gsl::Pointer]] Where {
  static constexpr std::size_t no_index = std::numeric_limits<std::size_t>::max();

  std::string_view name;
  std::size_t index = no_index;
  std::string_view field = "";

  [[nodiscard]] std::string with(std::string_view suffix) const {
    std::string text(name);
    if (index != no_index) {
      text += "[" + std::to_string(index) + "]";
    }
    return text.append(field).append(suffix);
  }
};

[[nodiscard]] inline abut_status to_status(const Fault& fault) noexcept {
  return fault ? refuse(*fault) : static_cast<abut_status>(ABUT_OK);
}

// A module names the field that is wrong; of what, only the border knows.
[[nodiscard]] inline abut_status refuse_field(const Where& where, const Error& error) {
  return refuse(Error{error.code, where.with(".") + error.message});
}

[[nodiscard]] inline abut_status check_not_null(std::string_view name, const void* pointer) {
  if (pointer == nullptr) [[unlikely]] {
    return refuse(ABUT_NULL_ARGUMENT, std::string(name) + " is null");
  }
  return ABUT_OK;
}

template <std::size_t Count>
using NamedPointers = std::array<std::pair<std::string_view, const void*>, Count>;

// The first of several pointers that is null. By value, so that the names are put together for a refusal only.
template <std::size_t Count>
[[gnu::cold]] [[gnu::noinline]] abut_status refuse_null(NamedPointers<Count> pointers) {
  const auto* first = std::ranges::find(pointers, nullptr, &NamedPointers<Count>::value_type::second);
  return check_not_null(first->first, first->second);
}
template <std::size_t Count>
[[nodiscard]] [[gnu::always_inline]] inline abut_status check_none_null(const NamedPointers<Count>& pointers) {
  bool is_any_null = false;
  for (const auto& [name, pointer] : pointers) {
    is_any_null = is_any_null || pointer == nullptr;
  }
  return is_any_null ? refuse_null(pointers) : static_cast<abut_status>(ABUT_OK);
}

[[nodiscard]] inline abut_status check_size(std::string_view name, std::string_view count_name, std::uint64_t count,
                                            std::size_t stride) {
  if (count > static_cast<std::uint64_t>(std::numeric_limits<std::ptrdiff_t>::max()) / stride) [[unlikely]] {
    return refuse(ABUT_SIZE_OVERFLOW, std::string(count_name) + " is " + std::to_string(count) +
                                          "; that many elements of " + std::string(name) + ", " +
                                          std::to_string(stride) + " bytes each, do not fit into memory");
  }
  return ABUT_OK;
}

// How many samples a grid has; more than any array holds where the number does not fit.
[[nodiscard]] inline std::uint64_t samples_of_grid(std::uint32_t columns, std::uint32_t rows, std::uint32_t layers) {
  const std::uint64_t of_layer = std::uint64_t{columns} * rows;
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return layers != 0 && of_layer > most / layers ? most : of_layer * layers;
}

// An array of `count` groups of `Group` elements each. Sizes are checked before an element is read.
template <std::size_t Group = 1, class T>
[[nodiscard]] abut_status read_span(std::string_view name, T* pointer, std::string_view count_name, std::uint64_t count,
                                    std::span<T>& out) {
  if (const abut_status status = check_size(name, count_name, count, Group * sizeof(T)); status != ABUT_OK) {
    return status;
  }
  if (count == 0) {
    out = {};
    return ABUT_OK;
  }
  if (const abut_status status = check_not_null(name, pointer); status != ABUT_OK) {
    return status;
  }
  // SAFETY: the caller of the C interface says that so many elements are there; the size is checked.
  ABUT_UNSAFE_BEGIN
  out = std::span<T>(pointer, static_cast<std::size_t>(count) * Group);
  ABUT_UNSAFE_END
  return ABUT_OK;
}

// Where the answers of each of `count` questions begin in one list, and where the last of them ends.
[[nodiscard]] inline abut_status read_offsets(std::uint64_t* offsets, std::string_view count_name, std::size_t count,
                                              std::span<std::uint64_t>& out) {
  const abut_status status = check_size("offsets", count_name, count, sizeof(std::uint64_t));
  return status != ABUT_OK ? status : read_span("offsets", offsets, count_name, std::uint64_t{count} + 1, out);
}

// A struct of the caller, or an array of them, as bytes.
[[nodiscard]] inline std::span<const unsigned char> bytes_of(const void* structs, std::size_t size) {
  // SAFETY: the size is the struct_size that the caller has set, times a count that was checked.
  ABUT_UNSAFE_BEGIN
  return std::span<const unsigned char>(static_cast<const unsigned char*>(structs), size);
  ABUT_UNSAFE_END
}

// A struct of the caller that a module reads or fills in its own terms: the same numbers at the same places.
template <class Own, class Theirs>
[[nodiscard]] inline Own& written_as(Theirs& out) {
  static_assert(sizeof(Own) == sizeof(Theirs) && alignof(Own) == alignof(Theirs));
  static_assert(std::is_trivially_copyable_v<Own> && std::is_trivially_copyable_v<Theirs>);
  // SAFETY: both are plain numbers of one layout. The interface never uses the struct under its other name.
  void* place = &out;
  return *static_cast<Own*>(place);
}

// Count-then-fill: as many of `found` as fit, changed by `convert`.
template <class To, class From, class Convert>
void fill(std::span<const From> found, std::span<To> out, Convert&& convert) {
  const std::size_t written = std::min(found.size(), out.size());
  for (std::size_t i = 0; i < written; ++i) {
    out[i] = convert(found[i]);
  }
}

// Names and texts of the modules come from literals, which end with a zero.
[[nodiscard]] inline const char* c_string(std::string_view literal) { return literal.data(); }

}  // namespace abut::capi

#endif
