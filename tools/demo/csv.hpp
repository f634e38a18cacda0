// SPDX-License-Identifier: Apache-2.0
// Tables as comma-separated values; numbers are written with a fixed count of decimals, so that equal results give
// equal bytes.
#pragma once

#include <filesystem>
#include <span>

#include "scene.hpp"

namespace demo {

/// One row for each contact of a step.
void write_contacts(const std::filesystem::path& path, std::uint32_t step, std::span<const abut_contact> contacts,
                    const Scene& scene);

/// One row for each element contact of the cloth, where it was found last.
void write_cloth(const std::filesystem::path& path, const Cloth& cloth);

/// One row for each step: counts, and no times.
void write_steps(const std::filesystem::path& path, std::span<const abut_step_stats> steps);

}  // namespace demo
