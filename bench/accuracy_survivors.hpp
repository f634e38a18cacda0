// SPDX-License-Identifier: Apache-2.0
// Which cases a library can be asked at all: some stop the program at an assertion of their own.
#pragma once
#include <cstddef>
#include <vector>

#include "accuracy_rows.hpp"

namespace bench {

// The indices of the cases that the entrant answers without ending a process that was made to try it.
[[nodiscard]] std::vector<std::size_t> survivors(const Entrant& entrant, Query query, const Cell& cell);

}  // namespace bench
