// SPDX-License-Identifier: Apache-2.0
// What the program says about itself, made from the table of commands.
#pragma once

#include <optional>
#include <string>

#include "command_table.hpp"

namespace cli {

/// All commands and options, or those of one command.
[[nodiscard]] std::string help_text(std::optional<Command> about);

/// The manual page, in the language of man.
[[nodiscard]] std::string manual_page();

/// Completion for a shell; throws BadInput when there is none for it.
[[nodiscard]] std::string completion_for(const std::string& shell);

}  // namespace cli
