// SPDX-License-Identifier: Apache-2.0
// Measured ways to ask a pair, and which of them a time budget takes.
#pragma once

#include <array>
#include <vector>

#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "placed.hpp"

namespace cli {

struct PairRoutes {
  std::array<std::vector<abut_route>, 2> of;  // of distances, and of contacts
  double error_bound = 0, time_budget = 0;    // what was asked for; 0: nothing
};

[[nodiscard]] PairRoutes routes_of(const Arguments& arguments, const Placed& a, const Placed& b);

/// For people: a table, and a sentence about the choice.
[[nodiscard]] std::string text_of(const PairRoutes& routes);

[[nodiscard]] nlohmann::ordered_json json_of(const PairRoutes& routes);

}  // namespace cli
