// SPDX-License-Identifier: Apache-2.0
// The one table of commands, options and exit statuses. What is accepted, the help, the manual page and completion all
// follow from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

enum class Command : std::uint8_t {
  run,
  explain,
  explain_pair,
  check,
  distance,
  pairs,
  picture,
  lean,
  plot,
  report,
  tune,
  shapes,
  completion,
  manual,
  help,
  version
};

struct CommandRow {
  Command command;
  std::string_view words;     // such as "explain pair"
  std::string_view operands;  // such as "SCENE [A B]"; brackets hold what may be left out
  std::string_view help;      // one line
  std::string_view options;   // the names of those that it takes, with a space between them
};

struct OptionRow {
  std::string_view name;   // with its dashes
  std::string_view value;  // what stands after it, such as "N" or "FILE"; empty where nothing does
  std::string_view help;
};

struct StatusRow {
  std::string_view status;
  std::string_view meaning;
};

[[nodiscard]] std::span<const CommandRow> all_commands();
[[nodiscard]] std::span<const OptionRow> all_options();
[[nodiscard]] std::span<const StatusRow> all_statuses();

[[nodiscard]] const CommandRow& row_of(Command command);

/// The options of a command, in the order of the table.
[[nodiscard]] std::vector<OptionRow> options_of(const CommandRow& row);

/// The first words of all commands, each once.
[[nodiscard]] std::vector<std::string> first_words();

/// Words between spaces.
[[nodiscard]] std::vector<std::string> split(std::string_view text);

}  // namespace cli
