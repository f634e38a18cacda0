// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "failures.hpp"
#include "help.hpp"
#include "nearest.hpp"

namespace cli {
namespace {

// What may stand after a first word: the rest of longer commands, such as "pair", and all options, each once.
struct After {
  std::vector<std::string> words;
  std::vector<OptionRow> options;
};

After after(const std::string& first) {
  After its;
  for (const CommandRow& row : all_commands()) {
    const std::vector<std::string> words = split(row.words);
    if (words.front() != first) {
      continue;
    }
    its.words.insert(its.words.end(), words.begin() + 1, words.end());
    if (row.operands == "SHELL") {
      its.words.insert(its.words.end(), {"bash", "zsh", "fish"});
    }
    for (const OptionRow& option : options_of(row)) {
      if (std::ranges::find(its.options, option.name, &OptionRow::name) == its.options.end()) {
        its.options.push_back(option);
      }
    }
  }
  return its;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

std::string names_of(const std::vector<OptionRow>& options) {
  std::vector<std::string> names;
  for (const OptionRow& option : options) {
    names.emplace_back(option.name);
  }
  return joined(names);
}

// Options of which a file stands after them, or of which anything else does.
std::string names_with_value(bool files) {
  std::string text;
  for (const OptionRow& option : all_options()) {
    if (!option.value.empty() && (option.value == "FILE") == files) {
      text += (text.empty() ? "" : "|") + std::string(option.name);
    }
  }
  return text;
}

// The help of a first word that begins several commands is that of the first of them.
std::string_view help_of(const std::string& first) {
  const auto rows = all_commands();
  return std::ranges::find_if(rows, [&](const CommandRow& row) { return split(row.words).front() == first; })->help;
}

// For use between single quotes, with a backslash before each of some letters.
std::string quoted(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    out += c == '\'' ? "'\\''" : special.find(c) != std::string_view::npos ? std::string("\\") + c : std::string(1, c);
  }
  return out;
}

std::string for_bash() {
  std::string text =
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# Completion of abut for bash.\n"
      "_abut() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} words=\n"
      "  COMPREPLY=()\n"
      "  case ${COMP_WORDS[COMP_CWORD - 1]} in\n"
      "    " +
      names_with_value(true) + ") compopt -o filenames; COMPREPLY=($(compgen -f -- \"$current\")); return ;;\n    " +
      names_with_value(false) +
      ") return ;;\n  esac\n  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W \"" +
      joined(first_words()) + "\" -- \"$current\"))\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const std::string& first : first_words()) {
    const After its = after(first);
    text += "    " + first + ") words=\"" + joined(its.words) + (its.words.empty() ? "" : " ") + names_of(its.options) +
            (its.options.empty() ? "" : " --help") + "\" ;;\n";
  }
  return text +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  if [[ $current != -* ]]; then\n"
         "    compopt -o filenames\n"
         "    COMPREPLY+=($(compgen -f -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -F _abut abut\n";
}

std::string for_zsh() {
  std::string text =
      "#compdef abut\n"
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# Completion of abut for zsh.\n"
      "_abut() {\n"
      "  local -a commands=(\n";
  for (const std::string& first : first_words()) {
    text += "    '" + quoted(first, ":") + ":" + quoted(help_of(first), ":") + "'\n";
  }
  text +=
      "  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $command in\n";
  for (const std::string& first : first_words()) {
    const After its = after(first);
    text += "    " + first + ")\n      _arguments '--help[prints what the command takes]'";
    for (const OptionRow& option : its.options) {
      const std::string value(option.value);
      text += " \\\n        '" + std::string(option.name) + "[" + quoted(option.help, "[]:") + "]" +
              (value.empty() ? "" : ":" + value + ":" + (value == "FILE" ? "_files" : " ")) + "'";
    }
    text += (its.words.empty() ? ""
                               : " \\\n        '1:word:_alternative \"words:word:(" + joined(its.words) +
                                     ")\" \"files:file:_files\"'");
    text += " \\\n        '*:file:_files' ;;\n";
  }
  return text +
         "  esac\n"
         "}\n"
         "if [ \"$funcstack[1]\" = _abut ]; then\n"
         "  _abut \"$@\"\n"
         "else\n"
         "  compdef _abut abut\n"
         "fi\n";
}

std::string for_fish() {
  std::string text =
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# Completion of abut for fish.\n";
  for (const std::string& first : first_words()) {
    text += "complete -c abut -f -n __fish_use_subcommand -a '" + first + "' -d '" + quoted(help_of(first), "") + "'\n";
    const After its = after(first);
    const std::string seen = "complete -c abut -n '__fish_seen_subcommand_from " + first + "' ";
    if (!its.words.empty()) {
      text += seen + "-a '" + joined(its.words) + "'\n";
    }
    for (const OptionRow& option : its.options) {
      const char* value = option.value.empty() ? "" : option.value == "FILE" ? " -r -F" : " -x";
      text += seen + "-l " + std::string(option.name.substr(2)) + value + " -d '" + quoted(option.help, "") + "'\n";
    }
  }
  return text;
}

}  // namespace

std::string completion_for(const std::string& shell) {
  if (shell == "bash") {
    return for_bash();
  }
  if (shell == "zsh") {
    return for_zsh();
  }
  if (shell == "fish") {
    return for_fish();
  }
  const std::array<std::string, 3> known{"bash", "zsh", "fish"};
  throw BadInput("there is no completion for '" + shell + "'; there are: " + listing(known) + suggestion(shell, known));
}

}  // namespace cli
