// SPDX-License-Identifier: Apache-2.0
// How the libraries that stand on abut.h refuse what callers hand to them. Each function writes this thread's message
// and answers the status.
#ifndef ABUT_CAPI_EXTENSION_ARGUMENTS_HPP
#define ABUT_CAPI_EXTENSION_ARGUMENTS_HPP

#include <abut/abut.h>

#include "core/check.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::capi {

/// Refuses: "<argument> is <value>; <expectation>".
[[nodiscard]] abut_status refuse(abut_status status, const char* argument, double value,
                                 const char* expectation) noexcept;
[[nodiscard]] abut_status refuse(abut_status status, const char* message) noexcept;
[[nodiscard]] abut_status refuse_null(const char* argument) noexcept;

/// Refuses an id, such as that of a part: "<argument> is stale or of another universe (slot ..., generation ...)".
[[nodiscard]] abut_status refuse_stale(const char* argument, std::uint32_t slot, std::uint32_t generation) noexcept;
template <class Id>
[[nodiscard]] abut_status refuse_stale(const char* argument, const Id& id) noexcept {
  return refuse_stale(argument, id.slot, id.generation);
}

/// Refuses so many elements of `size` bytes when they cannot be in memory at all.
[[nodiscard]] abut_status check_fits(const char* argument, std::size_t count, std::size_t size) noexcept;

// A struct_size beyond this is garbage, not a later version.
inline constexpr std::size_t largest_struct = 4096;

/// Whether a struct has at least the size of this version, and zeros behind it.
template <class Struct>
[[nodiscard]] bool has_known_size(const Struct& given) noexcept {
  const std::size_t size = given.struct_size;
  if (size < sizeof(Struct) || size > largest_struct) return false;
  // SAFETY: the caller says that the struct has this size.
  ABUT_UNSAFE_BEGIN
  const std::span<const unsigned char> bytes(static_cast<const unsigned char*>(static_cast<const void*>(&given)), size);
  ABUT_UNSAFE_END
  return std::ranges::all_of(bytes.subspan(sizeof(Struct)), [](unsigned char byte) { return byte == 0; });
}

/// The same of room for answers, which may be null for none.
[[nodiscard]] abut_status check_room(const char* argument, const void* room, std::size_t capacity,
                                     std::size_t size) noexcept;

}  // namespace abut::capi

#endif
