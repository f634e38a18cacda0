// SPDX-License-Identifier: Apache-2.0
// Error over time as a picture: one panel for each condition, one mark for each contender.
#pragma once
#include <filesystem>
#include <span>

#include "accuracy_rows.hpp"

namespace bench {

void write_picture(const std::filesystem::path& path, std::span<const Row> rows, Query query);

}  // namespace bench
