// SPDX-License-Identifier: Apache-2.0
#include "help.hpp"

#include <algorithm>

namespace cli {
namespace {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

std::string synopsis(const CommandRow& row) {
  std::string text = "abut " + std::string(row.words);
  text += row.operands.empty() ? "" : " " + std::string(row.operands);
  return row.options.empty() ? text : text + " [options]";
}

std::string option_lines(const std::vector<OptionRow>& options) {
  std::string text;
  for (const OptionRow& option : options) {
    const std::string name = "  " + std::string(option.name) + " " + std::string(option.value);
    text += padded(name, 20) + std::string(option.help) + "\n";
  }
  return text;
}

constexpr const char* operands_text =
    "SCENE is a file, or - for the standard input. A and B are a PART of the scene, or PART/GEOMETRY. For distance "
    "without\n"
    "a scene they are shapes as JSON, such as '{\"kind\": \"sphere\", \"radius\": 1}', or objects with a shape and a "
    "pose.\n";

std::string status_lines() {
  std::string text = "exit status\n";
  for (const StatusRow& row : all_statuses()) {
    text += padded("  " + std::string(row.status), 20) + std::string(row.meaning) + "\n";
  }
  return text;
}

std::string help_for(const CommandRow& row) {
  std::string text = "usage: " + synopsis(row) + "\n\nIt " + std::string(row.help) + ".\n\n";
  text += option_lines(options_of(row)) + (row.options.empty() ? "" : "\n");
  return text + (row.operands.find('A') == std::string_view::npos ? "" : std::string(operands_text) + "\n") +
         status_lines();
}

}  // namespace

std::string help_text(std::optional<Command> about) {
  if (about) {
    return help_for(row_of(*about));
  }
  std::string text;
  for (const CommandRow& row : all_commands()) {
    text += padded((text.empty() ? "usage: " : "       ") + synopsis(row), 50) + std::string(row.help) + "\n";
  }
  text += "\n" + option_lines({all_options().begin(), all_options().end()});
  return text + "\n" + operands_text + "\n" + status_lines() + "\ndocs/abut.md describes scenes.\n";
}

}  // namespace cli
