// SPDX-License-Identifier: Apache-2.0
// What each way to ask a pair of kinds costs on this machine, and how far off it is.
#pragma once

#include "arguments.hpp"

namespace cli {

/// Measures all routes and writes the table that abut_routes_load reads.
void tune(const Arguments& arguments);

/// The text of a file with such a table. Throws BadInput where it cannot be read.
[[nodiscard]] std::string read_routes(const std::string& path);

}  // namespace cli
