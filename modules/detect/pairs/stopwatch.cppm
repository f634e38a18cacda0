// SPDX-License-Identifier: Apache-2.0
// Microseconds between two points of a program.
export module abut.detect.pairs.stopwatch;
import abut.core.standard;

export namespace abut {

class Stopwatch {
 public:
  // One that does not run looks at no clock and answers zero.
  explicit Stopwatch(bool is_running = true) : is_running_(is_running) {
    if (is_running_) {
      last_ = std::chrono::steady_clock::now();
    }
  }

  // Since it was made or read last.
  [[nodiscard]] double lap() {
    if (!is_running_) {
      return 0;
    }
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::micro> passed = now - std::exchange(last_, now);
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_;
  bool is_running_;
};

}  // namespace abut
