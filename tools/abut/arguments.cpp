// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "failures.hpp"

namespace cli {
namespace {

template <class Number>
Number number_from(const std::string& option, const std::string& text, Number low, Number high, const char* expected) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), std::to_address(text.end()), value);
  if (text.empty() || error != std::errc{} || end != std::to_address(text.end()) || !(value >= low) ||
      !(value <= high)) {
    throw BadInput(option + " is '" + text + "'; expected " + expected);
  }
  return value;
}

void set(Arguments& arguments, const std::string& option, const std::string& value) {
  if (option == "--steps") {
    arguments.steps =
        number_from<std::uint64_t>(option, value, 1, 1'000'000'000, "a whole number from 1 to 1000000000");
  } else if (option == "--dt") {
    arguments.dt = number_from<double>(option, value, 0.0, 1e300, "a number that is not negative");
  } else if (option == "--threads") {
    arguments.threads = number_from<std::uint32_t>(option, value, 0, 1024, "a whole number from 0 to 1024");
  } else if (option == "--contacts") {
    arguments.contacts = value;
  } else {
    arguments.events = value;
  }
}

bool takes_value(Command command, const std::string& option) {
  const bool is_run = command == Command::run;
  const bool is_step = is_run || command == Command::explain || command == Command::explain_pair;
  return (is_step && (option == "--steps" || option == "--dt" || option == "--threads")) ||
         (is_run && (option == "--contacts" || option == "--events"));
}

Command command_of(const std::string& word) {
  constexpr std::array<std::pair<std::string_view, Command>, 8> commands{{{"run", Command::run},
                                                                          {"explain", Command::explain},
                                                                          {"shapes", Command::shapes},
                                                                          {"help", Command::help},
                                                                          {"--help", Command::help},
                                                                          {"-h", Command::help},
                                                                          {"version", Command::version},
                                                                          {"--version", Command::version}}};
  for (const auto& [name, command] : commands) {
    if (word == name) {
      return command;
    }
  }
  throw BadInput("there is no command '" + word + "'; expected run, explain, shapes, --help or --version");
}

// An option with its value, which may stand in the same word after '='. Answers how many words it took.
std::size_t read_option(Arguments& arguments, std::span<const std::string> words) {
  const std::string& word = words.front();
  const std::size_t equals = word.find('=');
  const std::string option = word.substr(0, equals);
  if (word == "--json" && arguments.command != Command::help && arguments.command != Command::version) {
    arguments.json = true;
    return 1;
  }
  if (word == "--quiet" && arguments.command == Command::run) {
    arguments.quiet = true;
    return 1;
  }
  if (!takes_value(arguments.command, option)) {
    throw BadInput("there is no option '" + option + "' here; --help lists them");
  }
  const bool inside = equals != std::string::npos;
  if (!inside && words.size() < 2) {
    throw BadInput(option + " needs a value");
  }
  const std::string value = inside ? word.substr(equals + 1) : words[1];
  if (value.empty()) {
    throw BadInput(option + " is ''; expected a value");
  }
  set(arguments, option, value);
  return inside ? 1 : 2;
}

// Whichever way it is written.
bool is_same_file(const std::string& a, const std::string& b) {
  // Absolute first: of a relative path that does not exist nothing is canonical.
  const auto canonical = [](const std::string& path) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
  };
  return a == b || (!b.empty() && canonical(a) == canonical(b));
}

bool takes_scene(Command command) {
  return command == Command::run || command == Command::explain || command == Command::explain_pair;
}

void read_word(Arguments& arguments, const std::string& word) {
  const bool takes_pair = arguments.command == Command::explain_pair;
  if (takes_scene(arguments.command) && arguments.scene.empty()) {
    arguments.scene = word;
  } else if (takes_pair && arguments.geometry_a.empty()) {
    arguments.geometry_a = word;
  } else if (takes_pair && arguments.geometry_b.empty()) {
    arguments.geometry_b = word;
  } else {
    throw BadInput("'" + word + "' is one argument too many");
  }
}

void check_whole(const Arguments& arguments) {
  if (takes_scene(arguments.command) && arguments.scene.empty()) {
    throw BadInput("no scene is given; expected the name of a file");
  }
  if (arguments.command == Command::explain_pair && arguments.geometry_b.empty()) {
    throw BadInput("a pair needs two geometries; expected the names of parts, or PART/GEOMETRY");
  }
  if (!arguments.contacts.empty() && is_same_file(arguments.contacts, arguments.events)) {
    throw BadInput("--contacts and --events are both '" + arguments.events + "'; expected different files");
  }
}

}  // namespace

Arguments parse_arguments(std::span<const std::string> words) {
  Arguments arguments;
  if (words.empty()) {
    throw BadInput("no command is given; expected run, explain, shapes, --help or --version");
  }
  arguments.command = command_of(words.front());
  std::size_t first = 1;
  if (arguments.command == Command::explain && words.size() > 1 && words[1] == "pair") {
    arguments.command = Command::explain_pair;
    first = 2;
  }
  for (std::size_t i = first; i < words.size();) {
    if (words[i] == "--help" || words[i] == "-h") {
      arguments.command = Command::help;
      return arguments;
    }
    if (words[i].starts_with("-")) {
      i += read_option(arguments, words.subspan(i));
      continue;
    }
    read_word(arguments, words[i]);
    ++i;
  }
  check_whole(arguments);
  return arguments;
}

const char* usage() {
  return R"(usage: abut run SCENE.json [options]      steps a scene, writes contacts and events
       abut explain SCENE.json [options]  steps a scene, prints what the last step did and why
       abut explain pair SCENE.json A B   steps a scene, prints every way to the distance of two of its geometries,
                                          with bounds and times; each is a PART, or PART/GEOMETRY
       abut shapes [--json]               lists the kinds of shapes and their parameters
       abut --help | --version

  --steps N         steps to run; default: that of the scene, which is 1 if it says nothing
                    (explain: 1)
  --dt S            time from step to step; default: that of the scene, or 0.01
  --threads N       threads of a step, 0 for all; default: that of the scene, or 1; results are the same for any number
  --contacts FILE   writes the contacts of all steps; JSON if the name ends in .json, else CSV; - is the standard output
  --events FILE     writes the events of all steps in the same way
  --quiet           neither progress nor the table at the end
  --json            the table (run), the plan or the pair (explain), the kinds (shapes), and what goes to - as JSON

Exit status: 0 done; 1 the arguments or the scene are wrong; 2 abut failed, or memory ran out; 3 a file could not be
written. A file has its name only when it is complete. docs/abut.md describes scenes.
)";
}

}  // namespace cli
