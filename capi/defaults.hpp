// SPDX-License-Identifier: Apache-2.0
// What the _init functions do. The standard library comes before: as headers in picking.h, else as a module.
#ifndef ABUT_CAPI_DEFAULTS_HPP
#define ABUT_CAPI_DEFAULTS_HPP

#include "core/check.hpp"

namespace abut::capi {

// No struct will ever be larger; a number beyond is not a size.
inline constexpr std::uint32_t largest_struct_size = 4096;

// As much of the defaults as the caller's struct has room for, and zeros in what a newer header has
// appended. A size that no struct has leaves everything as it is.
template <class Struct>
void fill_defaults(const Struct& defaults, std::uint32_t struct_size, Struct* out) {
  if (out == nullptr || struct_size < sizeof(std::uint32_t) || struct_size > largest_struct_size) {
    return;
  }
  Struct filled = defaults;
  filled.struct_size = struct_size;
  const std::size_t known = std::min<std::size_t>(struct_size, sizeof(Struct));
  // SAFETY: the size is that of the caller's struct, as the caller says.
  ABUT_UNSAFE_BEGIN
  const std::span<std::byte> bytes(static_cast<std::byte*>(static_cast<void*>(out)), struct_size);
  ABUT_UNSAFE_END
  const auto rest = std::ranges::copy(std::as_bytes(std::span(&filled, 1)).first(known), bytes.begin()).out;
  std::fill(rest, bytes.end(), std::byte{0});
}

}  // namespace abut::capi

#endif
