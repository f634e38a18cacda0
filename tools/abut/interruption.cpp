// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <array>
#include <atomic>
#include <string>

namespace cli {
namespace {

constexpr std::array<int, 3> watched{SIGINT, SIGTERM, SIGHUP};

// Of the process, as signals are.
constinit std::atomic<int> received = 0;
static_assert(std::atomic<int>::is_always_lock_free, "handlers of signals may not wait");

void receive(int signal) { received = signal; }

const char* name_of(int signal) {
  switch (signal) {
    case SIGINT: return "SIGINT (Ctrl-C)";
    case SIGTERM: return "SIGTERM";
    default: return "SIGHUP";
  }
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  for (const int signal : watched) {
    struct sigaction now{};
    sigaction(signal, nullptr, &now);
    // What the caller had this program ignore, as nohup does, stays ignored.
    if (now.sa_handler != SIG_IGN) {
      handle(signal, receive, SA_RESTART | static_cast<int>(SA_RESETHAND));
    }
  }
  handle(SIGPIPE, SIG_IGN, 0);
}

Interruption::~Interruption() {
  for (const int signal : watched) {
    struct sigaction now{};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == receive) {
      handle(signal, SIG_DFL, 0);
    }
  }
  handle(SIGPIPE, SIG_DFL, 0);
}

bool Interruption::has_come() const { return received != 0; }

void Interruption::check(std::uint64_t step, std::uint64_t steps) const {
  if (has_come()) {
    throw Interrupted("ended by " + std::string(name_of(received)) + " after step " + std::to_string(step) + " of " +
                      std::to_string(steps) + "; files are as they were before");
  }
}

}  // namespace cli
