// SPDX-License-Identifier: Apache-2.0
// What a universe promises of contacts, whichever detector finds them. The same scenes for all of them.
#pragma once

#include <string>
#include <vector>

#include "detector.hpp"

namespace backend {

// In which ways a detector falls short, a sentence each; empty for one that conforms. True distances are closed forms,
// or maxima over separating axes.
std::vector<std::string> shortfalls_of(const Detector& detector);

}  // namespace backend
