// SPDX-License-Identifier: Apache-2.0
// Errors of moving bodies as a picture.
#pragma once
#include <filesystem>
#include <vector>

#include "response_file.hpp"

namespace bench {

// A panel for each trial: error over milliseconds a step, both logarithmic.
void draw_errors(const std::filesystem::path& path, const std::vector<Measured>& all);

}  // namespace bench
