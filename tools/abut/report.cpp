// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cli {
namespace {

// The exit status of a program that is run to its end.
int status_of(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> argv;
  for (std::string& word : copies) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  pid_t child = 0;
  if (const int error = posix_spawn(&child, argv.front(), nullptr, nullptr, argv.data(), environ); error != 0) {
    throw BadInput(words.front() + " cannot be run: " + std::generic_category().message(error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status)) {
    throw Failure("drawing ended by a signal");
  }
  return WEXITSTATUS(status);
}

// The first Python in PATH that can draw. Others may come before that of the distribution, which has the packages.
std::string drawing_python() {
  const char* const given = std::getenv("PATH");
  const std::string path = given == nullptr ? "" : given;
  std::istringstream folders(path);
  bool has_any = false;
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string python = (std::filesystem::path(folder) / "python3").string();
    if (access(python.c_str(), X_OK) != 0) {
      continue;
    }
    has_any = true;
    constexpr const char* tries =
        "import importlib.util, sys\n"
        "sys.exit(0 if all(importlib.util.find_spec(name) for name in ('jinja2', 'matplotlib')) else 1)";
    if (status_of({python, "-c", tries}) == 0) {
      return python;
    }
  }
  throw BadInput(has_any ? "no python3 in PATH has Matplotlib and Jinja2, which draw; Debian has them in "
                           "python3-matplotlib and python3-jinja2"
                         : "drawing needs python3, of which PATH, '" + path + "', has none");
}

std::string drawing_program(const char* name) {
  std::error_code none;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path found = (own.parent_path() / ABUT_REPORT_FOLDER / name).lexically_normal();
  if (!std::filesystem::exists(found, none)) {
    throw BadInput(found.string() + " is missing, which draws; it is installed with this program");
  }
  return found.string();
}

// Programs that draw tell by themselves what they were given wrong.
Status status_of_drawing(const std::vector<std::string>& words) {
  switch (status_of(words)) {
    case 0: return Status::done;
    case 1: return Status::odd;
    case 2: return Status::bad_input;
    default: throw Failure("nothing could be drawn");
  }
}

}  // namespace

Status report(const Arguments& arguments) {
  std::vector<std::string> words{drawing_python(), "-B", drawing_program("report.py")};
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) {
      words.insert(words.end(), {option, value});
    }
  };
  if (!arguments.operands.empty()) {
    add("--from", arguments.operands.front());
  }
  if (arguments.quick) {
    words.emplace_back("--quick");
  }
  add("--build", arguments.build);
  add("--compare", arguments.compare);
  add("--out", arguments.out);
  return status_of_drawing(words);
}

Status plot(const Arguments& arguments) {
  return status_of_drawing(
      {drawing_python(), "-B", drawing_program("plot.py"), arguments.operands[0], arguments.operands[1]});
}

}  // namespace cli
