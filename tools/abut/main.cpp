// SPDX-License-Identifier: Apache-2.0
// abut: where shapes touch, for scenes that are written as JSON; help_text() says what it does.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "check.hpp"
#include "commands.hpp"
#include "distance.hpp"
#include "explain.hpp"
#include "explain_pair.hpp"
#include "failures.hpp"
#include "help.hpp"
#include "interruption.hpp"
#include "lean.hpp"
#include "output_file.hpp"
#include "pairs.hpp"
#include "picture.hpp"
#include "report.hpp"
#include "tune.hpp"

namespace cli {
namespace {

Status obey(const Arguments& arguments) {
  switch (arguments.command) {
    case Command::help: print(help_text(arguments.about)); break;
    case Command::version: print("abut " + std::string(abut_version_string()) + "\n"); break;
    case Command::shapes: list_shapes(arguments); break;
    case Command::run: run(arguments); break;
    case Command::explain: explain(arguments); break;
    case Command::explain_pair: explain_pair(arguments); break;
    case Command::check: return check_scene(arguments) ? Status::odd : Status::done;
    case Command::distance: print_distance(arguments); break;
    case Command::pairs: list_pairs(arguments); break;
    case Command::picture: draw_scene(arguments); break;
    case Command::lean: print_lean_build(arguments); break;
    case Command::plot: return plot(arguments);
    case Command::report: return report(arguments);
    case Command::tune: tune(arguments); break;
    case Command::completion: print(completion_for(arguments.operands[0])); break;
    case Command::manual: print(manual_page()); break;
  }
  return Status::done;
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
    return static_cast<int>(cli::obey(parsed));
  } catch (const cli::BadInput& failure) {
    return cli::failed(Status::bad_input, failure.what());
  } catch (const cli::BadOutput& failure) {
    return cli::failed(Status::bad_output, failure.what());
  } catch (const cli::Interrupted& failure) {
    return cli::failed(Status::interrupted, failure.what());
  } catch (const std::exception& failure) {
    return cli::failed(Status::library_failed, failure.what());
  }
}
