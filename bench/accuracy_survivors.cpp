// SPDX-License-Identifier: Apache-2.0
#include "accuracy_survivors.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <numeric>
#include <span>
#include <stdexcept>

namespace bench {
namespace {

// An answer that takes longer than this never comes.
constexpr unsigned most_seconds = 20;

// In the child: what the assertion has to say would only be in the way.
[[noreturn]] void try_all(const Entrant& entrant, Query query, const Cell& cell) {
  dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
  alarm(most_seconds);
  std::vector<Answer> answers(cell.cases.size());
  entrant.make(query, cell)->answer(answers);
  _exit(EXIT_SUCCESS);
}

bool survives(const Entrant& entrant, Query query, const Cell& cell) {
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("no process can be made");
  }
  if (child == 0) {
    try_all(entrant, query, cell);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

}  // namespace

std::vector<std::size_t> survivors(const Entrant& entrant, Query query, const Cell& cell) {
  std::vector<std::size_t> list(cell.cases.size());
  std::iota(list.begin(), list.end(), std::size_t{0});
  if (!survives(entrant, query, cell)) {
    std::erase_if(list, [&](std::size_t i) {
      return !survives(entrant, query, {cell.solids_a, cell.solids_b, cell.cases.subspan(i, 1)});
    });
  }
  return list;
}

}  // namespace bench
