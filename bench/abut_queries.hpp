// SPDX-License-Identifier: Apache-2.0
// What abut can be asked beside the pair itself: an algorithm and an error bound.
#pragma once
#include <abut/abut.h>

#include <memory>
#include <vector>

#include "pairs.hpp"

namespace bench {

struct AbutQuery {
  abut_algorithm algorithm = ABUT_ALGORITHM_AUTO;
  double error_bound = 0;  // 0: the default
};

struct Interval {
  double lower = 0, upper = 0;
};

// Null where abut answers none of the cases so.
[[nodiscard]] std::unique_ptr<Contender> make_abut(Query query, const Cell& cell, const AbutQuery& asked);

// Where abut says that the distances of the cases lie, one by one; empty intervals where it does not answer.
[[nodiscard]] std::vector<Interval> abut_intervals(const Cell& cell, const AbutQuery& asked);

}  // namespace bench
