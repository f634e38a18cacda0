// SPDX-License-Identifier: Apache-2.0
// What is true of a step of meshes that deform: all pairs of elements, one by one, in 113-bit floating point. It shares
// no code with abut, and none with any other contender.
#pragma once
#include "deforming_ways.hpp"

namespace bench {

// Pairs in the order of their keys. Distances as of Found.
[[nodiscard]] Found deforming_truth(Asked asked, const DeformingCase& step);

}  // namespace bench
