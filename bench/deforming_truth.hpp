// SPDX-License-Identifier: Apache-2.0
// The truth about a step of meshes that deform: all pairs of elements, one by one, in 113-bit floating point. This code
// shares nothing with abut, and nothing with any other contender.
#pragma once
#include "deforming_ways.hpp"

namespace bench {

// Pairs in the order of their keys. Distances as of Found.
[[nodiscard]] Found deforming_truth(Asked asked, const DeformingCase& step);

}  // namespace bench
