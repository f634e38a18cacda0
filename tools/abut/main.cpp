// SPDX-License-Identifier: Apache-2.0
// abut: steps a scene that is written as JSON; see usage() for what it does.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "commands.hpp"
#include "explain_pair.hpp"
#include "failures.hpp"
#include "output_file.hpp"

namespace cli {
namespace {

void obey(const Arguments& arguments) {
  switch (arguments.command) {
    case Command::help: print(usage()); break;
    case Command::version: print("abut " + std::string(abut_version_string()) + "\n"); break;
    case Command::shapes: list_shapes(arguments); break;
    case Command::run: run(arguments); break;
    case Command::explain: explain(arguments); break;
    case Command::explain_pair: explain_pair(arguments); break;
  }
}

int failed(Status status, const char* message) {
  std::fprintf(stderr, "abut: %s\n", message);
  return static_cast<int>(status);
}

}  // namespace
}  // namespace cli

int main(int argc, char** argv) {
  using cli::Status;
  try {
    std::vector<const char*> words(static_cast<std::size_t>(argc));
    std::copy_n(argv, words.size(), words.begin());
    const std::vector<std::string> arguments(words.begin() + (words.empty() ? 0 : 1), words.end());
    const cli::Arguments parsed = cli::parse_arguments(arguments);
    cli::check(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR),
               "this program needs another version of abut");
    cli::obey(parsed);
    return static_cast<int>(Status::done);
  } catch (const cli::BadInput& failure) {
    return cli::failed(Status::bad_input, failure.what());
  } catch (const cli::BadOutput& failure) {
    return cli::failed(Status::bad_output, failure.what());
  } catch (const std::exception& failure) {
    return cli::failed(Status::library_failed, failure.what());
  }
}
