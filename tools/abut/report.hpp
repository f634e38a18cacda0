// SPDX-License-Identifier: Apache-2.0
// The report of errors and times, and curves of motion, which Python draws.
#pragma once

#include "arguments.hpp"
#include "failures.hpp"

namespace cli {

/// Draws a report.json, or measures and draws. Status::odd where something got worse.
[[nodiscard]] Status report(const Arguments& arguments);

/// Draws what a run wrote of the motion of bodies.
[[nodiscard]] Status plot(const Arguments& arguments);

}  // namespace cli
