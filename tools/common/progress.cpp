// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <cstdio>
#include <utility>

#include <unistd.h>

namespace tools {

Progress::Progress(std::string what, std::uint64_t total, Elsewhere elsewhere)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      lines_(elsewhere == Elsewhere::lines),
      start_(std::chrono::steady_clock::now()) {}

void Progress::show(std::uint64_t done) {
  const std::uint64_t percent = total_ > 0 ? 100 * done / total_ : 100;
  if (percent == shown_percent_) {
    return;
  }
  if (terminal_) {
    constexpr std::uint64_t width = 40;
    const std::uint64_t filled = width * percent / 100;
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    std::fprintf(stderr, "\r%-16s [%s] %3u%%", what_.c_str(), bar.c_str(), static_cast<unsigned>(percent));
  } else if (lines_ && (shown_percent_ == UINT64_MAX || percent / 25 != shown_percent_ / 25)) {
    std::fprintf(stderr, "%s: %u%%\n", what_.c_str(), static_cast<unsigned>(percent));
  }
  shown_percent_ = percent;
}

void Progress::finish() {
  show(total_);
  if (terminal_) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    std::fprintf(stderr, " %.1f s\n", seconds.count());
  }
}

void Progress::stop() const {
  if (terminal_) {
    std::fputc('\n', stderr);
  }
}

}  // namespace tools
