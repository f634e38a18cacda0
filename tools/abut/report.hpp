// SPDX-License-Identifier: Apache-2.0
// The report of errors and times, which Python draws.
#pragma once

#include "arguments.hpp"
#include "failures.hpp"

namespace cli {

/// Draws a report.json, or measures and draws. Status::odd where something got worse.
[[nodiscard]] Status report(const Arguments& arguments);

}  // namespace cli
