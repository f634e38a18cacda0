// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include "failures.hpp"
#include "nearest.hpp"

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

// Numbers with a separator between them.
template <class Number>
std::vector<Number> numbers_from(const std::string& option, const std::string& text, char separator, std::size_t count,
                                 Number low, Number high, const char* expected) {
  std::vector<Number> numbers;
  std::istringstream words(text + separator);
  for (std::string word; std::getline(words, word, separator);) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), std::to_address(word.end()), value);
    if (error != std::errc{} || end != std::to_address(word.end()) || !(value >= low) || !(value <= high)) {
      numbers.clear();
      break;
    }
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    throw BadInput(option + " is '" + text + "'; expected " + expected);
  }
  return numbers;
}

abut_vec3 vector_from(const std::string& option, const std::string& text) {
  constexpr double most = 1e60;
  const auto numbers = numbers_from<double>(option, text, ',', 3, -most, most, "three numbers, such as 1,-2,0.5");
  return {numbers[0], numbers[1], numbers[2]};
}

void set_view(Arguments& arguments, const std::string& option, const std::string& value) {
  if (option == "--size") {
    const auto size = numbers_from<std::uint32_t>(option, value, 'x', 2, 1, 16384,
                                                  "a width and a height from 1 to 16384, such as 1280x720");
    arguments.width = size[0];
    arguments.height = size[1];
  } else if (option == "--from") {
    arguments.from = vector_from(option, value);
  } else if (option == "--to") {
    arguments.to = vector_from(option, value);
  } else if (option == "--up") {
    arguments.up = vector_from(option, value);
  }
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
  } else if (option == "--elements") {
    arguments.elements = value;
  } else if (option == "--events") {
    arguments.events = value;
  } else if (option == "--states") {
    arguments.states = value;
  } else if (option == "--motion") {
    arguments.motion = value;
  } else if (option == "--error-bound") {
    arguments.error_bound = number_from<double>(option, value, 0.0, 1e60, "a number that is not negative");
  } else if (option == "--time-budget") {
    arguments.time_budget =
        number_from<double>(option, value, 0.0, 1e60, "seconds that are not negative, such as 1e-6");
  } else if (option == "--routes") {
    arguments.routes = value;
  } else if (option == "--build") {
    arguments.build = value;
  } else if (option == "--compare") {
    arguments.compare = value;
  } else if (option == "--out") {
    arguments.out = value;
  } else {
    set_view(arguments, option, value);
  }
}

void set_flag(Arguments& arguments, const std::string& option) {
  arguments.json = arguments.json || option == "--json";
  arguments.quick = arguments.quick || option == "--quick";
  arguments.quiet = arguments.quiet || option == "--quiet";
}

// The command of the first words, and how many these are. Of two that fit the one of more words is meant.
const CommandRow& command_of(std::span<const std::string> words) {
  const CommandRow* found = nullptr;
  for (const CommandRow& row : all_commands()) {
    const std::vector<std::string> its = split(row.words);
    if (its.size() <= words.size() && std::equal(its.begin(), its.end(), words.begin()) &&
        (found == nullptr || its.size() > split(found->words).size())) {
      found = &row;
    }
  }
  if (found == nullptr) {
    const std::vector<std::string> known = first_words();
    throw BadInput("there is no command '" + words.front() + "'; there are: " + listing(known) +
                   suggestion(words.front(), known));
  }
  return *found;
}

[[noreturn]] void refuse_option(const CommandRow& row, const std::string& option) {
  std::vector<std::string> known;
  for (const OptionRow& each : options_of(row)) {
    known.emplace_back(each.name);
  }
  const std::string its = known.empty() ? "; it takes none" : "; it takes: " + listing(known);
  throw BadInput(std::string(row.words) + " has no option '" + option + "'" + its + suggestion(option, known));
}

// An option with its value, which may stand in the same word after '='. Answers how many words it took.
std::size_t read_option(Arguments& arguments, const CommandRow& row, std::span<const std::string> words) {
  const std::string& word = words.front();
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const std::vector<OptionRow> its = options_of(row);
  const auto found = std::ranges::find(its, name, &OptionRow::name);
  if (found == its.end()) {
    refuse_option(row, name);
  }
  const bool inside = equals != std::string::npos;
  if (found->value.empty()) {
    if (inside) {
      throw BadInput(name + " takes no value; expected it without '" + word.substr(equals) + "'");
    }
    set_flag(arguments, name);
    return 1;
  }
  if (!inside && words.size() < 2) {
    throw BadInput(name + " needs a value, " + std::string(found->value));
  }
  const std::string value = inside ? word.substr(equals + 1) : words[1];
  if (value.empty()) {
    throw BadInput(name + " is ''; expected a value, " + std::string(found->value));
  }
  set(arguments, name, value);
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

// As many as all of them, or as those outside of brackets.
void check_operands(const CommandRow& row, const std::vector<std::string>& operands) {
  std::size_t least = 0, most = 0;
  bool optional = false;
  for (const std::string& word : split(row.operands)) {
    optional = optional || word.front() == '[';
    least += optional ? 0 : 1;
    ++most;
    optional = optional && word.back() != ']';
  }
  if (operands.size() > most) {
    throw BadInput("'" + operands[most] + "' is one argument too many; expected abut " + std::string(row.words) +
                   (most > 0 ? " " : " alone") + std::string(row.operands));
  }
  if (operands.size() != least && operands.size() != most) {
    const std::string given = operands.empty()       ? "no argument is given"
                              : operands.size() == 1 ? "1 argument is given"
                                                     : std::to_string(operands.size()) + " arguments are given";
    throw BadInput(given + "; expected abut " + std::string(row.words) + " " + std::string(row.operands));
  }
}

void check_different(const char* option, const std::string& file, const char* other, const std::string& other_file) {
  if (!file.empty() && is_same_file(file, other_file)) {
    throw BadInput(std::string(option) + " and " + other + " are both '" + other_file + "'; expected different files");
  }
}

void check_whole(const CommandRow& row, const Arguments& arguments) {
  check_operands(row, arguments.operands);
  const std::array<std::pair<const char*, const std::string*>, 5> outputs{{{"--contacts", &arguments.contacts},
                                                                           {"--elements", &arguments.elements},
                                                                           {"--events", &arguments.events},
                                                                           {"--states", &arguments.states},
                                                                           {"--motion", &arguments.motion}}};
  for (auto one = outputs.begin(); one != outputs.end(); ++one) {
    for (auto other = std::next(one); other != outputs.end(); ++other) {
      check_different(one->first, *one->second, other->first, *other->second);
    }
  }
}

}  // namespace

Arguments parse_arguments(std::span<const std::string> words) {
  if (words.empty()) {
    throw BadInput("no command is given; there are: " + listing(first_words()));
  }
  if (words.front() == "-h" || words.front() == "help") {
    return {};
  }
  const CommandRow& row = command_of(words);
  Arguments arguments;
  arguments.command = row.command;
  bool options_end = false;
  for (std::size_t i = split(row.words).size(); i < words.size();) {
    const std::string& word = words[i];
    if (!options_end && (word == "--help" || word == "-h")) {
      Arguments help;
      help.about = row.command;
      return help;
    }
    if (!options_end && word == "--") {
      options_end = true;
      ++i;
    } else if (!options_end && word.starts_with("-") && word != "-") {
      i += read_option(arguments, row, words.subspan(i));
    } else {
      arguments.operands.push_back(word);
      ++i;
    }
  }
  check_whole(row, arguments);
  return arguments;
}

}  // namespace cli
