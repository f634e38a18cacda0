// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <charconv>
#include <string_view>

#include "owned.hpp"

namespace demo {
namespace {

constexpr std::uint32_t most_threads = 1024;

template <class Number>
Number number_between(std::string_view option, std::string_view text, Number low, Number high) {
  Number value = 0;
  const std::string copy(text);
  const auto [end, error] = std::from_chars(copy.data(), std::to_address(copy.end()), value);
  if (text.empty() || error != std::errc{} || end != std::to_address(copy.end()) || value < low || value > high) {
    throw Failure(std::string(option) + " takes a whole number from " + std::to_string(low) + " to " +
                  std::to_string(high) + ", not '" + copy + "'");
  }
  return value;
}

void set_size(Options& options, std::string_view text) {
  const std::size_t times = text.find('x');
  if (times == std::string_view::npos) {
    throw Failure("--size takes a width and a height, such as 1280x720, not '" + std::string(text) + "'");
  }
  options.width = number_between<std::uint32_t>("--size", text.substr(0, times), 64, 8192);
  options.height = number_between<std::uint32_t>("--size", text.substr(times + 1), 64, 8192);
}

void set(Options& options, std::string_view option, std::string_view value) {
  if (option == "--steps") {
    options.steps = number_between<std::uint32_t>(option, value, 1, 100'000);
  } else if (option == "--bodies") {
    options.bodies = number_between<std::uint32_t>(option, value, 1, 20'000);
  } else if (option == "--seed") {
    options.seed = number_between<std::uint64_t>(option, value, 0, UINT64_MAX);
  } else if (option == "--threads") {
    options.threads = number_between<std::uint32_t>(option, value, 0, most_threads);
  } else if (option == "--film") {
    options.every = number_between<std::uint32_t>(option, value, 1, 100'000);
  } else if (option == "--size") {
    set_size(options, value);
  } else if (option == "--data") {
    options.data = value;
  } else if (option == "--out") {
    options.out = value;
  } else {
    throw Failure("there is no option '" + std::string(option) + "'; --help lists them");
  }
}

}  // namespace

Options parse_options(std::span<const std::string> arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--help" || argument == "-h") {
      options.help = true;
      return options;
    }
    if (argument == "--explain") {
      options.explain = true;
    } else if (const std::size_t equals = argument.find('='); equals != std::string::npos) {
      set(options, std::string_view(argument).substr(0, equals), std::string_view(argument).substr(equals + 1));
    } else if (i + 1 < arguments.size()) {
      set(options, argument, arguments[i + 1]);
      ++i;
    } else {
      set(options, argument, "");  // an unknown option is named as such before a missing value is
    }
  }
  if (options.out.empty() || options.data.empty()) {
    throw Failure("--out and --data take the name of a folder");
  }
  return options;
}

const char* usage() {
  return R"(usage: abut-demo [options]

Lays bodies of many shapes on the Jacksboro elevation grid, lets them slide downhill, finds their contacts in
every step, prints counts and times, and writes contacts.csv, cloth.csv, steps.csv and scene.png. A cloth falls on a
bunny beside them.

  --steps N      steps to run, default 120
  --bodies N     bodies to lay out, default 2000
  --seed N       seed of bodies and places, default 1; the same seed gives the same CSV files
  --threads N    threads of a step, default 0 for all of the machine; the CSV files are the same for any number
  --size WxH     size of the picture in pixels, default 1280x720
  --film N       also draw every Nth step, as 1.png, 2.png ... in the folder film of DIR
  --out DIR      where to write, default out
  --data DIR     where jacksboro_dem.pgm and bunny.obj lie, default data
  --explain      also print the plan of the universe after the last step
  --help         print this
)";
}

}  // namespace demo
