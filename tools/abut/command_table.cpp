// SPDX-License-Identifier: Apache-2.0
#include "command_table.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace cli {
namespace {

constexpr std::string_view stepping = "--steps --dt --threads --json";

constexpr std::array<CommandRow, 16> rows{
    {{Command::run, "run", "SCENE", "steps a scene, writes contacts and events, prints counts and times",
      "--steps --dt --threads --contacts --elements --events --states --motion --quiet --json"},
     {Command::explain, "explain", "SCENE", "steps a scene, prints what the last step did and why", stepping},
     {Command::explain_pair, "explain pair", "SCENE A B",
      "prints every way to a distance, with times, and what a budget takes",
      "--steps --dt --threads --error-bound --time-budget --routes --json"},
     {Command::check, "check", "SCENE [A B]", "tells what is odd about a scene, or why A and B touch or not", stepping},
     {Command::distance, "distance", "[SCENE] A B", "prints the distance of A and B, its interval and its points",
      stepping},
     {Command::pairs, "pairs", "[SCENE]", "lists pairs that come near in a scene; without one, which kinds meet",
      stepping},
     {Command::picture, "picture", "SCENE PICTURE", "draws a scene and its contacts as a PNG",
      "--steps --dt --threads --size --from --to --up"},
     {Command::lean, "lean", "SCENE", "prints the line that configures the build a scene needs", "--json"},
     {Command::plot, "plot", "MOTION PICTURE", "draws energy, overlap and residual over time, which run --motion wrote",
      ""},
     {Command::report, "report", "[REPORT]", "draws errors and times as a page; without a report, measures first",
      "--quick --build --compare --out"},
     {Command::tune, "tune", "[FILE]", "measures this machine for time budgets, in some 10 seconds", ""},
     {Command::shapes, "shapes", "", "lists the kinds of shapes and their parameters", "--json"},
     {Command::completion, "completion", "SHELL", "prints completion for bash, zsh or fish", ""},
     {Command::manual, "manual", "", "prints the manual page, for man -l -", ""},
     {Command::help, "--help", "", "prints this text; after a command, what that command takes", ""},
     {Command::version, "--version", "", "prints the version", ""}}};

constexpr std::array<OptionRow, 21> options{
    {{"--steps", "N", "steps to run; without it those of the scene for run, 1 for all others"},
     {"--dt", "S", "time from step to step; without it that of the scene"},
     {"--threads", "N", "threads of a step, 0 for all; results are the same bits for any number"},
     {"--contacts", "FILE",
      "writes the contacts of all steps; JSON if the name ends in .json, else CSV; - is the standard output"},
     {"--elements", "FILE",
      "writes vertices, edges and faces that are near, of pairs with the detail elements, the same way"},
     {"--events", "FILE", "writes the events of all steps in the same way"},
     {"--states", "FILE",
      "writes poses and velocities of bodies after each step, of scenes with a response, the same way"},
     {"--motion", "FILE",
      "writes energy, momentum, the deepest overlap and the worst residual of each step, the same way"},
     {"--size", "WxH", "width and height of a picture; without it 1280x720"},
     {"--from", "X,Y,Z", "where the camera of a picture stands; without it so that all fits in"},
     {"--to", "X,Y,Z", "where it looks to; without it to the middle of the scene"},
     {"--up", "X,Y,Z", "what is up in the picture; without it 0,0,1"},
     {"--error-bound", "E", "the error bound of options, relative to the size of the shapes; without it the default"},
     {"--time-budget", "S", "the time budget of options, in seconds for one question; without it none"},
     {"--routes", "FILE", "a table that abut tune wrote, in place of the one that abut comes with"},
     {"--quick", "", "measures few cases for a report, at most 3 minutes"},
     {"--build", "FOLDER", "the build whose benchmarks a report runs; without it build/release of the sources"},
     {"--compare", "FILE", "prints what got slower or less exact since this report.json"},
     {"--out", "FOLDER", "where index.html and report.json of a report go; without it beside REPORT, or out/report"},
     {"--quiet", "", "neither progress nor the table at the end"},
     {"--json", "", "prints JSON; what goes to - is JSON as well"}}};

constexpr std::array<StatusRow, 6> statuses{{{"0", "done"},
                                             {"1", "the arguments or the scene are wrong"},
                                             {"2", "abut failed on a scene that it had taken, or memory ran out"},
                                             {"3", "a file or the standard output could not be written"},
                                             {"4", "check found something odd, or report something worse"},
                                             {"130", "a signal ended it; files are as they were before"}}};

}  // namespace

std::span<const CommandRow> all_commands() { return rows; }

std::span<const OptionRow> all_options() { return options; }

std::span<const StatusRow> all_statuses() { return statuses; }

const CommandRow& row_of(Command command) {
  return *std::find_if(rows.begin(), rows.end(), [&](const CommandRow& row) { return row.command == command; });
}

std::vector<OptionRow> options_of(const CommandRow& row) {
  const std::vector<std::string> names = split(row.options);
  std::vector<OptionRow> its;
  std::ranges::copy_if(options, std::back_inserter(its),
                       [&](const OptionRow& option) { return std::ranges::find(names, option.name) != names.end(); });
  return its;
}

std::vector<std::string> first_words() {
  std::vector<std::string> words;
  for (const CommandRow& row : rows) {
    const std::string first = split(row.words).front();
    if (std::ranges::find(words, first) == words.end()) {
      words.push_back(first);
    }
  }
  return words;
}

std::vector<std::string> split(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace cli
