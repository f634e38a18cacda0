// SPDX-License-Identifier: Apache-2.0
// Reads the text of a scene.
#pragma once

#include <filesystem>

#include "node.hpp"

namespace cli {

/// The name of a scene for people: that of the file, or of the standard input for "-".
[[nodiscard]] std::string shown_name(const std::filesystem::path& path);

/// Parses JSON; stricter than the library that does it: a name that an object has twice, numbers beyond what a double
/// holds and more than 64 levels are refused. Throws BadInput with line and column, both from 1.
/// The path "-" is the standard input.
[[nodiscard]] Json read_document(const std::filesystem::path& path);

/// The same for a text.
[[nodiscard]] Json read_text(const std::string& text);

}  // namespace cli
