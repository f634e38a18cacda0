// SPDX-License-Identifier: Apache-2.0
#include "abut/abut.h"
#include "help.hpp"

namespace cli {
namespace {

// A text in which nothing is a command of man.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c == '-' ? "\\-" : c == '\\' ? "\\e" : c == '\'' ? "\\(aq" : std::string(1, c);
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

// A term in bold, what stands after it in italics, and its text.
std::string entry(std::string_view term, std::string_view after, std::string_view text) {
  return ".TP\n\\fB" + plain(term) + "\\fR" + (after.empty() ? "" : " \\fI" + plain(after) + "\\fR") + "\n" +
         plain(text) + ".\n";
}

constexpr const char* description =
    "abut steps a scene that is written as JSON and tells which geometries touch, where and how deep.\n"
    "\\fISCENE\\fR is a file, or \\- for the standard input; files that it names lie beside it, or in the working "
    "folder.\n"
    "\\fIA\\fR and \\fIB\\fR are a part of the scene, or \\fIPART/GEOMETRY\\fR.\n"
    "Without a scene, distance takes two shapes as JSON, or objects with a shape and a pose.\n";

constexpr const char* examples =
    ".EX\n"
    "abut run scene.json \\-\\-contacts contacts.csv\n"
    "abut check scene.json crate ground\n"
    "abut distance \\(aq{\"kind\": \"sphere\", \"radius\": 1}\\(aq \\\\\n"
    "  \\(aq{\"shape\": {\"kind\": \"box\", \"half\": [1, 1, 1]}, \"pose\": {\"position\": [0, 0, 3]}}\\(aq\n"
    "abut run \\- < scene.json\n"
    ".EE\n";

}  // namespace

std::string manual_page() {
  std::string text = ".\\\" SPDX-License-Identifier: Apache-2.0\n.TH ABUT 1 \"\" \"abut " +
                     std::string(abut_version_string()) +
                     "\" \"User Commands\"\n.SH NAME\nabut \\- find where 3D shapes touch\n.SH SYNOPSIS\n"
                     ".B abut\n.I command\n.RI [ arguments ]\n.RI [ options ]\n.SH DESCRIPTION\n";
  text += std::string(description) + ".SH COMMANDS\n";
  for (const CommandRow& row : all_commands()) {
    text += entry(row.words, row.operands, row.help);
    if (!row.options.empty()) {
      text += "Options: " + plain(row.options) + ".\n";
    }
  }
  text += ".SH OPTIONS\n";
  for (const OptionRow& option : all_options()) {
    text += entry(option.name, option.value, option.help);
  }
  text += ".SH EXIT STATUS\n";
  for (const StatusRow& row : all_statuses()) {
    text += entry(row.status, "", row.meaning);
  }
  return text + ".SH EXAMPLES\n" + examples;
}

}  // namespace cli
