// SPDX-License-Identifier: Apache-2.0
// Reads the text of a scene.
#pragma once

#include <filesystem>

#include "node.hpp"

namespace cli {

/// Parses JSON; stricter than the library that does it: a name that an object has twice, numbers beyond what a double
/// holds and more than 64 levels are refused. Throws BadInput with line and column, both from 1.
[[nodiscard]] Json read_document(const std::filesystem::path& path);

}  // namespace cli
