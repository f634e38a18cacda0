// SPDX-License-Identifier: Apache-2.0
// A motion of two features from bytes, and what has to hold of their first touch.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace touch_fuzzing {

// An input is `u8 flags`, then 24 coordinates: of four vertices at the start, and of these at the end. Bit 0 of the
// flags asks for edges, not for a vertex and a face. With bit 1 a coordinate is a byte, and a whole number within -4
// and 4; without it a double, within -2^20 and 2^20. What lacks is zero.
//
// Empty, or what is wrong.
[[nodiscard]] std::string finding_of(std::span<const std::uint8_t> bytes);

}  // namespace touch_fuzzing
