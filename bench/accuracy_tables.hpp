// SPDX-License-Identifier: Apache-2.0
// Rows as tables on the screen and as comma-separated values.
#pragma once
#include <filesystem>
#include <span>

#include "accuracy_rows.hpp"

namespace bench {

// One table for each question and condition, over all pairs.
void print_tables(std::span<const Row> rows);

// What time abut takes for each bound, pair by pair, in ordinary cases.
void print_prices(std::span<const Row> rows);

void write_rows(const std::filesystem::path& path, std::span<const Row> rows);

// The rows of one question, condition and entrant.
[[nodiscard]] std::vector<Row> selected(std::span<const Row> rows, Query query, Condition condition,
                                        std::size_t entrant);

}  // namespace bench
