// SPDX-License-Identifier: Apache-2.0
// A heap of balls in a square pit, at rest but for what the last step of gravity adds.
#pragma once

#include "world.hpp"

namespace response_test {

// Balls of radius 0.1 and masses from 0.5 to 1.5 fall for `steps` of 5 ms and come to rest; sweeps over their contacts
// do.
[[nodiscard]] World heap(int balls, double friction, int steps, unsigned seed);

}  // namespace response_test
